// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * What all panels share: a panel draws the answer for the present scene, and only while it is shown; one that is
 * hidden catches up when it is shown again. While the scene has no answer, or none yet, the last one stays, greyed, and says
 * so; results of another scene, title or load case never stay.
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

/** Which scene and load case an answer is of. */
const shownOf = ({ subject, loadCases }) => JSON.stringify([subject, loadCases?.shown ?? null]);

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
    for (const event of ["solution", "problem", "late"]) store.addEventListener(event, () => this.#later());
    store.addEventListener("text", () => store.lastSolution === null && this.#update());
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

  /** Whether it shows results of the scene at all. */
  get isOfScene() {
    return true;
  }

  /** What runs for it can be left. */
  hidden() {}

  /** What came later than the last answer, or is said outside of the body, goes: what follows is of another scene. */
  forget() {}

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
    if (!this.shown || !this.isOfScene) return;
    const { solution } = this.store;
    if (solution === null) {
      this.#await();
      return;
    }
    const takes = this.takes.includes(solution.kind);
    this.place.classList.remove("outdated");
    this.#tell(takes ? "" : say("This is of scenes of one block; what was found of this one stands under Verdict."));
    this.body.hidden = !takes;
    if (solution === this.#drawn) return;
    if (this.#drawn !== null && shownOf(this.#drawn) !== shownOf(solution)) this.forget();
    this.#drawn = solution;
    if (!takes) return;
    this.place.dataset.scene = this.store.name;
    this.draw(solution);
    this.terms.forget();
  }

  /** There is no answer for the present text, or not yet. */
  #await() {
    const { problem, late, lastSolution, isOfSubject } = this.store;
    const hasLast = isOfSubject && lastSolution === this.#drawn && this.takes.includes(lastSolution.kind);
    // an answer comes within a few frames as a rule; until it is late the last one of the same scene stays as it is
    if (problem === null && !late && lastSolution !== null) return;
    this.place.classList.toggle("outdated", hasLast && (problem !== null || late));
    this.body.hidden = !hasLast;
    if (!hasLast) this.forget();
    if (problem !== null) this.#tell(say(hasLast ? "The scene has no answer now, see its message; this is the last one." : "The scene has no answer now, see its message."));
    else this.#tell(!late ? "" : hasLast ? say("The scene is being solved; this is the last answer.") : say("The scene is being solved."));
  }

  /** @param {string} words above it; "": none */
  #tell(words) {
    this.stale.textContent = words;
    this.stale.hidden = words === "";
  }
}
