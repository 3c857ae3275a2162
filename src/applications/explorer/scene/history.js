// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Undo and redo over states of the scene. Changes of one gesture (a drag, a run of key presses) are one step. */

const STEPS_MAX = 300;
const CHARACTERS_MAX = 30_000_000;

/** @template State */
export class History {
  /** @param {State} present @param {(state: State) => number} size in characters, for the bound on what is kept */
  constructor(present, size) {
    this.present = present;
    this.size = size;
    /** @type {State[]} */
    this.past = [];
    /** @type {State[]} */
    this.future = [];
    /** @type {string|null} */
    this.gesture = null;
  }

  /**
   * @param {State} state
   * @param {string|null} gesture changes in a row with the same gesture become one step
   */
  push(state, gesture = null) {
    if (gesture === null || gesture !== this.gesture) this.past.push(this.present);
    this.gesture = gesture;
    this.present = state;
    this.future = [];
    this.#forget();
  }

  /** What comes next is a step of its own, whatever its gesture. */
  endGesture() {
    this.gesture = null;
  }

  /** @returns {State|null} */
  undo() {
    const before = this.past.pop();
    if (before === undefined) return null;
    this.future.push(this.present);
    this.gesture = null;
    this.present = before;
    return before;
  }

  /** @returns {State|null} */
  redo() {
    const after = this.future.pop();
    if (after === undefined) return null;
    this.past.push(this.present);
    this.gesture = null;
    this.present = after;
    return after;
  }

  get canUndo() {
    return this.past.length > 0;
  }

  get canRedo() {
    return this.future.length > 0;
  }

  #forget() {
    let kept = this.past.reduce((sum, state) => sum + this.size(state), 0);
    while (this.past.length > STEPS_MAX || (kept > CHARACTERS_MAX && this.past.length > 0)) {
      kept -= this.size(this.past.shift());
    }
  }
}
