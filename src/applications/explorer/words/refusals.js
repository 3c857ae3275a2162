// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Messages of the program, which are English, in the reader's language: those of the table refusals.csv beside this file are
 * recognised by their words, and what varies in one may be one itself. A message that is not there stays as it is.
 */

import { filled, refusals, say } from "./language.js";

const ARGUMENT = "%s";

/** The more of its words are told, the sooner a phrase is tried. */
const told = ([phrase]) => phrase.replaceAll(ARGUMENT, "").length;

/** @typedef {{pattern: RegExp, own: string, quotes: boolean[]}} Recogniser quotes: of each part that varies, whether it is quoted */

/** @param {[string, string][]} rows a phrase, and what stands for it @returns {Recogniser[]} */
export function recognisers(rows) {
  const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  return [...rows].sort((one, other) => told(other) - told(one))
    .map(([phrase, own]) => ({ pattern: new RegExp("^" + phrase.split(ARGUMENT).map(escaped).join("(.+?)") + "$", "s"), own,
      quotes: phrase.split(ARGUMENT).slice(0, -1).map((before) => before.endsWith("'")) }));
}

/** @param {string} message @param {Recogniser[]} known @returns {string} */
export function recognised(message, known) {
  for (const { pattern, own, quotes } of known) {
    const found = pattern.exec(message);
    if (found !== null) return filled(own, found.slice(1).map((part, at) => (quotes[at] ? part : recognised(part, known)))).join("");
  }
  return say(message);
}

const KNOWN = recognisers(refusals);

/** @param {string} message of the program @returns {string} */
export function inOwnWords(message) {
  return KNOWN.length === 0 ? message : recognised(message, KNOWN);
}
