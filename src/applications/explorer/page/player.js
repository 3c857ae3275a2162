// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The tilt test, played: a button that runs it in the core, a slider of its time, slow motion, and its events by name. */

import { Film } from "../drawing/film.js";
import { FilmView } from "../drawing/film_view.js";
import { element } from "../panels/element.js";
import { ShakingStrip } from "./shaking_strip.js";
import { numeral, say } from "../words/language.js";
import { refusalOf } from "../scene/complaint.js";

const TEST_MAX_MS = 60_000;
const MOMENTS = 1200;
const SPEEDS = [["as it is", 1], ["2 times slower", 2], ["5 times slower", 5], ["20 times slower", 20]];
const FIRST_SPEED = 2;
const EVENTS_MAX = 40;
const STEPS = 2000;

export class Player {
  #film = null;
  #frame = 0;
  #beginning = false; // many blocks begin to move
  #shown = 0; // seconds of the film
  #asked = 0;

  /** @param {HTMLButtonElement} button @param {HTMLElement} place @param {{drawing: object, store: object, core: object, searcher: object, messages: object}} page searcher: a core for what takes minutes, while others play */
  constructor(button, place, { drawing, store, core, searcher, messages }) {
    Object.assign(this, { button, place, drawing, store, core, messages, view: new FilmView(drawing) });
    this.slider = element("input", { type: "range", min: 0, max: STEPS, step: 1, value: 0, "aria-label": "Time of the test", oninput: () => this.#seek() });
    this.pause = element("button", { type: "button", onclick: () => (this.#frame === 0 ? this.#run() : this.#halt()) }, say("Pause"));
    this.speed = element("select", { "aria-label": "Speed of the fall" }, SPEEDS.map(([name, times]) => element("option", { value: times, ...(times === FIRST_SPEED ? { selected: true } : {}) }, say(name))));
    this.said = element("output", { class: "film-said" });
    this.events = element("div", { class: "events", role: "group", "aria-label": "Events of the test" });
    place.append(element("div", { class: "film-line" }, this.pause, this.slider, this.speed, this.said));
    const seek = (seconds) => {
      this.#halt();
      this.#put(seconds);
    };
    this.strip = new ShakingStrip(place, { store, searcher, messages, seek, again: () => this.play() });
    place.append(this.events);
    button.addEventListener("click", () => (store.solution?.kind === "blocks" ? this.#begins(!this.#beginning) : this.#film === null ? this.play() : this.end()));
    this.speed.addEventListener("change", () => this.#put(this.#film.timeAt(this.#shown, this.#slowBefore)));
    store.addEventListener("text", () => this.end());
    for (const event of ["text", "solution", "problem"]) store.addEventListener(event, () => this.#canPlay());
  }

  get slow() {
    return Number(this.speed.value);
  }

  async play() {
    const asked = ++this.#asked;
    const { store } = this;
    this.button.disabled = true;
    try {
      // the strip of shaking tries smaller factors
      const args = ["tilt", "--json", "--smaller=0", "--moments=" + MOMENTS, ...store.caseWords, store.argument];
      const answer = await this.core.run(args, { ...store.files, [store.name]: testedText(store.parsed) }, { latest: "tilt", timeoutMs: TEST_MAX_MS });
      if (asked !== this.#asked) return;
      if (answer.out === "") throw refusalOf(answer);
      this.#begin(JSON.parse(answer.out));
    } catch (error) {
      if (asked === this.#asked && error.name !== "AbortError") this.messages.say(say("The test cannot be played: %s", error.message));
    } finally {
      this.#canPlay();
    }
  }

  end() {
    this.#asked++;
    this.#begins(false);
    if (this.#film === null) return;
    this.#halt();
    this.#film = null;
    this.place.hidden = true;
    this.#named();
    this.view.leave();
  }

  #begin({ cases, shaking }) {
    const { drawing } = this;
    const kase = cases.find(({ towards }) => towards === drawing.case?.towards) ?? cases[0];
    if ((kase.moments ?? []).length < 2) throw new Error(say("its answer has no moments"));
    const isShaken = this.store.parsed.keys(["shaking"]) !== null;
    const [x0, y0, x1, y1] = drawing.store.lastSolution.outlines.box_m;
    this.#film = new Film(kase, isShaken, Math.hypot(x1 - x0, y1 - y0));
    this.speed.hidden = this.#film.course === "tilt"; // what knows no time has no speed
    this.events.replaceChildren(...this.#film.events.slice(0, EVENTS_MAX).map((event) => this.#eventButton(event, isShaken)));
    this.strip.show(shaking, this.#film.end);
    this.place.hidden = false;
    this.#named();
    this.view.enter(this.#film);
    this.#shown = 0;
    // who asked for less motion gets the moment at which it begins, and the slider
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) this.#put(this.#film.begins);
    else this.#run();
  }

  /** An event by where it is: at its tilt, or where the table is level and shaken at its time. */
  #eventButton(event, isShaken) {
    const at = isShaken ? numeral(event.time_s.toFixed(2)) + " s" : numeral(event.angle_deg.toFixed(2)) + "°";
    const what = event.facet > 0 ? say("%s at facet %s", say(event.what), event.facet) : say(event.what);
    const go = () => {
      this.#halt();
      this.#put(this.#film.courseOf(event));
    };
    return element("button", { type: "button", class: "event", onclick: go }, what + ", " + at);
  }

  #run() {
    if (this.#shown >= this.#film.length(this.slow)) this.#shown = 0;
    let last = null;
    const step = (now) => {
      this.#shown = Math.min(this.#film.length(this.slow), this.#shown + (last === null ? 0 : (now - last) / 1000));
      last = now;
      this.#frame = requestAnimationFrame(step);
      this.#put(this.#film.timeAt(this.#shown, this.slow));
      if (this.#shown >= this.#film.length(this.slow)) this.#halt();
    };
    this.#frame = requestAnimationFrame(step);
    this.pause.textContent = say("Pause");
  }

  #halt() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.pause.textContent = say("Play");
  }

  #seek() {
    this.#halt();
    this.#put(this.#film.timeAt((this.slider.valueAsNumber / STEPS) * this.#film.length(this.slow), this.slow));
  }

  /** The block at a time of the test. */
  #put(time) {
    const film = this.#film;
    this.#shown = film.shownAt(time, this.slow);
    this.#slowBefore = this.slow;
    this.slider.value = String(Math.round((STEPS * this.#shown) / film.length(this.slow)));
    const event = film.eventAt(time);
    const pose = film.poseAt(time);
    const tilt = numeral(pose.tilt.toFixed(2)) + "°";
    const said = (film.course === "tilt" ? say("tilt %s", tilt) : say("%s s, tilt %s", numeral(time.toFixed(2)), tilt)) + (event === null ? "" : ": " + say(event.what));
    this.said.textContent = said;
    this.slider.setAttribute("aria-valuetext", said);
    const at = event === null ? -1 : film.events.indexOf(event);
    [...this.events.children].forEach((button, index) => button.setAttribute("aria-current", String(index === at)));
    this.strip.put(time);
    this.view.show(film, time);
  }

  #slowBefore = FIRST_SPEED;

  /** Of many blocks: their mechanism, drawn over and over. */
  #begins(beginning) {
    this.#beginning = beginning;
    this.drawing.svg.classed("beginning", beginning);
    this.#named();
  }

  #named() {
    const playing = this.#film !== null || this.#beginning;
    this.button.setAttribute("aria-pressed", String(playing));
    this.button.textContent = say(this.#words(playing));
  }

  #words(playing) {
    const { lastSolution, parsed } = this.store;
    if (lastSolution?.kind === "blocks") return playing ? "Stop the motion" : "Show how it begins to move";
    return playing ? "Leave the test" : parsed.keys(["shaking"]) === null ? "Tilt it until it falls" : "Shake it";
  }

  #canPlay() {
    this.#named();
    const { solution } = this.store;
    const moves = solution?.kind === "block" || (this.drawing.case?.motions ?? []).some(({ mechanism }) => mechanism !== "stands");
    this.button.disabled = this.#film === null && !(solution !== null && moves);
  }
}

/** The scene with a test, where it asks for none: the table rises from level, and the block moves on rigid contacts. */
export function testedText(scene) {
  const keys = scene.keys([]) ?? [];
  if (keys.includes("tilt_test") || keys.includes("shaking")) return scene.text;
  return scene.withNumbers([{ path: ["tilt_test", "engine"], text: "dynamics" }]);
}
