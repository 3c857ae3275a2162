// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Work of several requests for one state of the scene: it begins once the scene has been still, and what still runs
 * for an older state is left, so that a drag never waits for it. Long requests take the job's signal and are stopped.
 */

const STILL = 250;

export class Job {
  #turn = 0;
  #timer = 0;
  #stopping = new AbortController();

  /**
   * @param {(current: () => boolean, signal: AbortSignal) => Promise<void>} work looks at current() after each answer, and leaves when it is not
   * @param {(error: Error) => void} failed
   */
  constructor(work, failed) {
    this.work = work;
    this.failed = failed;
  }

  /** @param {number} [still] milliseconds */
  start(still = STILL) {
    this.stop();
    const turn = this.#turn;
    this.#stopping = new AbortController();
    this.#timer = setTimeout(() => this.#run(turn), still);
  }

  stop() {
    this.#turn++;
    clearTimeout(this.#timer);
    this.#stopping.abort();
  }

  async #run(turn) {
    const current = () => turn === this.#turn;
    try {
      await this.work(current, this.#stopping.signal);
    } catch (error) {
      // a request that a later one replaced is no failure
      if (current() && error.name !== "AbortError") this.failed(error);
    }
  }
}
