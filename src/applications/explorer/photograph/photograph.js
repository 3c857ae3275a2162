// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A block traced over a photograph: two points of a known distance, two of a plumb line, the outline, and where the contact
 * ends; then the scene that `topple trace` writes for these clicks, with the photograph behind its drawing. The photograph stays in
 * this page alone: it goes into no link and is not kept.
 */

import { element } from "../panels/element.js";
import { decimalValue } from "../scene/decimal.js";
import { UNITS } from "../scene/length_units.js";
import { say } from "../words/language.js";
import { PhotoView } from "./photo_view.js";
import { placing, traceScene } from "./trace_scene.js";

const PICTURE = /\.(png|jpe?g)$/i;
const STEPS = [
  { list: "scale", label: "1. Scale", most: 2, says: "Click two points whose distance is known, as the ends of a rod, and type the distance." },
  { list: "plumb", label: "2. Plumb line", most: 2, says: "Click two points of a line that hangs down; leave it out where the picture was held upright." },
  { list: "outline", label: "3. Outline", most: Infinity, says: "Click round the block once; a click on the first point closes it." },
  { list: "between", label: "4. Contact", most: 2, says: "Click where the contact with the ground begins and ends." },
];

export class Photograph {
  #step = 0;
  #opening = -1; // the scene that was made of it

  /** @param {{stage: HTMLElement, place: HTMLElement, button: HTMLButtonElement, drawing: object, store: object, messages: object}} page */
  constructor({ stage, place, button, drawing, store, messages }) {
    Object.assign(this, { stage, place, button, drawing, store, messages });
    this.view = new PhotoView(stage, { put: (point) => this.#put(point), gone: (list, at) => this.#gone(list, at), ended: () => this.#go(3) });
    const field = (label, size, value = "") => element("input", { type: "text", inputmode: "decimal", size, "aria-label": label, value, autocomplete: "off" });
    this.length = field("Distance of the two points of the scale", 6, "1");
    this.unit = element("select", { "aria-label": "Unit of the distance" }, Object.keys(UNITS).map((name) => element("option", name === "m" ? { selected: true } : {}, name)));
    this.friction = field("Friction angle, °", 4);
    this.weight = field("Unit weight, kN/m³", 4);
    this.steps = STEPS.map(({ label }, at) => element("button", { type: "button", onclick: () => this.#go(at) }, say(label)));
    this.said = element("output", { class: "film-said", "aria-live": "polite" });
    place.append(
      element("div", { class: "photo-line" }, this.steps, element("button", { type: "button", onclick: () => this.#back() }, say("Take back")), this.said),
      element("div", { class: "photo-line" }, element("label", {}, say("Distance") + " ", this.length), this.unit, element("label", {}, say("Friction angle, °") + " ", this.friction),
        element("label", {}, say("Unit weight, kN/m³") + " ", this.weight), element("button", { type: "button", class: "main", onclick: () => this.#make() }, say("Make the scene")),
        element("button", { type: "button", onclick: () => this.#show(false) }, say("Leave the photograph"))),
    );
    button.addEventListener("click", () => this.#show(true));
    store.addEventListener("text", () => {
      if (store.openings !== this.#opening) drawing.setPhotograph(null);
    });
  }

  /** @param {File} file @returns {boolean} whether it is a photograph, which is then shown */
  take(file) {
    if (!PICTURE.test(file.name)) return false;
    this.#open(file);
    return true;
  }

  async #open(file) {
    const href = URL.createObjectURL(file);
    const image = new Image();
    image.src = href;
    try {
      await image.decode();
    } catch {
      this.messages.say(say("%s is no picture that this browser can show.", file.name));
      return;
    }
    const bytes = await file.arrayBuffer();
    const hash = globalThis.crypto?.subtle === undefined ? null
      : [...new Uint8Array(await crypto.subtle.digest("SHA-256", bytes))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    this.name = file.name.replace(/\p{C}/gu, "?");
    Object.assign(this, { hash, picture: { href, width: image.naturalWidth, height: image.naturalHeight } });
    this.lists = { scale: [], plumb: [], outline: [], between: [] };
    this.button.hidden = false;
    this.#show(true);
    this.view.show(this.picture);
    this.#go(0);
  }

  #show(shown) {
    document.body.classList.toggle("tracing", shown);
    this.stage.hidden = this.place.hidden = !shown;
    if (shown) this.view.fit();
  }

  #go(at) {
    this.#step = at;
    this.steps.forEach((button, index) => button.setAttribute("aria-pressed", String(index === at)));
    this.said.textContent = say(STEPS[at].says);
    this.view.draw(this.lists);
  }

  #put(point) {
    const { list, most } = STEPS[this.#step];
    if (this.lists[list].length >= most) this.lists[list] = [];
    this.lists[list].push(point);
    this.#go(this.lists[list].length === most && this.#step + 1 < STEPS.length ? this.#step + 1 : this.#step);
  }

  #gone(list, at) {
    this.lists[list].splice(at, 1);
    this.view.draw(this.lists);
  }

  #back() {
    const from = [...STEPS].slice(0, this.#step + 1).reverse().find(({ list }) => this.lists[list].length > 0);
    if (from === undefined) return;
    this.lists[from.list].pop();
    this.#go(STEPS.indexOf(from));
  }

  #make() {
    const number = (field) => field.value.trim().replace(",", ".");
    try {
      const length = decimalValue(number(this.length));
      if (this.lists.scale.length < 2 || !(length > 0)) throw new RangeError(say("the scale needs two points and their distance"));
      for (const field of [this.friction, this.weight]) if (number(field) !== "" && decimalValue(number(field)) === null) throw new RangeError(say("not a number") + ": " + field.value);
      const pair = (list) => (this.lists[list].length === 2 ? this.lists[list] : []);
      const traced = { image: this.name, hash: this.hash, outline: this.lists.outline.map((each) => ({ ...each })), scale: this.lists.scale, length, unit: this.unit.value,
        plumb: pair("plumb"), between: pair("between"), friction: number(this.friction), unitWeight: number(this.weight) };
      const text = traceScene(traced);
      const place = placing(traced);
      this.#show(false);
      this.store.open({ name: this.name.replace(/\.\w+$/, "") + ".yaml", text, files: {} });
      this.#opening = this.store.openings;
      this.drawing.setPhotograph({ ...this.picture, corners: [[0, 0], [1, 0], [0, 1]].map(([x, y]) => place({ x, y })) });
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      this.messages.say(say("No scene yet: %s", error.message));
    }
  }
}
