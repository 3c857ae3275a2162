// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A number that is typed into a field, with a decimal point or a decimal comma. */

import { decimalValue } from "../scene/decimal.js";
import { numeral, say } from "../words/language.js";

/**
 * @param {string} typed @param {number} greatest from 0
 * @returns {{text: string|null, wrong: string}} text: as a scene has it; null: it is none yet, and why, if something is wrong
 */
export function typedNumber(typed, greatest) {
  const text = typed.trim().replace(",", ".");
  if (text === "") return { text: null, wrong: "" };
  const value = decimalValue(text);
  if (value === null) return { text: null, wrong: say("not a number") };
  if (value < 0 || value > greatest) return { text: null, wrong: say("from 0 to %s", numeral(String(greatest))) };
  return { text, wrong: "" };
}
