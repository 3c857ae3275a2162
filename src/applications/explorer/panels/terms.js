// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Words that can be asked for: what `topple explain` tells of a word stands beside it while it has the focus or the
 * pointer is on it. Each word is asked for once.
 */

import { element } from "./element.js";

const LABELS = /^(Symbol|Formula|Unit|Range|Default|Source|Also|Keys|Page)\s{2,}(.*)$/;
const EXPLAIN_MAX_MS = 5000;

/**
 * What explain printed of its first meaning, as a title and paragraphs, the lines of each joined.
 * @param {string} printed
 */
function readExplanation(printed) {
  const [title, ...lines] = printed.split("\n\n", 1)[0].split("\n");
  const rows = [];
  for (const line of lines.map((each) => each.trim())) {
    const found = LABELS.exec(line);
    if (found !== null) rows.push({ label: found[1], text: found[2] });
    else if (rows.length === 0) rows.push({ label: "", text: line });
    else rows[rows.length - 1].text += " " + line;
  }
  return { title, rows };
}

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
      shown,
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

  /** @param {string} term */
  #explanation(term) {
    if (!this.#asked.has(term)) {
      const asked = this.core.run(["explain", ...term.split(" ")], {}, { timeoutMs: EXPLAIN_MAX_MS }).then(
        (answer) => readExplanation(answer.status === 0 ? answer.out : answer.err),
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
