// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Words that can be asked for: what `topple explain` tells of a word stands beside it while it has the focus or the
 * pointer is on it. Each word is asked for once.
 */

import { element } from "./element.js";
import { readExplanation } from "./explanation.js";
import { say } from "../words/language.js";

const EXPLAIN_MAX_MS = 5000;

export class Terms {
  #asked = new Map();
  #wanted = null;

  /** @param {{run: Function}} core */
  constructor(core) {
    this.core = core;
    this.bubble = element("div", { class: "bubble", role: "tooltip", id: "explanation", hidden: true });
    document.body.append(this.bubble);
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.#hide();
    });
  }

  /**
   * A word on the page that tells what it means.
   * @param {string} shown
   * @param {string} [term] what explain knows it by
   */
  word(shown, term = shown) {
    const show = (event) => this.#show(event.currentTarget, term);
    const hide = () => this.#hide();
    return element(
      "button",
      {
        type: "button", class: "term", "aria-describedby": "explanation",
        onmouseenter: show, onfocus: show, onclick: show, onmouseleave: hide, onblur: hide,
      },
      say(shown),
    );
  }

  /** What a panel drew anew took its words along: none of them can be left any more. */
  forget() {
    if (this.#wanted !== null && !this.#wanted.isConnected) this.#hide();
  }

  async #show(anchor, term) {
    this.#wanted = anchor;
    const explained = await this.#explanation(term);
    if (this.#wanted !== anchor || !anchor.isConnected) return;
    this.bubble.replaceChildren(
      element("strong", {}, explained.title),
      ...explained.rows.map(({ label, text }) =>
        element("p", {}, label === "" ? null : element("span", { class: "label" }, label + " "), text),
      ),
    );
    this.bubble.hidden = false;
    this.#place(anchor.getBoundingClientRect());
  }

  /** Below the word, or above it where there is more room, and within the window. */
  #place(word) {
    const bubble = this.bubble.getBoundingClientRect();
    const below = word.bottom + 6;
    const fits = below + bubble.height <= innerHeight || word.top < innerHeight / 2;
    const left = Math.max(8, Math.min(word.left, document.documentElement.clientWidth - bubble.width - 8));
    this.bubble.style.left = left + scrollX + "px";
    this.bubble.style.top = (fits ? below : word.top - bubble.height - 6) + scrollY + "px";
  }

  #hide() {
    this.#wanted = null;
    this.bubble.hidden = true;
  }

  /** What a key of scenes means, by its path. @param {string} path as loads.anchors[].at */
  explainKey(path) {
    return this.#explanation(path, path + ", a key of scenes");
  }

  /** @param {string} term @param {string} [heading] of the meaning that is wanted */
  #explanation(term, heading = "") {
    if (!this.#asked.has(term)) {
      const asked = this.core.run(["explain", ...term.split(" ")], {}, { timeoutMs: EXPLAIN_MAX_MS }).then(
        (answer) => readExplanation(answer.status === 0 ? answer.out : answer.err, heading),
        (error) => {
          this.#asked.delete(term); // a core that was stopped is asked again
          return { title: term, rows: [{ label: "", text: error.message }] };
        },
      );
      this.#asked.set(term, asked);
    }
    return this.#asked.get(term);
  }
}
