// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The strip for what went wrong. A complaint about the scene leads to its line; every text here is text, never markup. */

import { say } from "../words/language.js";

export class Messages {
  #fromScene = false;

  /**
   * @param {HTMLElement} element
   * @param {{store: import("../scene/store.js").SceneStore, show: (line: number, column: number) => void}} page show: the text there
   */
  constructor(element, { store, show }) {
    this.element = element;
    this.store = store;
    this.show = show;
    store.addEventListener("problem", () => this.#complain());
    store.addEventListener("solution", () => this.#fromScene && this.clear());
    let openings = store.openings;
    store.addEventListener("text", () => {
      // what was said of another scene goes with it
      if (openings > 0 && store.openings !== openings) this.clear();
      openings = store.openings;
    });
  }

  /** @param {string} words */
  say(words) {
    this.#fromScene = false;
    this.element.textContent = words;
    this.element.hidden = false;
  }

  clear() {
    this.element.replaceChildren();
    this.element.hidden = true;
  }

  #complain() {
    const { file, line, column, message } = this.store.problem;
    this.say(message);
    this.#fromScene = true;
    if (line === null || file !== this.store.name) {
      if (file !== null) this.element.prepend((line === null ? file : say("%s, line %s", file, line)) + ": ");
      return;
    }
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = say("Line %s", line);
    button.addEventListener("click", () => this.show(line, column ?? 1));
    this.element.prepend(button, " ");
  }
}
