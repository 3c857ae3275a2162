// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The editor has lines, each ended alike; the scene has the ends of the file that it came from. What is typed goes into
 * the scene's text, and the ends of all other lines stay as they are, those of Windows too.
 */

import { difference } from "./difference.js";

/** @param {string} text @returns {string} as the editor has it */
export function plainEnds(text) {
  return text.includes("\r") ? text.replace(/\r\n?/g, "\n") : text;
}

/**
 * @param {string} text of the scene
 * @param {string} typed what the editor has after a change
 * @returns {string} the scene's text after it; lines that are new end as its first line does
 */
export function withTyped(text, typed) {
  if (!text.includes("\r")) return typed;
  const change = difference(plainEnds(text), typed);
  if (change === null) return text;
  const end = /\r\n?|\n/.exec(text)[0];
  const [from, to] = [change.from, change.to].map((at) => placeIn(text, at));
  const after = text.slice(0, from) + change.insert.replaceAll("\n", end) + text.slice(to);
  // where ends of several kinds stand side by side, a deletion can join halves of two: then all lines get the first's
  return plainEnds(after) === typed ? after : typed.replaceAll("\n", end);
}

/** Where a character of the editor's text stands in the scene's: each pair of characters that ends a line is one there. */
function placeIn(text, at) {
  let place = at;
  for (let pair = text.indexOf("\r\n"); pair >= 0 && pair < place; pair = text.indexOf("\r\n", pair + 2)) place++;
  return place;
}
