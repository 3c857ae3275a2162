// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The core of the page: the program topple in WebAssembly, in a worker made of what the page carries. */

import carried from "topple:core";
import { unpacked } from "./packed.js";
import { Requests } from "./requests.js";

export { CoreStopped } from "./requests.js";

/** @returns {Promise<WebAssembly.Module>} of the bytes within the page, compiled while they are unpacked */
function compile() {
  return WebAssembly.compileStreaming(new Response(unpacked(carried.wasm), { headers: { "Content-Type": "application/wasm" } }));
}

/** Compiled once for all cores of the page. @type {Promise<WebAssembly.Module>|null} */
let compiled = null;

/** @param {(message: object) => void} heard */
function startWorker(heard) {
  compiled ??= compile();
  const address = URL.createObjectURL(new Blob([carried.worker], { type: "text/javascript" }));
  const worker = new Worker(address);
  worker.onmessage = (event) => heard(event.data);
  worker.onerror = (event) => {
    event.preventDefault();
    heard({ kind: "broken", why: event.message ?? "its worker did not begin" });
  };
  compiled.then(
    (module) => worker.postMessage({ kind: "begin", module }),
    (error) => heard({ kind: "broken", why: String(error) }),
  );
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
