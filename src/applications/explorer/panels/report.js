// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * What the command line prints and writes of the scene, the same bytes: its report, the calculation sheet to check and sign,
 * the figure, the JSON.
 */

import { element } from "./element.js";
import { offer } from "../page/offer.js";
import { Panel } from "./panel.js";
import { languageWords, reportOf, reportedCase, textOf } from "./report_text.js";
import { say } from "../words/language.js";
import { refusalOf } from "../scene/complaint.js";

const WRITE_MAX_MS = 60_000;

/** @type {{label: string, option: string, ending: string, type: string}[]} */
const FILES = [
  { label: "Calculation sheet, HTML", option: "--report", ending: "html", type: "text/html" },
  { label: "Calculation sheet, Markdown", option: "--report", ending: "md", type: "text/markdown" },
  { label: "Calculation sheet, PDF", option: "--report", ending: "pdf", type: "application/pdf" },
  { label: "Figure, SVG", option: "--figure", ending: "svg", type: "image/svg+xml" },
  { label: "Figure, PDF", option: "--figure", ending: "pdf", type: "application/pdf" },
  { label: "Figure, PNG", option: "--figure", ending: "png", type: "image/png" },
];

export class ReportPanel extends Panel {
  get takes() {
    return ["block", "blocks", "solid"];
  }

  #asked = 0;

  constructor(place, context) {
    super(place, context);
    this.told = element("p", { class: "told", role: "status" });
    this.text = element("div", {});
    this.body.append(
      element("p", { class: "choices" }, FILES.map((file) => element("button", { type: "button", onclick: () => this.write(file) }, say(file.label))),
        element("button", { type: "button", onclick: () => this.#json() }, say("Solution, JSON"))),
      this.told, this.text,
    );
  }

  forget() {
    this.#asked++;
    this.text.replaceChildren(textOf("…"));
  }

  async draw() {
    const asked = ++this.#asked;
    try {
      const report = await reportOf(this, this.core);
      if (asked === this.#asked) this.text.replaceChildren(report);
    } catch (error) {
      if (asked === this.#asked && error.name !== "AbortError") this.text.replaceChildren(textOf(error.message));
    }
  }

  /** @param {typeof FILES[number]} file */
  async write({ label, option, ending, type }) {
    const name = this.store.name.replace(/\.[^.]*$/, "") + "." + ending;
    this.told.textContent = say(label) + " …";
    try {
      const options = { collect: [name], timeoutMs: WRITE_MAX_MS };
      const answer = await this.background.run(["solve", "--quiet", option, name, ...(option === "--report" ? languageWords(this.store) : []), ...reportedCase(this.store), this.store.argument], this.files(), options);
      const written = answer.files[name];
      if (written === undefined) throw answer.err.trim() === "" ? new Error(say("nothing was written")) : refusalOf(answer);
      offer(name, written, type);
      this.told.textContent = say("%s: %s, the bytes that the command line writes.", say(label), name);
    } catch (error) {
      this.told.textContent = say(label) + ": " + error.message;
    }
  }

  #json() {
    const { name } = this.store;
    const args = ["solve", "--json", ...reportedCase(this.store), this.store.argument];
    this.core.run(args, this.files(), { timeoutMs: WRITE_MAX_MS }).then(
      (answer) => offer(name.replace(/\.[^.]*$/, "") + ".json", answer.out, "application/json"),
      (error) => (this.told.textContent = error.message),
    );
  }
}
