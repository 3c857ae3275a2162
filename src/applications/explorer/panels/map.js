// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The mechanism map over two numbers of the scene: what the block does at the scene's tilt where that is one of them,
 * else what begins to move first. Points come from the core's `sweep`, borders, proven, from its `chart map`.
 */

import { element } from "./element.js";
import { readTable } from "./csv.js";
import { Job } from "./job.js";
import { shortNumber } from "./chart.js";
import { snap, stepExponent } from "../scene/decimal.js";
import { blockWidth } from "./curves.js";
import { MapFigure } from "./map_figure.js";
import { MapGrid } from "./map_grid.js";
import { TILT, sceneNumbers, sweepable, usualRange } from "./numbers.js";
import { Panel } from "./panel.js";
import { COLOUR_CLASS } from "./words.js";
import { numeral, parts, say } from "../words/language.js";
import { readComplaint, refusalOf } from "../scene/complaint.js";

/** Points along each side: 200 cells. */
const POINTS = 201;
const ROW_MAX_MS = 20_000;
const BORDERS_MAX_MS = 120_000;
const NO_ANSWER = "no answer";
const KINDS = [
  "", "stands", "may move", "slides", "topples", "slides and topples", "leaves its base", "interlocked", "holds nowhere", "undecided", NO_ANSWER,
];

export class MapPanel extends Panel {
  #key = "";
  /** The number that is to run across, where it was asked for. @type {string|null} */
  wanted = null;

  constructor(place, context) {
    super(place, context);
    const again = () => this.#choose();
    this.xMenu = element("select", { onchange: again, "aria-label": "Across" });
    this.yMenu = element("select", { onchange: again, "aria-label": "Upwards" });
    this.towardsMenu = element("select", { onchange: again, "aria-label": "Direction of tilt" });
    this.told = element("p", { class: "told" });
    this.there = element("p", { class: "pointed" });
    this.legend = element("p", { class: "legend" });
    const room = element("div", {});
    this.body.append(
      element("p", { class: "choices" }, parts("%s across, %s upwards, %s", this.xMenu, this.yMenu, this.towardsMenu)),
      room, this.there, this.legend, this.told,
    );
    this.figure = new MapFigure(room, {
      moved: (x, y) => this.#moveScene(x, y),
      left: () => this.store.endGesture(),
      pointed: (x, y) => this.#tell(x, y),
    });
    this.job = new Job((current, signal) => this.#compute(current, signal), (error) => (this.told.textContent = error.message));
  }

  draw(solution) {
    this.#list(solution);
    this.#choose();
  }

  hidden() {
    this.job.stop();
    this.#key = "";
  }

  forget() {
    this.hidden();
    this.grid = undefined;
    this.figure.clear();
    this.legend.replaceChildren();
    this.told.textContent = this.there.textContent = "";
  }

  coloured() {
    this.colours = undefined;
    if (this.grid !== undefined) this.figure.setPlane(this.grid, (kind) => this.#colour(kind));
  }

  /** Let this number run across, and the tilt upwards. @param {string} key */
  across(key) {
    this.wanted = key;
    if (this.store.solution !== null) this.draw(this.store.solution);
  }

  #list(solution) {
    this.numbers = sceneNumbers(this.store.parsed);
    const keys = this.numbers.map(({ key }) => key);
    const friction = keys.find((key) => key.endsWith("friction_angle_deg"));
    const shape = keys.find((key) => this.numbers.find((number) => number.key === key).path[0] === "parameters");
    fillMenu(this.towardsMenu, solution.cases.map(({ towards }) => towards), solution.cases[0].towards);
    fillMenu(this.xMenu, keys, shape ?? friction ?? keys[1] ?? TILT);
    fillMenu(this.yMenu, keys, TILT);
    if (!keys.includes(this.wanted)) return;
    [this.xMenu.value, this.yMenu.value] = [this.wanted, TILT];
    this.wanted = null;
  }

  /** The plane does not depend on the two numbers themselves, nor on the tilt: as they are dragged it stays. */
  #choose() {
    const chosen = [this.xMenu, this.yMenu].map((menu) => this.numbers.find(({ key }) => key === menu.value));
    if (chosen.includes(undefined) || chosen[0] === chosen[1]) {
      this.told.textContent = say("Two different numbers span a map.");
      return;
    }
    [this.x, this.y] = chosen;
    const text = sweepable(this.store.parsed, this.towardsMenu.value);
    const free = new Set([...chosen, this.numbers[0]]); // the tilt is an axis, or has no say in what begins to move first
    const plane = new this.store.parsed.constructor(text).withNumbers([...free].map(({ path }) => ({ path, text: "0" })));
    const key = JSON.stringify([plane, this.x.key, this.y.key, this.store.caseWords]);
    if (key !== this.#key) {
      this.#key = key;
      this.scene = text;
      const width = blockWidth(this.store);
      this.axes = chosen.map((number) => ({ name: axisName(number), ...holding(usualRange(number, width), number.value) }));
      this.figure.setAxes(...this.axes);
      this.figure.setBorders([]);
      this.job.start();
    }
    this.figure.setPoint(this.x.value, this.y.value);
  }

