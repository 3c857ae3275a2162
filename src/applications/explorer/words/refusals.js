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

/** @param {[string, string][]} rows a phrase, and what stands for it @returns {{pattern: RegExp, own: string}[]} */
export function recognisers(rows) {
  const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  return [...rows].sort((one, other) => told(other) - told(one))
    .map(([phrase, own]) => ({ pattern: new RegExp("^" + phrase.split(ARGUMENT).map(escaped).join("(.+?)") + "$", "s"), own }));
}

/** @param {string} message @param {{pattern: RegExp, own: string}[]} known @returns {string} */
export function recognised(message, known) {
  for (const { pattern, own } of known) {
    const found = pattern.exec(message);
    if (found !== null) return filled(own, found.slice(1).map((part) => recognised(part, known))).join("");
  }
  return say(message);
}

const KNOWN = recognisers(refusals);

/** @param {string} message of the program @returns {string} */
export function inOwnWords(message) {
  return KNOWN.length === 0 ? message : recognised(message, KNOWN);
}
