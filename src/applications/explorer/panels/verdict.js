// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The verdict of each direction of tilt: what the block does at the scene's tilt, the factor of safety that governs,
 * up to which tilt it is certain to stand and beyond which it is certain to move, where its base ends, and cautions.
 */

import { alpha, element } from "./element.js";
import { degreesText, fosAtMostText, fosText } from "./certain.js";
import { lengthUnit, pointText } from "./lengths.js";
import { loadCasesTable } from "./load_cases_table.js";
import { Panel } from "./panel.js";
import { reportOf, textOf } from "./report_text.js";
import { windowGauge } from "./window_gauge.js";
import { COLOUR_CLASS, againstText, definitionText, directionText, sentence, termOfDefinition } from "./words.js";
import { parts, say } from "../words/language.js";

/** Who listens is told when it has been still for so long, milliseconds. */
const STILL = 600;

export class VerdictPanel extends Panel {
  get takes() {
    return ["block", "blocks", "solid"];
  }

  #told = 0;
  #reported = ""; // of which scene and load case the report is

  constructor(place, context) {
    super(place, context);
    this.live = element("p", { class: "unseen", role: "status", "aria-live": "polite" });
    place.append(this.live);
  }

  draw(solution) {
    if (solution.kind !== "block") {
      this.#report(solution);
      return;
    }
    this.body.replaceChildren(
      ...loadCasesTable(solution, this.terms),
      ...solution.cases.map((each) => this.#direction(each)),
      ...solution.notes.map((note) =>
        element("p", { class: "note " + note.kind }, element("strong", {}, sentence(say(note.kind)) + ": "), note.text),
      ),
      element("p", { class: "told" }, parts("%s to every digit printed, for the model as given; by %s: %s.", this.terms.word("Certain", "certain"), this.terms.word("level"), say(solution.level))),
    );
    clearTimeout(this.#told);
    this.#told = setTimeout(() => {
      this.live.textContent = solution.cases.map(spoken).join(" ");
    }, STILL);
  }

  /** No one is told of a scene that is no more there. */
  forget() {
    clearTimeout(this.#told);
    this.live.textContent = "";
  }

  /** Of many blocks, and of solids, all words and numbers are those of the report. */
  async #report(solution) {
    const of = JSON.stringify([this.store.subject, this.store.caseWords]);
    if (this.#reported !== of) this.body.replaceChildren(textOf("…"));
    this.#reported = of;
    const show = (report) => this.store.solution === solution && this.body.replaceChildren(...loadCasesTable(solution, this.terms), report);
    try {
      show(await reportOf(this, this.background));
    } catch (error) {
      if (error.name !== "AbortError") show(textOf(error.message));
    }
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
        this.#does(theCase),
        theCase.falls_backwards ? ", " + say("up-dip") : "",
      ),
      this.#governing(theCase),
      windowGauge(theCase),
      this.#window(theCase),
      this.#base(theCase),
    );
  }

  #does(theCase) {
    const word = this.terms.word(sentence(say(theCase.mechanism)), theCase.mechanism);
    return theCase.tilt_angle_deg ? parts("%s at %s", word, degreesText(theCase.tilt_angle_deg)) : parts("%s first, as the table is tilted", word);
  }

  #governing(theCase) {
    const governing = theCase.governing_fos;
    if (governing === undefined) return null;
    if (governing.fos === null) {
      return element("p", { class: "fos" }, this.terms.word("FoS"), " " + say(governing.fos_is ?? "none"));
    }
    return element(
      "p",
      { class: "fos" },
      this.terms.word("FoS"),
      governing.complete ? " " : " " + say("at most") + " ",
      element("strong", { "data-number": "governing_fos" }, governing.complete ? fosText(governing.fos) : fosAtMostText(governing.fos)),
      " " + say("against %s", againstText(governing.mechanism)) + " (",
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
        parts("Without a friction angle only toppling is judged: by moments it %s.",
          element("em", {}, theCase.toppling ? say("topples at %s", degreesText(theCase.toppling.critical_angle_deg)) : say("cannot turn"))),
      );
    }
    return element(
      "dl",
      { class: "numbers" },
      row(this.terms.word("Certain to stand", "onset of motion"), onsetText(onset), "onset"),
      row(this.terms.word("Certain to move", "static limit"), limitText(limit), "limit"),
      first.margin_deg ? row(this.terms.word("Margin", "margin"), degreesText(first.margin_deg), "margin") : null,
      onset.below_limit === true
        ? row(this.terms.word("Between", "history"), say("depends on loading history: locked-in forces may or may not hold it"), "history")
        : null,
      this.#motion(limit),
    );
  }

  #motion(limit) {
    if (limit.centre_x_m === null || limit.centre_x_m === undefined) return null;
    const unit = lengthUnit(this.store);
    const about = pointText(limit.centre_x_m, limit.centre_y_m, unit) + " " + unit.name;
    return row(this.terms.word("Then it", "mechanism"), parts("%s about %s", this.terms.word(limit.mechanism), about), "centre");
  }

  /** A limit that depends on where the base ends is never left open. */
  #base(theCase) {
    const { limit } = theCase;
    if (limit === undefined || limit.base_matters !== true) return null;
    const goesOn = limit.base_beyond_toe;
    return element(
      "p",
      { class: "base-matters" },
      parts(
        goesOn ? "On this base, which extends past the %s, it is held up to %s; on one that ends at the toe it %s at %s."
          : "On this base, which ends at the %s, it is held up to %s; on one that extends past the toe it %s at %s.",
        this.terms.word("toe"), element("strong", {}, degreesText(limit.critical_angle_deg)), this.terms.word(limit.otherwise.mechanism),
        element("strong", { "data-number": "otherwise" }, degreesText(limit.otherwise.critical_angle_deg)),
      ),
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
    never: say("at every tilt: no motion can begin"),
    nowhere: say("at no tilt: a motion can begin on level ground"),
    undecided: onset.too_dear === true ? say("undecided: the proof exceeds the work allowed") : say("undecided"),
  };
  return words[onset.kind] ?? parts("up to %s = %s, then it %s", element("span", {}, alpha("s")), degreesText(onset.critical_angle_deg), say(onset.mechanism));
}

function limitText(limit) {
  if (limit.critical_angle_deg === null) return say(limit.mechanism);
  return parts("beyond %s = %s", element("span", {}, alpha("w")), degreesText(limit.critical_angle_deg));
}

function spoken(theCase) {
  const tilt = tiltText(theCase);
  const fos = theCase.governing_fos?.fos;
  return (
    directionText(theCase, tilt) + ": " + say(theCase.mechanism) + (fos ? ", " + say("factor of safety %s", fosText(fos)) : "") + "."
  );
}
