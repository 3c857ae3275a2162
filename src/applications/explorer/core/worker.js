// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Answers requests to run the program, one after the other, in a thread of its own: that of a page, or of node. */

import { Program } from "./program.js";

const KEPT_MAX = 512 * 2 ** 20; // bytes: an instance that has grown beyond gives them back by ending

/**
 * @param {{post: (message: object) => void, listen: (heard: (message: object) => void) => void}} port
 * @param {Function} createCore what emscripten's loader exports
 */
export function serve(port, createCore) {
  let module = null;
  /** @type {Promise<Program>} */
  let program = null;
  /** @type {(rest: import("./program.js").Rest) => void} */
  let restCame;
  /** @type {Promise<import("./program.js").Rest>} */
  const rest = new Promise((resolve) => (restCame = resolve));
  const begin = () => {
    program = Program.create(createCore, { module, rest, lacks: () => port.post({ kind: "lacks" }) });
  };
  port.listen(async (message) => {
    if (message.kind === "begin") {
      module = message.module;
      begin();
      program.then(() => port.post({ kind: "ready" }), (error) => port.post({ kind: "broken", why: String(error) }));
      return;
    }
    if (message.kind === "rest") {
      restCame(message.rest);
      return;
    }
    port.post({ kind: "begun", id: message.id });
    try {
      const own = await program;
      const answer = await own.run(message.args, message.files, message.collect);
      port.post({ kind: "done", id: message.id, answer });
      if (own.size > KEPT_MAX) begin();
    } catch (error) {
      port.post({ kind: "failed", id: message.id, why: String(error) });
    }
  });
}
