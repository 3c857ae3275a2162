// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The verdict of each direction of tilt: what the block does at the scene's tilt, the factor of safety that governs,
 * up to which tilt it is certain to stand and beyond which it is certain to move, where its base ends, and cautions.
 */

import { alpha, element } from "./element.js";
import { degreesText, fosText } from "./certain.js";
import { lengthUnit, pointText } from "./lengths.js";
import { otherReport } from "./other_report.js";
import { Panel } from "./panel.js";
import { windowGauge } from "./window_gauge.js";
import { COLOUR_CLASS, againstText, definitionText, directionText, sentence, termOfDefinition } from "./words.js";

/** Who listens is told when it has been still for so long, milliseconds. */
const STILL = 600;

export class VerdictPanel extends Panel {
  get takes() {
    return ["block", "blocks", "solid"];
  }

  #told = 0;

  constructor(place, context) {
    super(place, context);
    this.live = element("p", { class: "unseen", role: "status", "aria-live": "polite" });
    place.append(this.live);
  }

  draw(solution) {
    if (solution.kind !== "block") {
      this.body.replaceChildren(otherReport(this));
      return;
    }
    this.body.replaceChildren(
      ...solution.cases.map((each) => this.#direction(each)),
      ...solution.notes.map((note) =>
        element("p", { class: "note " + note.kind }, element("strong", {}, sentence(note.kind) + ": "), note.text),
      ),
      element("p", { class: "told" }, "Certain to every digit printed; by ", this.terms.word("level"), ": " + solution.level + "."),
    );
    clearTimeout(this.#told);
    this.#told = setTimeout(() => {
      this.live.textContent = solution.cases.map(spoken).join(" ");
    }, STILL);
  }

  #direction(theCase) {
    const kind = COLOUR_CLASS[theCase.mechanism] ?? "undecided";
    return element(
      "article",
      { class: "direction", "data-towards": theCase.towards },
      element("h3", {}, directionText(theCase, tiltText(theCase))),
      element(
        "p",
        { class: "verdict " + kind },
        this.terms.word(sentence(theCase.mechanism), theCase.mechanism),
        theCase.tilt_angle_deg ? " at " + degreesText(theCase.tilt_angle_deg) : " first, as the table is tilted",
        theCase.falls_backwards ? ", up-dip" : "",
      ),
      this.#governing(theCase),
      windowGauge(theCase),
      this.#window(theCase),
      this.#base(theCase),
    );
  }

  #governing(theCase) {
    const governing = theCase.governing_fos;
    if (governing === undefined) return null;
    if (governing.fos === null) {
      return element("p", { class: "fos" }, this.terms.word("FoS"), " " + (governing.fos_is ?? "none"));
    }
    return element(
      "p",
      { class: "fos" },
      this.terms.word("FoS"),
      governing.complete ? " " : " at most ",
      element("strong", { "data-number": "governing_fos" }, fosText(governing.fos)),
      " against " + againstText(governing.mechanism) + " (",
      this.terms.word(governing.definition, termOfDefinition(governing.definition)),
      ")",
      element("span", { class: "definition" }, definitionText(governing.definition, theCase)),
    );
  }

  /** Up to where it certainly stands, and from where it certainly moves. */
  #window(theCase) {
    const { onset, limit, first } = theCase;
    if (onset === undefined) {
      return element(
        "p",
        {},
        "Without a friction angle only toppling is judged: by moments it ",
        element("em", {}, theCase.toppling ? "topples at " + degreesText(theCase.toppling.critical_angle_deg) : "cannot turn"),
        ".",
      );
    }
    return element(
      "dl",
      { class: "numbers" },
      row(this.terms.word("Certain to stand", "onset of motion"), onsetText(onset), "onset"),
      row(this.terms.word("Certain to move", "static limit"), limitText(limit), "limit"),
      first.margin_deg ? row(this.terms.word("Margin", "margin"), degreesText(first.margin_deg), "margin") : null,
      onset.below_limit === true
        ? row(this.terms.word("Between", "history"), "depends on loading history: locked-in forces may or may not hold it", "history")
        : null,
      this.#motion(limit),
    );
  }

  #motion(limit) {
    if (limit.centre_x_m === null || limit.centre_x_m === undefined) return null;
    const unit = lengthUnit(this.store);
    const about = pointText(limit.centre_x_m, limit.centre_y_m, unit) + " " + unit.name;
    return row(this.terms.word("Then it", "mechanism"), [this.terms.word(limit.mechanism), " about " + about], "centre");
  }

  /** A limit that depends on where the base ends is never left open. */
  #base(theCase) {
    const { limit } = theCase;
    if (limit === undefined || limit.base_matters !== true) return null;
    const goesOn = limit.base_beyond_toe;
    return element(
      "p",
      { class: "base-matters" },
      "On this base, which " + (goesOn ? "extends past" : "ends at") + " the ", this.terms.word("toe"), ", it is held up to ",
      element("strong", {}, degreesText(limit.critical_angle_deg)),
      "; on one that " + (goesOn ? "ends at" : "extends past") + " the toe it ", this.terms.word(limit.otherwise.mechanism), " at ",
      element("strong", { "data-number": "otherwise" }, degreesText(limit.otherwise.critical_angle_deg)),
      ".",
    );
  }
}

/** @param {any} word @param {any} text @param {string} name what a test knows it by */
function row(word, text, name) {
  return [element("dt", {}, word), element("dd", { "data-number": name }, text)];
}

function tiltText(theCase) {
  return theCase.tilt_angle_deg ? degreesText(theCase.tilt_angle_deg) : null;
}

function onsetText(onset) {
  const words = {
    never: "at every tilt: no motion can begin",
    nowhere: "at no tilt: a motion can begin on level ground",
    undecided: onset.too_dear === true ? "undecided: the proof exceeds the work allowed" : "undecided",
  };
  return words[onset.kind] ?? ["up to ", alpha("s"), " = " + degreesText(onset.critical_angle_deg) + ", then it " + onset.mechanism];
}

function limitText(limit) {
  if (limit.critical_angle_deg === null) return limit.mechanism;
  return ["beyond ", alpha("w"), " = " + degreesText(limit.critical_angle_deg)];
}

function spoken(theCase) {
  const tilt = tiltText(theCase);
  const fos = theCase.governing_fos?.fos;
  return (
    directionText(theCase, tilt) + ": " + theCase.mechanism + (fos ? ", factor of safety " + fosText(fos) : "") + "."
  );
}
