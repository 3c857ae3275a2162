// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The core of the page: the program topple in WebAssembly, in a worker made of what the page carries. */

import carried from "topple:core";
import { Requests } from "./requests.js";
import { say } from "../words/language.js";

export { CoreStopped } from "./requests.js";

const REST_LATE_MS = 300; // behind the first answer, which is drawn meanwhile

/** Compiled once for all cores of the page, since before this began (page/carry.js). */
const compiled = globalThis.toppleCore;

/** @param {(message: object) => void} heard */
function startWorker(heard) {
  const address = URL.createObjectURL(new Blob([carried.worker], { type: "text/javascript" }));
  const worker = new Worker(address);
  const broken = (error) => heard({ kind: "broken", why: String(error) });
  let restAsked = false;
  const askRest = () => {
    if (restAsked) return;
    restAsked = true;
    compiled.rest().then((rest) => worker.postMessage({ kind: "rest", rest }), broken);
  };
  worker.onmessage = ({ data }) => {
    if (data.kind === "lacks") {
      askRest();
      return;
    }
    if (data.kind === "done") setTimeout(askRest, REST_LATE_MS);
    heard(data);
  };
  worker.onerror = (event) => {
    event.preventDefault();
    heard({ kind: "broken", why: event.message ?? say("its worker did not begin") });
  };
  compiled.module.then((module) => worker.postMessage({ kind: "begin", module }), broken);
  return {
    post: (message) => worker.postMessage(message),
    end: () => {
      worker.terminate();
      URL.revokeObjectURL(address);
    },
  };
}

export class Core extends Requests {
  constructor() {
    super(startWorker);
  }
}
