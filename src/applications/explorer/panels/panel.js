// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * What all panels share: a panel draws the answer for the present scene, and only while it is shown; one that is
 * hidden catches up when it is shown again. While the scene has no answer the last one stays, greyed, and says so.
 */

import { element } from "./element.js";
import { say } from "../words/language.js";

/**
 * @typedef {object} Context
 * @property {import("../scene/store.js").SceneStore} store
 * @property {{run: Function}} core
 * @property {{run: Function}} background a core of its own for what takes long
 * @property {import("./terms.js").Terms} terms
 */

export class Panel {
  #drawn = null;
  #frame = 0;

  /** @param {HTMLElement} place @param {Context} context */
  constructor(place, { store, core, background, terms }) {
    this.store = store;
    this.core = core;
    this.background = background;
    this.terms = terms;
    this.shown = false;
    this.stale = element("p", { class: "stale", hidden: true });
    this.body = element("div", { class: "body" });
    this.place = place;
    place.append(this.stale, this.body);
    store.addEventListener("solution", () => this.#later());
    store.addEventListener("problem", () => this.#later());
    new MutationObserver(() => this.shown && this.coloured()).observe(document.documentElement, { attributeFilter: ["data-theme"] });
  }

  show() {
    this.shown = true;
    this.#update();
  }

  hide() {
    this.shown = false;
    this.hidden();
  }

  /** @param {any} solution what `topple solve --json` printed */
  draw(solution) {
    throw new Error("a panel draws " + solution);
  }

  /** Of which kinds of scenes it has something to show. @returns {string[]} */
  get takes() {
    return ["block"];
  }

  /** What runs for it can be left. */
  hidden() {}

  /** Light and dark have changed: what has its colours from neither element nor style is drawn anew. */
  coloured() {}

  /** The scene and what lies beside it, as files for the core. */
  files() {
    return { ...this.store.files, [this.store.name]: this.store.text };
  }

  /** Answers that come faster than the screen shows them are drawn once. */
  #later() {
    if (this.#frame !== 0) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.#update();
    });
  }

  #update() {
    if (!this.shown) return;
    const { problem, solution } = this.store;
    this.place.classList.toggle("outdated", problem !== null);
    this.stale.hidden = problem === null;
    if (problem !== null) {
      this.stale.textContent = say(this.#drawn ? "The scene has no answer now, see its message; this is the last one." : "The scene has no answer now, see its message.");
    }
    if (solution === null || solution === this.#drawn) return;
    this.#drawn = solution;
    this.body.hidden = !this.takes.includes(solution.kind);
    if (this.body.hidden) {
      this.stale.hidden = false;
      this.stale.textContent = say("This is of scenes of one block; what was found of this one stands under Verdict.");
      return;
    }
    this.place.dataset.scene = this.store.name;
    this.draw(solution);
    this.terms.forget();
  }
}
