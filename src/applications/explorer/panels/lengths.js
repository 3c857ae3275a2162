// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Lengths of results, which are metres, in the unit of the scene. */

import { UNITS } from "../scene/length_units.js";
import { certainDigits } from "./certain.js";
import { between } from "../words/language.js";

const DIGITS = 6;

/** @param {import("../scene/store.js").SceneStore} store @returns {{name: string, metres: number}} */
export function lengthUnit(store) {
  const name = store.parsed.scalar(["length_unit"]);
  const [over, under] = Object.hasOwn(UNITS, name ?? "") ? UNITS[name] : [1n, 1n];
  return { name: Object.hasOwn(UNITS, name ?? "") ? name : "m", metres: Number(over) / Number(under) };
}

/** @param {import("./certain.js").Bounded|null} metres @param {{name: string, metres: number}} unit */
export function lengthText(metres, unit) {
  const text = certainDigits(metres, DIGITS, unit.metres);
  return /\d[.,]\d/.test(text) && !text.includes(" ") ? text.replace(/[.,]?0+$/, "") : text;
}

/** @param {any} x @param {any} y @param {{name: string, metres: number}} unit */
export function pointText(x, y, unit) {
  return "(" + lengthText(x, unit) + between + lengthText(y, unit) + ")";
}
