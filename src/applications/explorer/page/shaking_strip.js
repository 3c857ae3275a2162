// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The shaking under its film: accelerations over time with the moment that is shown, which a press leads to; and, asked for, which
 * multiples of this shaking overturn the block (`topple tilt --overturning`): a press on a range shakes it so. Ranges of a few
 * multiples are there after some seconds, and are replaced by those of the program's own grid, which may take a minute, or be stopped.
 */

import { element, refill, svgElement } from "../panels/element.js";
import { SceneText } from "../scene/scene_text.js";
import { agreesWith, shakingOf, timesStronger } from "../scene/shaking.js";
import { numeral, say } from "../words/language.js";
import { refusalOf } from "../scene/complaint.js";

const WIDTH = 1000;
const HEIGHT = 64;
const SEARCH_MAX_MS = 300_000;
const FEW = ["--factors=0.0625:16:17"];
const FINE_RUNS = 220; // of the program's own grid, about
const NEAR = 1.15;
const FACTORS = { from: 1 / 16, to: 16 }; // of the program's own first grid

/** A multiple within a range, near to the edge at which the block's fate changes. */
function within({ from, to, falls }) {
  const middle = Math.sqrt(from * to);
  return falls ? Math.min(middle, from * NEAR) : Math.max(middle, to / NEAR);
}

export class ShakingStrip {
  #end = 1;
  #searching = null; // what stops the search

