// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Curves over one number of the scene: the governing factor of safety, or the tilts at which the block begins to move. Each
 * point is a solve of the core's `sweep`; first a few, then more between them.
 */

import { fosText } from "./certain.js";
import { element } from "./element.js";
import { drawChart, saveLink } from "./chart.js";
import { readTable } from "./csv.js";
import { Job } from "./job.js";
import { TILT, sceneNumbers, sweepable, usualRange } from "./numbers.js";
import { Panel } from "./panel.js";
import { againstText } from "./words.js";
import { numeral, say } from "../words/language.js";
import { refusalOf } from "../scene/complaint.js";

/** Points less one, from coarse to fine. */
const STEPS = [12, 60, 240];
/** A factor of safety beyond this is not drawn: near level it has no end. */
const FOS_MAX = 6;
const SWEEP_MAX_MS = 20_000;

const ANGLES = [
  { column: "certain_to_stand_deg", name: "certain to stand, α_s", colour: "--green" },
  { column: "limit_deg", name: "static limit, α_w", colour: "--vermilion" },
  { column: "moments_deg", name: "moments", colour: "--blue" },
  { column: "sliding_deg", name: "sliding, φ + i", colour: "--purple" },
];

export class CurvesPanel extends Panel {
  constructor(place, context) {
    super(place, context);
    const again = () => this.job.start(0);
    this.numberMenu = element("select", { onchange: again, "aria-label": "Over which number" });
    this.whatMenu = element(
      "select",
      { onchange: again, "aria-label": "What is drawn" },
      element("option", { value: "fos" }, say("factor of safety")),
      element("option", { value: "angles" }, say("critical tilts")),
    );
    this.chart = element("div", { class: "chart" });
    this.told = element("p", { class: "told" });
    this.body.append(
      element("p", { class: "choices" }, this.whatMenu, " " + say("over") + " ", this.numberMenu), this.chart, this.told,
    );
    this.job = new Job((current) => this.#compute(current), (error) => (this.told.textContent = error.message));
  }

  draw() {
    this.#list();
    this.job.start();
  }

  hidden() {
    this.job.stop();
  }

  forget() {
    this.job.stop();
    this.chart.replaceChildren();
    this.told.textContent = "…";
  }

  coloured() {
    this.job.start(0);
  }

  #list() {
    const chosen = this.numberMenu.value || TILT;
    this.numbers = sceneNumbers(this.store.parsed);
    this.numberMenu.replaceChildren(
      ...this.numbers.map(({ key }) => element("option", { value: key }, key === TILT ? say("the tilt") : key)),
    );
    this.numberMenu.value = this.numbers.some(({ key }) => key === chosen) ? chosen : TILT;
  }

  async #compute(current) {
    const number = this.numbers.find(({ key }) => key === this.numberMenu.value);
    if (number === undefined) return;
    const what = this.whatMenu.value;
    const { from, to } = usualRange(number, blockWidth(this.store));
    const files = { ...this.store.files, [this.store.name]: sweepable(this.store.parsed, null) };
    for (const count of STEPS) {
      const range = number.key + "=" + from + ":" + to + ":(" + to + "-(" + from + "))/" + count;
      const began = performance.now();
      const answer = await this.core.run(["sweep", this.store.argument, "--x", range, ...this.store.caseWords], files, { latest: "curves", timeoutMs: SWEEP_MAX_MS });
      if (!current()) return;
      if (answer.out === "") throw refusalOf(answer);
      this.#show(answer.out, number, what, performance.now() - began);
    }
  }

  #show(csv, number, what, milliseconds) {
    const rows = readTable(csv);
    const first = Object.keys(rows[0])[0];
    const directions = [...new Set(rows.map((row) => row.towards).filter((each) => each !== ""))];
    const x = [...new Set(rows.map((row) => Number(row[first])))];
    const curves = directions.flatMap((towards) => {
      const at = new Map(rows.filter((row) => row.towards === towards).map((row) => [Number(row[first]), row]));
      return what === "fos" ? [fosCurve(x, at, towards)] : angleCurves(x, at, directions.length > 1 ? say(towards) + ", " : "");
    });
    drawChart(this.chart, {
      x, curves, xLabel: number.key === TILT ? say("tilt α (degrees)") : first,
      yLabel: say(what === "fos" ? "factor of safety" : "tilt (degrees)"),
      yRange: what === "fos" ? [0, FOS_MAX] : [0, 90],
      marks: this.#marks(number, what),
    });
    this.told.replaceChildren(
      say("%s points in %s ms, each solved separately with its bounds:", x.length, milliseconds.toFixed(0)) + " ",
      saveLink("curve.csv", csv, say("the table as CSV")),
    );
  }

  #marks(number, what) {
    const marks = what === "fos" ? [{ y: 1, name: "1", colour: "--ink" }] : [];
    if (number.value !== null) marks.push({ x: number.value, name: say("the scene"), colour: "--ink" });
    if (number.key !== TILT || this.store.solution === null) return marks;
    for (const { onset, limit } of this.store.solution.cases) {
      if (onset?.critical_angle_deg) marks.push({ x: onset.critical_angle_deg.value, name: "α_s", colour: "--green" });
      if (onset?.below_limit && limit.critical_angle_deg) {
        marks.push({ x: limit.critical_angle_deg.value, name: "α_w", colour: "--vermilion" });
      }
    }
    return marks;
  }
}

function fosCurve(x, at, towards) {
  const fos = x.map((value) => (at.get(value)?.fos ? Number(at.get(value).fos) : null));
  return {
    name: say("FoS, tilted towards the " + towards), colour: towards === "left" ? "--blue" : "--orange",
    values: fos.map((value) => (value === null || value > FOS_MAX ? null : value)),
    told: (index) => {
      const row = at.get(x[index]);
      return say("%s against %s (%s)", fosText({ value: fos[index], error: Number(row.fos_error) }), againstText(row.fos_mechanism), say(row.fos_definition));
    },
  };
}

function angleCurves(x, at, prefix) {
  return ANGLES.map(({ column, name, colour }) => ({
    name: prefix + say(name), colour,
    values: x.map((value) => (at.get(value)?.[column] ? Number(at.get(value)[column]) : null)),
  }));
}

/** In scene lengths; 1 where it is not known yet. @param {import("../scene/store.js").SceneStore} store */
export function blockWidth(store) {
  const outlines = (store.solution ?? store.lastSolution)?.outlines;
  if (outlines === undefined) return 1;
  return (outlines.box_m[2] - outlines.box_m[0]) / outlines.placed.metres_per_unit;
}
