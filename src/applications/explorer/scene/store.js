// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The scene: its text is the one truth, and everything on the page follows it. Each change of the text is solved by
 * the core; of changes that come faster than answers only the latest is.
 *
 * Events: "text" (the text, its name, its files or the load case that is shown are others), "solution" (an answer for the
 * present text), "problem" (it has none, and why), "late" (it has had none for a while), "busy" (the core began or ended to
 * work on it), "history" (what can be undone changed).
 */

import { History } from "./history.js";
import { kindOf } from "./kind.js";
import { caseNames, listedCases, listWords } from "./load_cases.js";
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

/** How long the last answer is shown as if it were that of the present text, milliseconds. */
const LATE_MS = 250;

/**
 * @typedef {Record<string, string|Uint8Array>} Files
 * @typedef {{name: string, text: string, files: Files, opening?: number}} State opening: which of the scenes that were opened it is of
 */

/** What the program said of a scene that it refuses. */
class Refused extends Error {}

const historyOf = (first) => new History(first, (state) => state.text.length);

export class SceneStore extends EventTarget {
  #history = historyOf({ name: "scene.yaml", text: "", files: {} });
  #parsed = null;
  #asked = 0;
  #saidBusy = false;
  #lateTimer = 0;
  #shown = ""; // which scene and load case results are shown of
  /** The load case that the reader chose, and of which scene. @type {{opening: number, name: string}|null} */
  #chosen = null;
  /** Solves that have not ended, and when they were asked for. @type {Map<AbortController, number>} */
  #pending = new Map();

  /** @param {{run: Function}} core */
  constructor(core) {
    super();
    this.core = core;
    /** The answer for the present text, JSON of `topple solve`, with the kind of its scene; null while there is none. */
    this.solution = null;
    /** The last answer there was for the scene that is open, of whatever text: what the drawing keeps; null: none yet. */
    this.lastSolution = null;
    /** Whether the present text has had neither answer nor problem for a while. */
    this.late = false;
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

  /** Which of the scenes that were opened the present text is of, and its title: a verdict is never shown under those of another. */
  get subject() {
    return JSON.stringify([this.#opening, this.parsed.title]);
  }

  /** Whether the last answer is of the scene that has this title. */
  get isOfSubject() {
    return this.lastSolution !== null && this.lastSolution.subject === this.subject;
  }

  get #opening() {
    return this.#history.present.opening ?? 0;
  }

  /** @returns {string|null} */
  get #chosenCase() {
    return this.#chosen?.opening === this.#opening ? this.#chosen.name : null;
  }

  /** Words of a command that choose the load case that is shown; none where the scene has no cases. @returns {string[]} */
  get caseWords() {
    const shown = this.lastSolution?.loadCases?.shown ?? null;
    return shown === null ? [] : ["--case=" + shown];
  }

  /** Show another load case. @param {string} name */
  chooseCase(name) {
    this.#chosen = { opening: this.#opening, name };
    this.#changed();
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
    const state = { name, text, files, opening: this.openings + 1 };
    if (this.openings++ === 0) this.#history = historyOf(state);
    else this.#history.push(state);
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
    const shown = this.#opening + " " + this.#chosenCase;
    if (shown !== this.#shown) {
      this.#shown = shown;
      this.lastSolution = this.problem = null;
    }
    this.#await();
    this.#tell("text");
    this.#tell("history");
    this.#solve();
  }

  /** Who shows the last answer learns where that of the present text is late. */
  #await() {
    clearTimeout(this.#lateTimer);
    this.late = false;
    this.#lateTimer = setTimeout(() => {
      this.late = true;
      this.#tell("late");
    }, LATE_MS);
  }

  #came() {
    clearTimeout(this.#lateTimer);
    this.late = false;
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
    const { subject } = this;
    const run = (words, collect = []) => this.core.run(
      words, { ...this.files, [this.name]: this.text }, { latest: "solve", timeoutMs: SOLVE_MAX_MS, collect, signal: control.signal });
    try {
      const loadCases = await this.#listCases(kind, run);
      if (asked !== this.#asked) return;
      const { words, collect } = askedFor(kind, this.parsed);
      const answer = await run([...words, ...(loadCases?.shown ? ["--case=" + loadCases.shown] : []), this.argument], collect);
      if (asked === this.#asked) this.#answered(answer, { kind, subject, loadCases });
    } catch (error) {
      // a request that a later one replaced says so by the usual name, and is no failure
      if (asked === this.#asked && error.name !== "AbortError") this.#failed(error);
    } finally {
      this.#pending.delete(control);
      this.#tellBusy();
    }
  }

  /**
   * @param {string} kind @param {(words: string[]) => Promise<object>} run
   * @returns {Promise<{cases: import("./load_cases.js").LoadCase[], shown: string|null}|null>} null: the scene has none
   */
  async #listCases(kind, run) {
    const names = caseNames(this.parsed);
    if (names.length === 0) return null;
    const chosen = this.#chosenCase;
    const answer = await run([...listWords(kind), this.argument]);
    if (answer.out === "") throw new Refused(answer.err);
    const listed = listedCases(kind, answer.out, names);
    return { ...listed, shown: names.includes(chosen) ? chosen : listed.shown };
  }

  #answered(answer, { kind, subject, loadCases }) {
    if (answer.out === "") throw new Refused(answer.err);
    this.solution = { ...solutionOf(kind, answer.out), model: answer.files[MODEL], subject, loadCases };
    this.lastSolution = this.solution;
    this.problem = null;
    this.#came();
    this.#tell("solution");
  }

  #failed(error) {
    this.problem = error instanceof Refused ? readComplaint(error.message) : { file: null, line: null, column: null, message: error.message };
    this.#came();
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
