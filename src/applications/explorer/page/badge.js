// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What the block does, and the factor of safety that governs, in a corner of its drawing. */

import { degreesText, fosAtMostText, fosText } from "../panels/certain.js";
import { COLOUR_CLASS, againstText, sentence } from "../panels/words.js";
import { drives } from "../scene/solution.js";
import { parts, say } from "../words/language.js";

const CLEAR = 10; // dots between it and a block, whose handles lie on its edge

/**
 * Title and verdict change together: the verdict of one scene never stands under the title of another.
 * @param {(id: string) => HTMLElement} element @param {import("../drawing/drawing.js").Drawing} drawing @param store
 */
export function badge(element, drawing, store) {
  const show = () => {
    const kase = store.isOfSubject ? drawing.case : null;
    element("scene-title").textContent = say(store.parsed.title ?? "A scene without a title"); // those of examples have translations
    element("scene-title").title = store.name;
    element("badge").classList.toggle("of-before", store.solution === null);
    element("badge").dataset.kind = COLOUR_CLASS[kase?.mechanism ?? kase?.verdict] ?? "undecided";
    element("verdict-said").textContent = kase === null ? "" : verdictWords(kase);
    element("factor-said").replaceChildren(...(kase === null ? [] : factorWords(kase)));
    const required = kase === null ? "" : requiredWords(store.lastSolution, kase);
    element("required-said").textContent = required;
    element("required-said").hidden = required === "";
    element("required-said").classList.toggle("lacking", required !== "" && isLacking(store.lastSolution, kase));
  };
  drawing.above = () => element("badge").offsetTop + element("badge").offsetHeight + CLEAR;
  for (const event of ["solution", "problem", "late"]) store.addEventListener(event, show);
  store.addEventListener("text", () => store.lastSolution === null && show());
  drawing.addEventListener("case", show);
}

/** What the factor must reach, and whether it does: of the load case that is shown, else of the scene. */
function requirementOf({ loadCases }, kase) {
  const listed = loadCases?.cases.find(({ name }) => name === loadCases.shown);
  const of = kase.governing_fos ?? kase;
  return { required: listed?.required ?? of.required_fos, met: listed?.met ?? of.meets_required };
}

const isLacking = (solution, kase) => requirementOf(solution, kase).met !== "met";

function requiredWords(solution, kase) {
  const { required, met } = requirementOf(solution, kase);
  if (!met) return "";
  return required?.value === undefined ? say("Required factor: %s", say(met)) : say("FoS %s required: %s", fosText(required), say(met));
}

/** @param {any} kase of the answer @returns {string} */
export function verdictWords(kase) {
  const does = sentence(say(kase.mechanism ?? kase.verdict));
  if (kase.in_place) return does;
  return kase.tilt_angle_deg ? say("%s at %s", does, degreesText(kase.tilt_angle_deg)) : say("%s first, as it is tilted", does);
}

/** The number stands out, and what it is against follows. */
function factorWords({ governing_fos: governing, tilt_angle_deg: tilt, onset, fos, fos_driving: driving }) {
  if (governing === undefined) {
    if (drives({ fos, fos_driving: driving })) return parts("FoS %s on driving loads", strong(fosText(driving)));
    return fos ? parts("FoS %s by strength reduction", strong(fosText(fos))) : [];
  }
  if (!tilt && onset?.kind === "angle") return [say("Certain to stand up to %s", degreesText(onset.critical_angle_deg))];
  if (governing.fos === null) return [say("FoS") + " " + say(governing.fos_is ?? "none")];
  if (governing.mechanism === undefined) return parts("FoS %s", strong(fosText(governing.fos)));
  const against = againstText(governing.mechanism);
  return governing.complete !== false
    ? parts("FoS %s against %s", strong(fosText(governing.fos)), against)
    : parts("FoS at most %s against %s", strong(fosAtMostText(governing.fos)), against);
}

function strong(text) {
  const made = document.createElement("strong");
  made.textContent = text;
  return made;
}
