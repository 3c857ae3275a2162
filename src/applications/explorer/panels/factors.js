// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** All factors of safety of each direction, of which the least governs, and what each is the quotient of. */

import { element, table } from "./element.js";
import { fosText } from "./certain.js";
import { Panel } from "./panel.js";
import { againstText, definitionText, directionText, termOfDefinition } from "./words.js";
import { say } from "../words/language.js";

const STANDINGS = {
  blocked: say("excluded: blocked by a contact"),
  prevented: say("excluded: another motion begins first"),
  unaffected: say("excluded: strength does not decide when it begins"),
  uneven: say("excluded: its facets differ in friction"),
  smooth: say("excluded: no friction to reduce"),
};

export class FactorsPanel extends Panel {
  draw(solution) {
    this.body.replaceChildren(...solution.cases.map((each) => this.#direction(each)));
  }

  #direction(theCase) {
    const factors = theCase.factors ?? [];
    return element(
      "section",
      { "data-towards": theCase.towards },
      element("h3", {}, directionText(theCase, null)),
      factors.length === 0
        ? element("p", {}, this.terms.word("FoS"), " ", say(theCase.governing_fos?.fos_is ?? "none: no factor is judged"), ".")
        : table(say("Factors of safety") + ", " + directionText(theCase, null), [this.terms.word("FoS"), say("against"), say("by")], factors.map((each) => this.#row(each, theCase))),
    );
  }

  #row(factor, theCase) {
    const governing = theCase.governing_fos;
    const marked = factor.definition === governing.definition && factor.mechanism === governing.mechanism;
    const by = definitionText(factor.definition, theCase);
    return {
      marked,
      cells: [
        factor.fos === null ? say(factor.fos_is ?? "none") : fosText(factor.fos),
        againstText(factor.mechanism) + (factor.pivot === undefined ? "" : " " + say("about pivot %s", factor.pivot + 1)),
        [
          this.terms.word(by, termOfDefinition(factor.definition)),
          factor.counts ? null : " (" + STANDINGS[factor.standing] + ")",
        ],
      ],
    };
  }
}
