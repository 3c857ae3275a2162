// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What accuracy costs, measured on the reader's own machine: certain digits against the time that they take. */

import { element, table } from "./element.js";
import { boundText } from "./certain.js";
import { drawChart, saveLink } from "./chart.js";
import { Panel } from "./panel.js";
import { shortestTime } from "./shortest_time.js";
import { numeral, parts, say } from "../words/language.js";
import { refusalOf } from "../scene/complaint.js";

const MEASURE_MAX_MS = 120_000;
const COLOURS = ["--blue", "--vermilion", "--green", "--purple", "--orange", "--sky"];

export class AccuracyPanel extends Panel {
  #text = null;

  constructor(place, context) {
    super(place, context);
    this.chart = element("div", { class: "chart" });
    this.told = element("p", { class: "told", role: "status" });
    this.rows = element("div", {});
    this.button = element("button", { type: "button", onclick: () => this.measure() }, say("Measure on this machine"));
    this.body.append(
      element(
        "p", {}, parts("Each method for the critical angle, the static limit and the onset is evaluated at every %s, timed, and compared with its value at 6144 bits.",
          this.terms.word("level")),
      ),
      element("p", { class: "choices" }, this.button), this.told, this.chart, this.rows,
    );
  }

  /** Measured when it is first shown; again when asked, for times are worth nothing beside a drag. */
  draw() {
    if (this.#text === null) this.measure();
    else if (this.#text !== this.store.text) this.told.textContent = say("The scene has changed since it was measured.");
  }

  coloured() {
    if (this.measured !== undefined) this.#show(this.measured);
  }

  async measure() {
    if (this.button.disabled) return;
    this.button.disabled = true;
    this.#text = this.store.text;
    this.told.textContent = say("Measuring: five samples of each …");
    try {
      const answer = await this.background.run(["accuracy", "--json", ...this.store.caseWords, this.store.argument], this.files(), { latest: "accuracy", timeoutMs: MEASURE_MAX_MS });
      if (answer.out === "") throw refusalOf(answer);
      this.#show(answer.out);
    } catch (error) {
      this.told.textContent = error.message;
      this.#text = null;
    } finally {
      this.button.disabled = false;
    }
  }

  #show(json) {
    this.measured = json;
    const runs = JSON.parse(json).runs.filter(({ bound_log10: digits }) => digits !== null && digits !== undefined && digits < 0);
    const methods = [...new Set(runs.map(({ method }) => method))];
    const shortest = shortestTime(runs);
    const time = ({ seconds }) => Math.max(seconds, shortest) * 1e6;
    const times = [...new Set(runs.map(time))].sort((a, b) => a - b);
    drawChart(this.chart, {
      x: times, xLabel: say("microseconds"), yLabel: say("certain digits"), logarithmic: true,
      curves: methods.map((method, at) => {
        const own = new Map(runs.filter((run) => run.method === method).map((run) => [time(run), -run.bound_log10]));
        return { name: say(method), colour: COLOURS[at % COLOURS.length], dots: true, values: times.map((each) => own.get(each) ?? null) };
      }),
    });
    this.rows.replaceChildren(
      table(say("Measurements"), ["way", "level", "bits", "microseconds", "certain digits", "bound (degrees)"].map((head) => say(head)), runs.map((run) => ({
        cells: [say(run.method), say(run.level), run.bits, (run.seconds < shortest ? "< " : "") + numeral(time(run).toPrecision(3)), Math.floor(-run.bound_log10), boundOf(run)],
      }))),
    );
    this.told.replaceChildren(say("Measured in this browser.") + " ", saveLink("accuracy.json", json, say("The numbers as JSON")));
  }
}

/** Logarithms go on where doubles end. */
function boundOf({ bound, bound_log10: log }) {
  if (bound > 1e-300) return boundText(bound);
  return "1e" + Math.ceil(log);
}
