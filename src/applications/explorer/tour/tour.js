// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The guided tour: a step at a time, each with its scene, what to try on it, and what is found. */

import { element } from "../panels/element.js";
import { STEPS } from "./steps.js";
import { tableThree } from "./table_3.js";
import { say } from "../words/language.js";

export class Tour {
  #at = -1;

  /**
   * @param {HTMLElement} place
   * @param {HTMLElement} beginPlace where the button that begins it stands
   * @param {object} page
   * @param {import("../scene/store.js").SceneStore} page.store
   * @param {{run: Function}} page.core
   * @param {{open: (name: string) => void}} page.menu
   * @param {import("../panels/tabs.js").Tabs} page.tabs
   */
  constructor(place, beginPlace, { store, core, menu, tabs }) {
    Object.assign(this, { store, core, menu, tabs });
    this.begin = element("button", { type: "button", onclick: () => this.go(0) }, say("Guided tour: seven steps"));
    this.steps = element(
      "ol", { "aria-label": "Steps" },
      STEPS.map(({ title }, at) => element("li", {}, element("button", { type: "button", title, "aria-label": at + 1 + ". " + title, onclick: () => this.go(at) }, at + 1))),
    );
    this.back = element("button", { type: "button", onclick: () => this.go(this.#at - 1) }, say("Back"));
    this.next = element("button", { type: "button", onclick: () => this.go(this.#at + 1) }, say("Next"));
    this.end = element("button", { type: "button", onclick: () => this.leave() }, say("End the tour"));
    this.heading = element("h2", { tabindex: -1 });
    this.said = element("div", {});
    this.found = element("p", { class: "found", role: "status", "aria-live": "polite", hidden: true });
    this.shown = element(
      "div", { hidden: true },
      element("p", { class: "steps" }, this.steps, this.back, this.next), this.heading, this.said, this.found,
    );
    this.end.hidden = true;
    beginPlace.append(this.begin, this.end);
    place.append(this.shown);
    store.addEventListener("solution", () => this.#find());
    for (const event of ["problem", "late"]) store.addEventListener(event, () => (this.found.hidden = true));
    store.addEventListener("text", () => store.lastSolution === null && (this.found.hidden = true));
  }

  /** @param {number} at */
  go(at) {
    const step = STEPS[at];
    this.#at = at;
    this.begin.hidden = true;
    this.end.hidden = false;
    this.shown.hidden = false;
    document.body.classList.add("touring");
    this.back.disabled = at === 0;
    this.next.disabled = at === STEPS.length - 1;
    [...this.steps.children].forEach((item, index) => {
      if (index === at) item.firstChild.setAttribute("aria-current", "step");
      else item.firstChild.removeAttribute("aria-current");
    });
    this.heading.textContent = at + 1 + ". " + step.title;
    this.said.replaceChildren(
      ...step.says.map((text) => element("p", {}, text)),
      element("p", { class: "choices" }, step.tries.map((each) => element("button", { type: "button", onclick: () => this.#try(each) }, each.label))),
    );
    this.found.hidden = true;
    const panel = this.tabs.panel(step.tab);
    this.menu.open(step.example);
    if (step.begins !== undefined) this.#try({ numbers: step.begins });
    if (step.across !== undefined) panel.across(step.across);
    if (step.table === true) this.#table(at);
    this.heading.focus();
  }

  leave() {
    this.#at = -1;
    this.shown.hidden = true;
    document.body.classList.remove("touring");
    this.begin.hidden = false;
    this.end.hidden = true;
    this.begin.focus();
  }

  #try({ example, numbers }) {
    if (example !== undefined) this.menu.open(example);
    if (numbers !== undefined) numbers.forEach(({ path, text }) => this.store.setNumber(path, text, { mergeWith: "tour" }));
    this.store.endGesture();
  }

  async #table(at) {
    const room = element("div", {}, "…");
    this.said.append(room);
    try {
      const solved = await tableThree(this.core, (name) => this.menu.open(name));
      if (this.#at === at) room.replaceChildren(solved);
    } catch (error) {
      room.textContent = error.message;
    }
  }

  #find() {
    if (this.#at < 0 || this.store.solution === null) return;
    const text = STEPS[this.#at].finds(this.store.solution);
    this.found.hidden = text === null;
    this.found.textContent = text ?? "";
  }
}
