// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

import { say } from "../words/language.js";
import { inOwnWords } from "../words/refusals.js";

/**
 * What the program said on its standard error, as a place in the scene and words.
 * @typedef {{file: string|null, line: number|null, column: number|null, message: string}} Complaint
 */

/** @param {string} err @returns {Complaint} of the first line that says something */
export function readComplaint(err) {
  const said = err.split("\n").find((line) => line.trim() !== "") ?? say("the core ended without a message");
  const words = said.replace(/^topple(?: \w+)?: /, "");
  const placed = /^([^:\n]{1,300}):(\d{1,9}):(\d{1,9}): (.*)$/.exec(words);
  if (placed === null) return { file: null, line: null, column: null, message: inOwnWords(words) };
  return { file: placed[1].replace(/^\.\//, ""), line: Number(placed[2]), column: Number(placed[3]), message: inOwnWords(placed[4]) };
}

/** What the program said where it printed no answer. @param {{err: string}} answer @returns {Error} */
export function refusalOf({ err }) {
  return new Error(readComplaint(err).message);
}
