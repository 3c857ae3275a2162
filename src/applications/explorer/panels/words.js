// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The words of results: those of the JSON itself, and what the reports of the command line say for them. */

import { say } from "../words/language.js";

/** What a factor of safety of each definition is the quotient of. */
const DEFINITIONS = {
  moments: say("moments: stabilising over overturning"),
  "shear strength": say("shear strength on the facet: tan φ/tan(α−i)"),
  "shear strength with roughness": say("shear strength, mean plane: tan(φ+i)/tan α"),
  "strength reduction": say("strength reduction, by contact forces"),
  "driving loads": say("driving loads: tan α_s/tan α"),
};

/** Under loads no angle alone says it. */
const DEFINITIONS_UNDER_LOADS = {
  ...DEFINITIONS,
  "shear strength": say("shear strength on the facet, under loads"),
  "driving loads": say("driving loads, by contact forces"),
};

const AGAINST = {
  topples: "toppling",
  slides: "sliding",
  "slides and topples": "sliding and toppling",
  "leaves its base": "leaving its base",
};

/** What asks `explain` for a definition: the term that it knows. */
const TERM_OF_DEFINITION = {
  moments: "limit equilibrium",
  "shear strength": "sliding",
  "shear strength with roughness": "Patton's law",
  "strength reduction": "strength reduction",
  "driving loads": "onset of motion",
};

export const COLOUR_CLASS = {
  stands: "stands",
  interlocked: "stands",
  "may move": "may-move",
  slides: "slides",
  topples: "topples",
  "slides and topples": "slides-and-topples",
  "leaves its base": "leaves",
  undecided: "undecided",
  "holds nowhere": "topples",
};

/** @param {string} definition @param {any} theCase */
export function definitionText(definition, theCase) {
  const texts = theCase.loads === undefined ? DEFINITIONS : DEFINITIONS_UNDER_LOADS;
  return texts[definition] ?? definition;
}

/** @param {string} definition */
export function termOfDefinition(definition) {
  return TERM_OF_DEFINITION[definition] ?? "factor of safety";
}

/** @param {string|null} mechanism */
export function againstText(mechanism) {
  return say(AGAINST[mechanism] ?? mechanism ?? "");
}

/** @param {string} text */
export function sentence(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** As reports head a direction of tilt. @param {any} theCase @param {string|null} tilt as text, with its unit */
export function directionText(theCase, tilt) {
  const tilted = say("Tilted towards the " + theCase.towards);
  return tilt === null ? tilted : say("%s by %s", tilted, tilt);
}
