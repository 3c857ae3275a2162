// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The closed formulas of a scene with parameters, as the core derives them: exact identities, typeset. Sliders set the
 * parameters in the scene; the numbers of the formulas follow at once, beside what the core then solves.
 */

import { element, mathElement } from "./element.js";
import { degreesText } from "./certain.js";
import { readExpression, valueOf } from "./expression.js";
import { Job } from "./job.js";
import { equation, formula, fraction, symbol } from "./mathml.js";
import { Panel } from "./panel.js";
import { parameterValues } from "../scene/quantity.js";
import { decimalValue, snap, stepExponent } from "../scene/decimal.js";
import { numeral, parts, say } from "../words/language.js";
import { readComplaint } from "../scene/complaint.js";

const DERIVE_MAX_MS = 60_000;
const PARAMETERS_MAX = 12;

export class DerivePanel extends Panel {
  constructor(place, context) {
    super(place, context);
    this.sliders = element("div", { class: "sliders" });
    this.limit = element("input", { type: "checkbox", onchange: () => this.job.start(0) });
    this.all = element("input", { type: "checkbox", onchange: () => this.job.start(0) });
    this.formulas = element("div", {});
    this.told = element("p", { class: "told" });
    this.body.append(
      this.sliders,
      element(
        "p",
        { class: "choices" },
        element("label", {}, this.all, " " + say("all pivots")), " ",
        element("label", {}, this.limit, " " + say("static limit and onset, in tan φ (takes longer)")),
      ),
      this.formulas, this.told,
    );
    this.job = new Job((current) => this.#derive(current), (error) => this.#fail(error.message));
  }

  draw() {
    this.#slide();
    this.#follow();
    this.job.start();
  }

  hidden() {
    this.job.stop();
  }

  forget() {
    this.job.stop();
    this.#fail("…");
  }

  /** A slider for each parameter that the scene gives by a decimal; those that are there keep the focus. */
  #slide() {
    const names = (this.store.parsed.keys(["parameters"]) ?? []).slice(0, PARAMETERS_MAX);
    const values = names.map((name) => decimalValue(this.store.parsed.scalar(["parameters", name]) ?? ""));
    const key = JSON.stringify(names.map((name, at) => [name, values[at] === null]));
    if (key !== this.slidersKey) {
      this.slidersKey = key;
      this.rows = names.flatMap((name, at) => (values[at] === null ? [] : [this.#slider(name, values[at])]));
      this.sliders.replaceChildren(...this.rows.map(({ row }) => row));
    }
    for (const { name, slider, output } of this.rows) {
      const text = this.store.parsed.scalar(["parameters", name]) ?? "";
      if (document.activeElement !== slider) slider.value = text;
      output.textContent = text;
    }
    if (names.length === 0) {
      this.sliders.replaceChildren(element("p", {}, say("This scene names no parameters: its formulas are numbers. Examples with teeth have a, b, c.")));
    }
  }

  #slider(name, value) {
    const size = Math.abs(value) || 1;
    const step = stepExponent(size / 100, 1);
    const [low, high] = value < 0 ? [2 * value, 0] : [0, 2 * size];
    const output = element("output", {});
    const slider = element("input", {
      type: "range", min: low, max: high, step: 10 ** step, "aria-label": name,
      oninput: () => this.store.setNumber(["parameters", name], snap(Number(slider.value), step), { mergeWith: "slider " + name }),
      onchange: () => this.store.endGesture(),
    });
    return { name, slider, output, row: element("label", { class: "slider" }, element("i", {}, name), slider, output) };
  }

  async #derive(current) {
    const args = ["derive", "--json", ...(this.limit.checked ? ["--limit", "--unchecked"] : []), ...this.store.caseWords, this.store.argument];
    const answer = await this.background.run(args, this.files(), { latest: "derive", timeoutMs: DERIVE_MAX_MS });
    if (!current()) return;
    if (answer.out === "") return this.#fail(readComplaint(answer.err).message);
    this.derived = JSON.parse(answer.out);
    this.#show();
  }

  #fail(message) {
    this.derived = null;
    this.formulas.replaceChildren();
    this.told.textContent = message;
  }

  #show() {
    const { area, pivots, limit = [], onset = [] } = this.derived;
    this.live = [];
    const shown = pivots.filter((pivot) => this.all.checked || pivot.governs);
    this.formulas.replaceChildren(
      equation(symbol("A"), fraction(area)),
      ...shown.map((pivot) => this.#pivot(pivot)),
      ...limit.map((each) => this.#limitFormula(say("Static limit"), "α_w", each)),
      ...onset.map((each) => this.#limitFormula(say("Onset of motion"), "α_s", each)),
    );
    this.told.textContent = say("Exact identities for all values of the parameters for which the outline keeps its shape.");
    this.#follow();
  }

  #pivot(pivot) {
    const state = pivot.governs ? "governs" : pivot.admissible ? "free" : "blocked";
    return element(
      "section",
      {},
      element(
        "h3", {}, parts("%s at (%s, %s), %s, %s", say(pivot.kind), inline(pivot.x), inline(pivot.y), say("tilted towards the " + pivot.towards),
          this.terms.word(state, "admissible pivot")),
      ),
      equation(symbol("tan", "α_crit"), fraction(pivot.tan_critical_angle)),
      this.#value(pivot.tan_critical_angle, pivot.critical_angle_deg),
    );
  }

  #limitFormula(title, angle, derived) {
    const heading = element("h3", {}, title + ", " + say("tilted towards the " + derived.towards) + ": " + say(derived.mechanism ?? ""));
    if (derived.same_as_limit) return element("section", {}, heading, element("p", {}, say("The formula of the limit serves for both.")));
    const quotient = derived.tan_critical_angle;
    if (!quotient) return element("section", {}, heading, element("p", {}, say("No formula: %s.", say(derived.reason ?? "it has none"))));
    return element(
      "section",
      {},
      heading,
      equation(symbol("tan", angle), fraction(quotient)),
      this.#value(quotient, derived.critical_angle_deg ?? null),
      element(
        "details",
        {},
        element("summary", {}, say("It holds as long as all of these %s are not below zero", derived.conditions.length)),
        derived.conditions.map((text) => element("div", { class: "equation wide", tabindex: 0 }, mathElement("math", {}, formula(text)))),
      ),
    );
  }

  /** The formula's number now, in doubles, and what the core certified at the values that it was derived at. */
  #value({ numerator, denominator }, certified) {
    const output = element("output", {});
    const trees = [numerator, denominator].map((text) => readExpression(text));
    if (!trees.includes(null)) this.live.push({ trees, output });
    return element("p", { class: "value" }, certified ? parts("by the formula, now %s, certified %s", output, degreesText(certified)) : parts("by the formula, now %s", output));
  }

  #follow() {
    const names = parameterValues(this.store.parsed);
    const friction = readExpression(this.store.parsed.scalar(["friction_angle_deg"]) ?? "");
    if (friction !== null) names.set("phi", valueOf(friction, names));
    for (const { trees, output } of this.live ?? []) {
      const [over, under] = trees.map((tree) => valueOf(tree, names));
      const angle = (Math.atan2(over, under) * 180) / Math.PI;
      output.textContent = Number.isFinite(angle) ? numeral(angle.toFixed(4)) + "°" : say("none");
    }
  }
}

function inline(quotient) {
  const whole = quotient.denominator === "1" ? formula(quotient.numerator) : fraction(quotient);
  return mathElement("math", {}, whole);
}
