// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The candidate pivots: where each lies, at which tilt moments about it balance, and whether turning about it is free. */

import { element, table } from "./element.js";
import { degreesText, fosText } from "./certain.js";
import { lengthText, lengthUnit } from "./lengths.js";
import { Panel } from "./panel.js";
import { directionText } from "./words.js";
import { say } from "../words/language.js";

/** More rows than this are for files, not for a page. */
const ROWS_MAX = 200;
/** Kinds that are terms of the glossary; the others are plain words. */
const EXPLAINED = new Set(["peak", "valley"]);

export class PivotsPanel extends Panel {
  draw(solution) {
    this.body.replaceChildren(...solution.cases.map((each) => this.#direction(each)));
  }

  #direction(theCase) {
    const unit = lengthUnit(this.store);
    const governs = theCase.toppling?.pivot;
    const heads = [
      this.terms.word("Pivot", "pivot"), "x (" + unit.name + ")", "y (" + unit.name + ")",
      this.terms.word("topples at", "critical angle"), this.terms.word("FoS"), this.terms.word("elements", "elements"),
      this.terms.word("turning", "admissible pivot"),
    ];
    const listed = theCase.pivots.slice(0, ROWS_MAX);
    return element(
      "section",
      { "data-towards": theCase.towards },
      element("h3", {}, directionText(theCase, null)),
      table(say("Candidate pivots") + ", " + directionText(theCase, null), heads, listed.map((pivot) => ({
        marked: pivot.index === governs,
        cells: [
          [pivot.index + 1 + " ", EXPLAINED.has(pivot.kind) ? this.terms.word(pivot.kind) : say(pivot.kind)],
          lengthText(pivot.x_m, unit),
          lengthText(pivot.y_m, unit),
          pivot.critical_angle_deg === null ? say(pivot.critical_angle_is ?? "—") : degreesText(pivot.critical_angle_deg),
          factorText(pivot.fos, pivot.fos_is),
          factorText(pivot.fos_elements, pivot.fos_elements_is),
          say(pivot.index === governs ? "governs" : pivot.admissible ? "free" : "blocked"),
        ],
      }))),
      theCase.pivot_count > listed.length
        ? element("p", {}, say("%s of %s candidates are listed.", listed.length, theCase.pivot_count))
        : null,
    );
  }
}

function factorText(fos, is) {
  if (fos) return fosText(fos);
  return is === undefined ? "—" : say(is.split(":")[0]);
}
