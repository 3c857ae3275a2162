// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Requests to the core, which runs one at a time in a worker: a queue, in which a later request replaces a waiting one of
 * the same name; time limits; a worker that is stopped and started anew where a run takes too long or breaks down, or where
 * the worker is dead: it never begins, or does not confirm a request. A worker confirms each request before it runs it,
 * so that a long run and a dead worker differ.
 */

import { say } from "../words/language.js";

/**
 * @typedef {object} Answer
 * @property {number} status exit status: 0 done, 1 refuted, 2 wrong usage, 3 bad input, 4 undecided, 5 the system failed
 * @property {string} out standard output
 * @property {string} err standard error
 * @property {Object<string, Uint8Array>} files those that were asked for and written, by name
 * @property {number} seconds that the run took
 *
 * @typedef {object} Port a worker that has begun
 * @property {(message: object) => void} post
 * @property {() => void} end
 */

const LIMIT_MS = 20000;

/** How long a worker may take until it is ready, and until it confirms a request, milliseconds. */
export const PATIENCE = { begin: 60_000, confirm: 5_000 };

/** The core was stopped while it ran; it has been started again. */
export class CoreStopped extends Error {
  constructor(message) {
    super(message);
    this.name = "CoreStopped";
  }
}

const replaced = () => new DOMException("a later request replaced this one", "AbortError");

export class Requests {
  #start;
  #waiting = [];
  #running = null;
  /** @type {Port|null} */
  #port = null;
  #ready = false;
  #count = 0;
  #isClosed = false;
  #beginning = 0; // timer of a worker that is not ready yet
  #confirming = 0; // timer of a request that is not confirmed yet

  /** Told of each change: "starting", "ready" or "running". @type {((state: string) => void)|null} */
  onstate = null;

  /**
   * @param {(heard: (message: object) => void) => Port} start starts a worker, whose messages `heard` takes
   * @param {{begin: number, confirm: number}} [patience] milliseconds
   */
  constructor(start, patience = PATIENCE) {
    this.#start = start;
    this.patience = patience;
    this.#begin();
  }

  /**
   * Run the program.
   * @param {string[]} args as on the command line
   * @param {Object<string, string|Uint8Array>} files written beforehand where it runs
   * @param {{latest?: string, timeoutMs?: number, collect?: string[], signal?: AbortSignal}} [options] latest: this
   *   request replaces a waiting one of that name, which ends with an AbortError; collect: files to be read afterwards
   * @returns {Promise<Answer>}
   */
  run(args, files, { latest = null, timeoutMs = LIMIT_MS, collect = [], signal = null } = {}) {
    return new Promise((resolve, reject) => {
      if (signal?.aborted) {
        reject(signal.reason);
        return;
      }
      const request = { id: ++this.#count, args, files, latest, timeoutMs, collect, resolve, reject, timer: 0, isSentAgain: false };
      signal?.addEventListener("abort", () => this.#abandon(request, signal.reason), { once: true });
      const before = latest === null ? -1 : this.#waiting.findIndex((other) => other.latest === latest);
      if (before >= 0) {
        this.#waiting[before].reject(replaced());
        this.#waiting[before] = request;
      } else {
        this.#waiting.push(request);
      }
      // a worker that could not begin gets another chance with each request
      if (this.#port === null && !this.#isClosed) this.#begin();
      this.#next();
    });
  }

  /** Stop what runs, with an error of its own, and start anew; what waits is kept. */
  restart() {
    this.#stop(new CoreStopped(say("The core was stopped on request. It has been started again.")));
  }

  /** End for good. */
  close() {
    this.#isClosed = true;
    this.#end();
  }

  #begin() {
    this.#ready = false;
    this.onstate?.("starting");
    clearTimeout(this.#beginning);
    this.#beginning = setTimeout(() => this.#stop(new CoreStopped(say("The core cannot run here: %s", say("its worker did not begin"))), false), this.patience.begin);
    try {
      const port = this.#start((message) => {
        if (port === this.#port) this.#hear(message);
      });
      this.#port = port;
    } catch (error) {
      this.#stop(new CoreStopped(say("The core cannot run here: %s", error.message)), false);
    }
  }

  /** The worker ends, and nothing more is awaited of it. */
  #end() {
    clearTimeout(this.#beginning);
    clearTimeout(this.#confirming);
    this.#port?.end();
    this.#port = null;
    this.#ready = false;
  }

  #next() {
    if (!this.#ready || this.#running !== null || this.#waiting.length === 0) return;
    const request = this.#waiting.shift();
    this.#running = request;
    request.timer = setTimeout(() => this.#stop(new CoreStopped(say(
      "The core was stopped: it had taken %s s. It has been started again; a scene with fewer vertices, or a question that is less exact, takes less.",
      request.timeoutMs / 1000))), request.timeoutMs);
    this.#confirming = setTimeout(() => this.#resend(), this.patience.confirm);
    this.onstate?.("running");
    this.#port.post({ kind: "run", id: request.id, args: request.args, files: request.files, collect: request.collect });
  }

  #hear(message) {
    if (message.kind === "ready") {
      clearTimeout(this.#beginning);
      this.#ready = true;
      this.onstate?.("ready");
      this.#next();
    } else if (message.kind === "begun") {
      if (message.id === this.#running?.id) clearTimeout(this.#confirming);
    } else if (message.kind === "broken") {
      this.#stop(new CoreStopped(say("The core cannot run here: %s", message.why)), this.#ready);
    } else if (message.kind === "failed") {
      this.#stop(new CoreStopped(say("The core broke down on this scene (%s). It has been started again.", message.why)));
    } else if (message.id === this.#running?.id) {
      const request = this.#take();
      request.resolve(message.answer);
      this.onstate?.("ready");
      this.#next();
    }
  }

  /** @returns the request that ran */
  #take() {
    const request = this.#running;
    this.#running = null;
    clearTimeout(request?.timer);
    clearTimeout(this.#confirming);
    return request;
  }

  /** A worker that does not confirm a request is dead: another one gets the request, once. */
  #resend() {
    if (this.#running.isSentAgain) {
      this.#stop(new CoreStopped(say("The core does not answer. It has been started again.")));
      return;
    }
    const request = this.#take();
    request.isSentAgain = true;
    if (request.latest !== null && this.#waiting.some(({ latest }) => latest === request.latest)) request.reject(replaced());
    else this.#waiting.unshift(request);
    this.#end();
    this.#begin();
  }

  /** @param {Error} error for the request that runs; @param {boolean} [again] whether to start anew */
  #stop(error, again = true) {
    this.#end();
    this.#take()?.reject(error);
    if (again) {
      this.#begin();
      return;
    }
    for (const request of this.#waiting.splice(0)) request.reject(error);
  }

  #abandon(request, reason) {
    if (request === this.#running) {
      this.#stop(reason);
      return;
    }
    const at = this.#waiting.indexOf(request);
    if (at < 0) return;
    this.#waiting.splice(at, 1);
    request.reject(reason);
  }
}
