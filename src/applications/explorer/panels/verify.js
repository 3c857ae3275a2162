// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A formula or a number of a paper, typed in, and the core's verdict on it: proven as an exact identity, refuted with the
 * difference and the smallest change that mends it, or what lies between. A file of one claim is written for it.
 */

import { element, mathElement } from "./element.js";
import { boundText, certainText, plainText } from "./certain.js";
import { formula } from "./mathml.js";
import { Panel } from "./panel.js";
import { numeral, parts, say } from "../words/language.js";
import { readComplaint } from "../scene/complaint.js";

const VERIFY_MAX_MS = 60_000;
const CLAIMS = "claim_typed_in.yaml";
const LENGTH_MAX = 20_000;

const QUANTITIES = {
  critical_angle: "critical angle of toppling",
  fos: "factor of safety, by the resultant",
  fos_elements: "factor of safety, by elements",
  area: "area",
  x_arm: "lever arm x̄",
  y_arm: "lever arm ȳ",
  facet_angle: "angle of the facet at the pivot",
  rounding_length: "rounding length r at which it topples",
  corner_radius: "corner radius r_c at which it topples",
  mean_square_slope: "mean square slope",
  block_width: "block width Δx",
  mean_height: "mean height y",
  amplitude: "amplitude A",
};

/** Of these the corner at the pivot is rounded. */
const ROUNDED = new Set(["rounding_length", "corner_radius"]);

export class VerifyPanel extends Panel {
  #filled = false;
  #asked = 0;

  constructor(place, context) {
    super(place, context);
    this.quantity = element(
      "select", { "aria-label": "What the formula is of" },
      Object.entries(QUANTITIES).map(([value, text]) => element("option", { value }, say(text))),
    );
    this.towards = element("select", { "aria-label": "Direction of tilt" });
    this.printed = element("input", {
      type: "text", class: "formula", "aria-label": "The formula, or the number", spellcheck: "false", autocomplete: "off", maxlength: LENGTH_MAX,
    });
    this.verdict = element("div", { class: "claim", role: "status", "aria-live": "polite" });
    const form = element(
      "form",
      { onsubmit: (event) => (event.preventDefault(), this.verify()) },
      element("p", { class: "choices" }, parts("The %s, tilted towards the %s, is", this.quantity, this.towards)),
      element("p", { class: "choices" }, this.printed, " ", element("button", { type: "submit" }, say("Verify"))),
      element(
        "p", { class: "told" },
        say("As papers write: 27ab, sin α, tan^-1((27ab + 13ac)/(9b^2 + 18bc + 6c^2)); parameters of the scene, alpha the tilt, angles in degrees; or a number, as 35.2."),
      ),
    );
    this.body.append(form, this.verdict);
  }

  /** A claim was verified for the scene as it was. */
  draw(solution) {
    this.#asked++;
    this.verdict.replaceChildren();
    const chosen = this.towards.value;
    const directions = solution.cases.map(({ towards }) => towards);
    this.towards.replaceChildren(...directions.map((towards) => element("option", { value: towards }, say(towards))));
    this.towards.value = directions.includes(chosen) ? chosen : directions[0];
    if (this.#filled) return;
    this.#filled = true;
    const angle = solution.cases[0].toppling?.critical_angle_deg;
    if (angle) this.printed.value = plainText(angle, 1);
  }

  async verify() {
    const asked = ++this.#asked;
    this.verdict.replaceChildren(element("p", {}, "…"));
    try {
      const files = { ...this.files(), [CLAIMS]: this.#claims() };
      const answer = await this.background.run(["verify", "--json", CLAIMS], files, { latest: "verify", timeoutMs: VERIFY_MAX_MS });
      if (asked !== this.#asked) return;
      if (answer.out === "") this.#tell(element("p", {}, readComplaint(answer.err).message));
      else this.#show(JSON.parse(answer.out).claims[0]);
    } catch (error) {
      if (asked === this.#asked && error.name !== "AbortError") this.#tell(element("p", {}, error.message));
    }
  }

  /** JSON's strings are YAML's too, so that what is typed stays what it is: a formula. */
  #claims() {
    const quantity = this.quantity.value;
    const claim = { id: "typed in", where: "typed in", geometry: "scene", quantity, printed: this.printed.value };
    const geometry = { scene: this.store.name, towards: this.towards.value, ...(ROUNDED.has(quantity) ? { rounded: true } : {}) };
    return JSON.stringify({ topple_claims: 1, geometries: { scene: geometry }, claims: [claim] }) + "\n";
  }

  #show(claim) {
    const good = ["proven", "agrees", "truncated"].includes(claim.verdict);
    const rows = [];
    const add = (label, ...what) => rows.push(element("dt", {}, say(label)), element("dd", {}, what));
    if (typeof claim.computed === "string") add(claim.of_tangents ? "its tangent is" : "it is", typeset(claim.computed));
    else if (claim.computed) add("it is", say("%s, within %s", certainText(claim.computed, 9), numeral(boundText(claim.computed.error))));
    if (claim.difference) add(claim.of_tangents ? "printed less derived, of tangents" : "printed less derived", typeset(claim.difference));
    if (claim.at && claim.printed_there) {
      add(say("at %s", claim.at), say("printed %s, derived %s", certainText(claim.printed_there, 6), certainText(claim.computed_there, 6)));
    }
    if (claim.mend) add("mended", element("code", {}, claim.mend), claim.change ? " (" + claim.change + ")" : "");
    if (claim.digits) add("equal", say("to %s digits at %s points, which is no proof", claim.digits, claim.points));
    if (claim.condition) add("but", claim.condition);
    this.#tell(
      element("p", { class: "verdict " + (good ? "stands" : claim.verdict === "undecided" ? "undecided" : "topples") }, element("strong", {}, say(claim.verdict))),
      element("dl", { class: "numbers" }, rows),
    );
  }

  #tell(...parts) {
    this.verdict.replaceChildren(...parts);
  }
}

function typeset(text) {
  return element("span", { class: "wide", tabindex: 0 }, mathElement("math", {}, formula(text)));
}