  /** @param {HTMLElement} place @param {{store: object, searcher: object, messages: object, seek: (seconds: number) => void, again: () => void}} page */
  constructor(place, page) {
    Object.assign(this, page);
    this.cursor = svgElement("line", { class: "now", y1: 0, y2: HEIGHT });
    this.curves = svgElement("g", {});
    this.record = svgElement("svg", { class: "record", viewBox: "0 0 " + WIDTH + " " + HEIGHT, preserveAspectRatio: "none", role: "img",
      onpointerdown: (event) => this.#press(event), onpointermove: (event) => event.buttons === 1 && this.#press(event) }, this.curves, this.cursor);
    this.peak = element("span", { class: "quiet" });
    this.search = element("button", { type: "button", onclick: () => (this.#searching === null ? this.#search() : this.#searching.abort()) });
    this.#named();
    this.said = element("p", { class: "quiet", role: "status" });
    this.ranges = element("div", { class: "ranges", role: "group", "aria-label": "Multiples of this shaking" });
    this.box = element("div", { class: "shaking", hidden: true }, this.record, element("div", { class: "film-line" }, this.peak, this.search), this.ranges);
    place.append(this.box);
    this.key = "";
  }

  /** @param {any} shaking of the answer, peaks and durations; undefined: the table is tilted @param {number} end of the film, seconds */
  show(shaking, end) {
    this.box.hidden = shaking === undefined;
    if (shaking === undefined) return;
    this.#end = end;
    const found = ["horizontal", "vertical"].filter((way) => shaking[way]).map((way) => ({ way, series: shakingOf(this.store.parsed, this.store.files, way) }))
      .filter(({ way, series }) => series !== null && agreesWith(series, shaking[way].peak_g));
    const most = Math.max(...found.flatMap(({ series }) => series.g.map(Math.abs)), 1e-300);
    refill(this.curves, svgElement("path", { class: "zero", d: "M0 " + HEIGHT / 2 + "H" + WIDTH }), found.map(({ way, series }) => svgElement("path", { class: way, d: this.#path(series, most) })));
    const told = ["horizontal", "vertical"].filter((way) => shaking[way]).map((way) => say(way) + " " + numeral(shaking[way].peak_g.toPrecision(4)) + " g");
    this.peak.textContent = say("Greatest acceleration: %s", told.join(", "));
    this.record.setAttribute("aria-label", say("The shaking over time"));
    if (this.#shape() === this.key) return;
    this.#searching?.abort();
    this.ranges.replaceChildren();
  }

  put(seconds) {
    const x = String((WIDTH * Math.min(seconds, this.#end)) / this.#end);
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
  }

  #path({ t, g }, most) {
    return t.map((each, k) => (k === 0 ? "M" : "L") + ((WIDTH * each) / this.#end).toFixed(2) + " " + (HEIGHT / 2 - (0.47 * HEIGHT * g[k]) / most).toFixed(2)).join("");
  }

  #press(event) {
    const { left, width } = this.record.getBoundingClientRect();
    this.seek(Math.max(0, Math.min(1, (event.clientX - left) / width)) * this.#end);
  }

  /** The scene but for how strongly it is shaken: as long as it is the same, ranges that were found hold. */
  #shape() {
    const { parsed } = this.store;
    try {
      return parsed.withNumbers(timesStronger(parsed, 1).map(({ path }) => ({ path, text: "1" })));
    } catch (error) {
      if (error instanceof RangeError) return parsed.text;
      throw error;
    }
  }

  async #search() {
    const scene = new SceneText(this.store.text);
    const control = (this.#searching = new AbortController());
    this.#named();
    this.key = this.#shape();
    this.ranges.textContent = say("Multiples from 1/16 to 16 are tried …");
    try {
      const begin = performance.now();
      const few = await this.#scan(FEW, scene, control.signal);
      const seconds = ((performance.now() - begin) / 1000 / few.runs) * FINE_RUNS;
      this.#offer(few, scene, say("Coarse, of %s multiples: press a range to see it. More are tried, for some %s s.", few.runs, Math.ceil(seconds)));
      this.#offer(await this.#scan([], scene, control.signal), scene, say("Of those tried, from 1/16 to 16 times: press a range to see it."));
    } catch (error) {
      if (error.name !== "AbortError") this.ranges.textContent = error.message;
      else if (this.ranges.contains(this.said)) this.said.textContent = say("Coarse: the search was stopped. Press a range to see it.");
      else this.ranges.replaceChildren();
    } finally {
      this.#searching = null;
      this.#named();
    }
  }

  /** @returns the case of the answer */
  async #scan(more, scene, signal) {
    const { store, searcher } = this;
    const answer = await searcher.run(["tilt", "--overturning", "--json", ...more, ...store.caseWords, store.argument], { ...store.files, [store.name]: scene.text }, { timeoutMs: SEARCH_MAX_MS, signal });
    if (answer.out === "") throw refusalOf(answer);
    return JSON.parse(answer.out).cases[0];
  }

  #named() {
    this.search.textContent = say(this.#searching === null ? "What overturns it?" : "Stop the search");
  }

  /** Ranges that overturn it, and those between, as buttons on a bar; the multiples are of the scene as it was asked for. */
  #offer({ overturning_ranges: ranges = [] }, scene, words) {
    const parts = [];
    let at = FACTORS.from;
    for (const { least, most } of ranges) {
      if (least > at) parts.push({ from: at, to: least, falls: false });
      parts.push({ from: least, to: most, falls: true });
      at = most;
    }
    if (at < FACTORS.to) parts.push({ from: at, to: FACTORS.to, falls: false });
    const share = ({ from, to }) => Math.log(to / from) / Math.log(FACTORS.to / FACTORS.from);
    const short = (value) => numeral(Number(value.toPrecision(3)) + "");
    this.said.textContent = words;
    this.ranges.replaceChildren(
      element("div", { class: "range-bar" }, parts.map((part) => {
        const words = say(part.falls ? "overturned by %s to %s times" : "spared by %s to %s times", short(part.from), short(part.to));
        return element("button", { type: "button", class: part.falls ? "falls" : "spared", style: "flex-grow:" + share(part).toFixed(5), title: words, "aria-label": words, onclick: () => this.#shake(scene, within(part)) });
      })),
      this.said,
    );
  }

  #shake(scene, factor) {
    try {
      this.store.setNumbers(timesStronger(scene, factor));
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      this.messages.say(error.message);
      return;
    }
    this.store.addEventListener("solution", () => this.again(), { once: true });
  }
}
