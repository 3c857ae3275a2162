// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The scene: its text is the one truth, and everything on the page follows it. Each change of the text is solved by
 * the core; of changes that come faster than answers only the latest is.
 *
 * Events: "text" (the text, its name or its files are others), "solution" (an answer for the present text), "problem"
 * (it has none, and why), "busy" (the core began or ended to work on it), "history" (what can be undone changed).
 */

import { History } from "./history.js";
import { kindOf } from "./kind.js";
import { solutionOf } from "./solution.js";
import { SceneText } from "./scene_text.js";
import { readComplaint } from "./complaint.js";
import { MODEL, needsModel } from "../solid/model.js";

/** How long one solve may take before the core is stopped, milliseconds. */
export const SOLVE_MAX_MS = 15_000;

/** @param {"block"|"blocks"|"solid"} kind @param {SceneText} scene @returns {{words: string[], collect: string[]}} how the core is asked, and what it writes */
export function askedFor(kind, scene) {
  if (kind === "solid" && needsModel(scene)) return { words: ["solve", "--json", "--figure", MODEL], collect: [MODEL] };
  return { words: ["solve", "--json", ...(kind === "solid" ? [] : ["--outlines"])], collect: [] };
}

/** How long a solve may hold up that of a newer text, milliseconds. */
const PATIENCE_MS = 2_000;

/**
 * @typedef {Record<string, string|Uint8Array>} Files
 * @typedef {{name: string, text: string, files: Files}} State
 */

const historyOf = (first) => new History(first, (state) => state.text.length);

export class SceneStore extends EventTarget {
  #history = historyOf({ name: "scene.yaml", text: "", files: {} });
  #parsed = null;
  #asked = 0;
  #saidBusy = false;
  /** Solves that have not ended, and when they were asked for. @type {Map<AbortController, number>} */
  #pending = new Map();

  /** @param {{run: Function}} core */
  constructor(core) {
    super();
    this.core = core;
    /** The answer for the present text, JSON of `topple solve`, with the kind of its scene; null while there is none. */
    this.solution = null;
    /** The last answer there was, of whatever text: what the drawing keeps. */
    this.lastSolution = null;
    /** @type {import("./complaint.js").Complaint|null} */
    this.problem = null;
    /** How many scenes were opened: another number, another scene. */
    this.openings = 0;
  }

  get text() {
    return this.#history.present.text;
  }

  get name() {
    return this.#history.present.name;
  }

  /** Its name on a command line, where one that begins with a dash would be an option. */
  get argument() {
    return this.name.startsWith("-") ? "./" + this.name : this.name;
  }

  /** Files that the scene names, beside it. @returns {Files} */
  get files() {
    return this.#history.present.files;
  }

  get canUndo() {
    return this.#history.canUndo;
  }

  get canRedo() {
    return this.#history.canRedo;
  }

  get busy() {
    return this.#pending.size > 0;
  }

  /** The text as a tree, read once for each text. @returns {SceneText} */
  get parsed() {
    if (this.#parsed === null || this.#parsed.text !== this.text) this.#parsed = new SceneText(this.text);
    return this.#parsed;
  }

  /**
   * @param {string} text
   * @param {{mergeWith?: string}} [options] mergeWith: changes in a row of the same gesture are undone together
   */
  setText(text, { mergeWith = null } = {}) {
    if (text === this.text) return;
    this.#put({ ...this.#history.present, text }, mergeWith);
  }

  /** @param {(string|number)[]} path @param {string} decimal @param {{mergeWith?: string}} [options] */
  setNumber(path, decimal, options = {}) {
    this.setNumbers([{ path, text: decimal }], options);
  }

  /** Several numbers at once, as the x and y of a vertex. @param {{path: (string|number)[], text: string}[]} numbers */
  setNumbers(numbers, options = {}) {
    this.#parsed = this.parsed.movedTo(numbers);
    this.setText(this.#parsed.text, options);
  }

  /** Another scene. @param {State} state */
  open({ name, text, files = {} }) {
    if (this.openings++ === 0) this.#history = historyOf({ name, text, files });
    else this.#history.push({ name, text, files });
    this.#changed();
  }

  /** One more file beside the scene. @param {string} name @param {string|Uint8Array} content */
  addFile(name, content) {
    this.#put({ ...this.#history.present, files: { ...this.files, [name]: content } }, null);
  }

  /** What comes next is undone by itself: a drag has ended. */
  endGesture() {
    this.#history.endGesture();
  }

  undo() {
    if (this.#history.undo() !== null) this.#changed();
  }

  redo() {
    if (this.#history.redo() !== null) this.#changed();
  }

  /** @param {State} state */
  #put(state, gesture) {
    this.#history.push(state, gesture);
    this.#changed();
  }

  #changed() {
    this.solution = null;
    this.#tell("text");
    this.#tell("history");
    this.#solve();
  }

  /** A solve of an older text that takes long is given up: the present one does not wait for it. */
  async #solve() {
    const asked = ++this.#asked;
    const now = performance.now();
    for (const [control, since] of this.#pending) if (now - since > PATIENCE_MS) control.abort();
    const control = new AbortController();
    const kind = kindOf(this.parsed);
    this.#pending.set(control, now);
    this.#tellBusy();
    try {
      const { words, collect } = askedFor(kind, this.parsed);
      const answer = await this.core.run(
        [...words, this.argument],
        { ...this.files, [this.name]: this.text },
        { latest: "solve", timeoutMs: SOLVE_MAX_MS, collect, signal: control.signal },
      );
      if (asked === this.#asked) this.#answered(answer, kind);
    } catch (error) {
      // a request that a later one replaced says so by the usual name, and is no failure
      if (asked === this.#asked && error.name !== "AbortError") this.#failed(error);
    } finally {
      this.#pending.delete(control);
      this.#tellBusy();
    }
  }

  #answered(answer, kind) {
    if (answer.out !== "") {
      this.solution = { ...solutionOf(kind, answer.out), model: answer.files[MODEL] };
      this.lastSolution = this.solution;
      this.problem = null;
      this.#tell("solution");
    } else {
      this.problem = readComplaint(answer.err);
      this.#tell("problem");
    }
  }

  #failed(error) {
    this.problem = { file: null, line: null, column: null, message: error.message };
    this.#tell("problem");
  }

  #tellBusy() {
    if (this.busy === this.#saidBusy) return;
    this.#saidBusy = this.busy;
    this.#tell("busy");
  }

  #tell(what) {
    this.dispatchEvent(new Event(what));
  }
}
