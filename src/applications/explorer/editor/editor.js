// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The scene as text: CodeMirror, both ways at once with the store, and the core's complaint at its line. */

import { EditorState, Annotation } from "@codemirror/state";
import { EditorView, keymap, lineNumbers, highlightActiveLine, drawSelection } from "@codemirror/view";
import { defaultKeymap } from "@codemirror/commands";
import { searchKeymap, highlightSelectionMatches } from "@codemirror/search";
import { yamlLanguage } from "@codemirror/lang-yaml";
import { bracketMatching, indentOnInput, Language, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { CarefulParser } from "./careful_parser.js";
import { colours } from "./colours.js";
import { difference } from "./difference.js";
import { plainEnds, withTyped } from "./line_ends.js";

const language = new Language(yamlLanguage.data, new CarefulParser(yamlLanguage.parser), [], yamlLanguage.name);
const fromStore = Annotation.define();
const OFTEN_MS = 60;
const FOLLOW_MS = 150;

export class Editor {
  #changed = -Infinity; // when the text did so elsewhere
  #shown = false;
  #timer = null;
  #marked = 0; // lines with a complaint

  /** @param {HTMLElement} element @param {import("../scene/store.js").SceneStore} store @param {object[]} help extensions that explain */
  constructor(element, store, help) {
    this.store = store;
    this.help = help;
    this.view = new EditorView({ parent: element, state: EditorState.create({ doc: plainEnds(store.text), extensions: this.#extensions() }) });
    this.view.scrollDOM.tabIndex = 0; // what is beyond its edge is reached by keys
    store.addEventListener("text", () => this.#follow());
    store.addEventListener("solution", () => this.#mark(null));
    store.addEventListener("problem", () => this.#mark(store.problem));
  }

  /** What is not seen follows once it is: until then a drag is not held up by it. @param {boolean} shown */
  set shown(shown) {
    this.#shown = shown;
    if (!shown) return;
    this.#catchUp();
    this.#mark(this.store.problem);
  }

  /** Put the cursor where a complaint is. */
  show(line, column) {
    const found = this.view.state.doc.line(Math.min(line, this.view.state.doc.lines));
    const at = Math.min(found.from + column - 1, found.to);
    this.view.dispatch({ selection: { anchor: at }, scrollIntoView: true });
    this.view.focus();
  }

  #extensions() {
    return [
      lineNumbers(), drawSelection(), highlightActiveLine(), bracketMatching(), indentOnInput(), highlightSelectionMatches(),
      ...this.help, lintGutter(), language, syntaxHighlighting(colours),
      // Tab leads on to what comes next on the page: Ctrl+] and Ctrl+[ indent
      keymap.of([...this.#historyKeys(), ...searchKeymap, ...defaultKeymap]),
      EditorView.contentAttributes.of({ "aria-label": "The scene as text, in YAML" }),
      EditorView.updateListener.of((update) => this.#typed(update)),
      EditorView.domEventHandlers({ focusin: () => this.#catchUp() }),
    ];
  }

  #historyKeys() {
    const undo = () => (this.store.undo(), true);
    const redo = () => (this.store.redo(), true);
    return [
      { key: "Mod-z", run: undo, preventDefault: true },
      { key: "Mod-y", mac: "Mod-Shift-z", run: redo, preventDefault: true },
      { key: "Mod-Shift-z", run: redo, preventDefault: true },
    ];
  }

  #typed(update) {
    if (!update.docChanged || update.transactions.some((one) => one.annotation(fromStore))) return;
    this.store.setText(withTyped(this.store.text, update.state.doc.toString()), { mergeWith: "typing" });
  }

  /**
   * The text changed elsewhere. While a hand drags, it does so every frame, and to lay out a long line each time would
   * cost the drawing its frames: then the editor follows some times a second, unless it has the focus itself.
   */
  #follow() {
    if (!this.#shown) return;
    const now = performance.now();
    const quick = now - this.#changed < OFTEN_MS && !this.view.hasFocus;
    this.#changed = now;
    if (!quick) this.#catchUp();
    else this.#timer ??= setTimeout(() => this.#catchUp(), FOLLOW_MS);
  }

  /** Only what differs is put in, so that the cursor stays. */
  #catchUp() {
    clearTimeout(this.#timer);
    this.#timer = null;
    const change = difference(this.view.state.doc.toString(), plainEnds(this.store.text));
    if (change !== null) this.view.dispatch({ changes: change, annotations: fromStore.of(true) });
  }

  /** @param {import("../scene/complaint.js").Complaint|null} problem */
  #mark(problem) {
    if (!this.#shown || (problem === null && this.#marked === 0)) return;
    if (this.#timer !== null) this.#catchUp();
    const found = problem === null || problem.line === null || problem.file !== this.store.name ? [] : [this.#diagnostic(problem)];
    this.#marked = found.length;
    this.view.dispatch(setDiagnostics(this.view.state, found));
  }

  #diagnostic({ line, column, message }) {
    const { doc } = this.view.state;
    const found = doc.line(Math.max(1, Math.min(line, doc.lines)));
    const from = Math.min(found.from + Math.max(0, column - 1), found.to);
    const word = /^[^\s,\]}#]*/.exec(doc.sliceString(from, found.to))[0].length;
    return { from, to: Math.min(from + Math.max(1, word), Math.max(from, found.to)), severity: "error", message };
  }
}