  async #compute(current, signal) {
    const files = { ...this.store.files, [this.store.name]: this.scene };
    const [xAxis, yAxis] = this.axes;
    const [x, y] = [values(xAxis), values(yAxis)];
    const onTilt = [this.x.key, this.y.key].includes(TILT);
    const grid = new MapGrid(POINTS, POINTS);
    const began = performance.now();
    const solve = async (rows, columns) => {
      const list = (number, all, chosen) => number.key + "=" + chosen.map((at) => all[at]).join(",");
      const args = ["sweep", this.store.argument, "--x", list(this.x, x, columns), "--y", list(this.y, y, rows), ...this.store.caseWords];
      const answer = await this.background.run(args, files, { timeoutMs: ROW_MAX_MS });
      if (!current()) return false;
      if (answer.out === "") throw refusalOf(answer);
      readTable(answer.out).forEach((point, index) => {
        grid.put(columns[index % columns.length], rows[Math.floor(index / columns.length)], kindOf(point, onTilt));
      });
      return true;
    };
    await grid.refine(solve, () => this.#show(grid, performance.now() - began));
    if (current()) await this.#borders(current, files, signal);
  }

  #show(grid, milliseconds) {
    this.grid = grid;
    this.figure.setPlane(grid, (kind) => this.#colour(kind));
    const there = new Set(grid.kinds);
    this.legend.replaceChildren(
      ...KINDS.map((name, kind) =>
        there.has(kind) && kind > 0
          ? element("span", { class: "key" }, element("span", { class: "swatch " + (COLOUR_CLASS[name] ?? "undecided") }), say(name) + " ")
          : "",
      ),
    );
    const what = [this.x.key, this.y.key].includes(TILT) ? say("The verdict at each tilt.") : say("The first motion as the table is tilted.");
    this.points = what + " " + say("%s × %s cells in %s s: %s points solved, the others lie in cells whose solved points agree.", POINTS - 1, POINTS - 1,
      numeral((milliseconds / 1000).toFixed(2)), grid.count);
    this.told.textContent = this.points;
    this.told.dataset.milliseconds = milliseconds.toFixed(0);
  }

  async #borders(current, files, signal) {
    this.told.textContent = this.points + " " + say("Proven borders are being found …");
    const side = ({ key }, { from, to }) => (key === TILT ? "tilt" : key) + "=" + from + ":" + to;
    const args = ["chart", "map", "--json", this.store.argument, "--x", side(this.x, this.axes[0]), "--y", side(this.y, this.axes[1]), ...this.store.caseWords];
    if (![this.x.key, this.y.key].includes(TILT)) args.push("--any-tilt");
    const answer = await this.background.run(args, files, { timeoutMs: BORDERS_MAX_MS, signal });
    if (!current()) return;
    if (answer.out !== "") this.figure.setBorders(JSON.parse(answer.out).series);
    this.told.textContent = this.points + " " + (answer.out === "" ? say("No borders: %s", readComplaint(answer.err).message) : say("Lines are proven: roots, not points."));
  }

  /** What the plane says under the pointer. */
  #tell(x, y) {
    if (this.grid === undefined || this.axes === undefined) return;
    const at = (value, { from, to }) => Math.round(((value - from) / (to - from)) * (POINTS - 1));
    const kind = this.grid.kinds[at(y, this.axes[1]) * POINTS + at(x, this.axes[0])];
    const named = (number, value) => (number.key === TILT ? say("tilt") : number.key) + " " + shortNumber(Number(value.toPrecision(3)));
    this.there.textContent = named(this.x, x) + ", " + named(this.y, y) + ": " + (say(KINDS[kind]) || "…");
  }

  #colour(kind) {
    this.colours ??= new Map();
    if (!this.colours.has(kind)) {
      const name = "--map-" + (COLOUR_CLASS[KINDS[kind]] ?? "undecided");
      const hex = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
      const digits = /^#([0-9a-f]{6})$/i.exec(hex)?.[1] ?? "808080";
      this.colours.set(kind, [0, 2, 4].map((at) => parseInt(digits.slice(at, at + 2), 16)));
    }
    return this.colours.get(kind);
  }

  #moveScene(x, y) {
    const edits = [[this.x, x, this.axes[0]], [this.y, y, this.axes[1]]].map(([number, value, axis]) => ({
      path: number.path, text: snap(value, stepExponent((axis.to - axis.from) / 400, 1)),
    }));
    this.store.setNumbers(edits, { mergeWith: "map" });
  }
}

/** A fraction of the program's own kind, so that each point is exact. */
function values({ from, to }) {
  return Array.from({ length: POINTS }, (_, index) => from + "+(" + to + "-(" + from + "))*" + index + "/" + (POINTS - 1));
}

function kindOf(point, onTilt) {
  if (point.status !== "done" && !point.status.startsWith("undecided")) return KINDS.indexOf(NO_ANSWER);
  const kind = KINDS.indexOf(onTilt ? point.verdict : point.first);
  return kind > 0 ? kind : KINDS.indexOf("undecided");
}

/** The present number is on the map. */
function holding({ from, to }, value) {
  return value === null ? { from, to } : { from: Math.min(from, value), to: Math.max(to, value) };
}

function axisName({ key }) {
  return key === TILT ? say("tilt α (degrees)") : key;
}

function fillMenu(menu, names, usual) {
  const chosen = names.includes(menu.value) ? menu.value : usual;
  menu.replaceChildren(...names.map((name) => element("option", { value: name }, name === TILT ? say("the tilt") : say(name))));
  menu.value = chosen;
}
