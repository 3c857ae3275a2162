// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Two scenes side by side: one that is kept, and the present one, which goes on being changed; what differs in numbers and in text. */

import { shortVerdict, thumbnail } from "../send/thumbnail.js";
import { numeral, say } from "../words/language.js";
import { certainDigits, degreesText, fosText } from "./certain.js";
import { element, table } from "./element.js";
import { Panel } from "./panel.js";
import { againstText } from "./words.js";

const LINES_MAX = 60;

const ROWS = [
  { label: "Tilt", of: (kase) => kase.tilt_angle_deg && degreesText(kase.tilt_angle_deg) },
  { label: "Friction", of: (kase) => kase.limit?.friction_angle_deg && degreesText(kase.limit.friction_angle_deg) },
  { label: "FoS", of: (kase) => (kase.governing_fos?.fos ? fosText(kase.governing_fos.fos) : kase.fos?.value !== undefined ? fosText(kase.fos) : null) },
  { label: "Against", of: (kase) => kase.governing_fos && againstText(kase.governing_fos.mechanism) },
  { label: "Certain to stand up to", of: (kase) => kase.onset?.critical_angle_deg && degreesText(kase.onset.critical_angle_deg) },
  { label: "Certain to move beyond", of: (kase) => kase.limit?.critical_angle_deg && degreesText(kase.limit.critical_angle_deg) },
  { label: "By moments", of: (kase) => kase.toppling?.critical_angle_deg && degreesText(kase.toppling.critical_angle_deg) },
  { label: "Area (m²)", of: (kase) => kase.block?.area_m2 && certainDigits(kase.block.area_m2, 6) },
  { label: "Weight (N)", of: (kase) => kase.block?.weight_n && certainDigits(kase.block.weight_n, 6) },
];

export class ComparePanel extends Panel {
  #kept = null;

  get takes() {
    return ["block", "blocks", "solid"];
  }

  constructor(place, context) {
    super(place, context);
    this.keep = element("button", { type: "button", onclick: () => this.#keep() }, say("Keep this scene to compare with"));
    this.swap = element("button", { type: "button", disabled: true, onclick: () => this.#swap() }, say("Change places"));
    this.pair = element("div", { class: "compared" });
    this.body.append(element("p", { class: "choices" }, this.keep, this.swap), this.pair);
    this.seen = element("p", { class: "told" }, say("Keep a scene, then change it or open another: both stand here side by side."));
    this.pair.append(this.seen);
  }

  draw(solution) {
    this.present = { solution, state: { name: this.store.name, text: this.store.text, files: this.store.files } };
    if (this.#kept !== null) this.#show();
  }

  #keep() {
    if (this.present === undefined) return;
    this.#kept = this.present;
    this.swap.disabled = false;
    this.#show();
  }

  #swap() {
    const other = this.#kept;
    this.#kept = this.present;
    this.store.open(other.state);
  }

  #show() {
    const [one, other] = [this.#kept, this.present];
    const kases = [one.solution.cases[0], pairOf(one, other)];
    const rows = ROWS.map(({ label, of }) => ({ label, values: kases.map((kase) => (kase ? of(kase) : null) ?? "—") })).filter(({ values }) => values.some((value) => value !== "—"));
    this.pair.replaceChildren(
      element("div", { class: "side-by-side" }, this.#side(one, say("Kept")), this.#side(other, say("Now"))),
      table(say("Two scenes"), ["", say("Kept"), say("Now")], rows.map(({ label, values }) => ({ marked: values[0] !== values[1], cells: [say(label), ...values.map((value) => numeral(value))] }))),
      this.#lines(one.state.text, other.state.text),
    );
  }

  #side({ solution, state }, heading) {
    const { words, kind } = shortVerdict(solution);
    const title = /^title: *["']?(.*?)["']?$/m.exec(state.text)?.[1] ?? state.name;
    return element("figure", { "data-kind": kind }, element("figcaption", {}, element("strong", {}, heading), ": " + say(title)), thumbnail(solution, state), element("p", { class: "card-verdict" }, words));
  }

  #lines(before, after) {
    const [gone, come] = [onlyIn(before, after), onlyIn(after, before)];
    if (gone.length + come.length === 0) return element("p", { class: "told" }, say("Their texts are the same."));
    const listed = [...gone.map((line) => "− " + line), ...come.map((line) => "+ " + line)];
    const more = listed.length > LINES_MAX ? "\n… " + (listed.length - LINES_MAX) : "";
    return element("pre", { class: "wide", tabindex: 0, "aria-label": "Lines that differ" }, listed.slice(0, LINES_MAX).join("\n") + more);
  }
}

/** The case of the other scene that tilts the same way. */
function pairOf(one, other) {
  return other.solution.cases.find(({ towards }) => towards === one.solution.cases[0]?.towards) ?? other.solution.cases[0];
}

/** Lines of a text that another one has not, or less often. @param {string} text @param {string} other @returns {string[]} */
export function onlyIn(text, other) {
  const counts = new Map();
  for (const line of other.split("\n")) counts.set(line, (counts.get(line) ?? 0) + 1);
  return text.split("\n").filter((line) => {
    const left = counts.get(line) ?? 0;
    counts.set(line, left - 1);
    return left <= 0 && line.trim() !== "";
  });
}
