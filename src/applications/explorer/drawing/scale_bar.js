// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A bar of a round length in the scene's own unit, in the corner of the drawing that the tilt leaves free. */

import { numeral } from "../words/language.js";

const DOTS_MAX = 140;
const EDGE = 24;

/** @param {number} dotsPerUnit @param {number} [most] dots @returns {{length: number, dots: number}} 1, 2 or 5 times a power of ten */
export function roundLength(dotsPerUnit, most = DOTS_MAX) {
  const power = 10 ** Math.floor(Math.log10(most / dotsPerUnit));
  const length = power * [5, 2, 1].find((times) => times * power * dotsPerUnit <= most);
  return { length, dots: length * dotsPerUnit };
}

/** @param layer a d3 selection @param {import("./view.js").View} view @param {number} sign of the tilt @param {import("./handle.js").Context} context */
export function drawScale(layer, view, sign, context) {
  const { length, dots } = roundLength(view.dotsPerMetre * context.metres);
  const [x, y] = [sign > 0 ? view.width - EDGE - dots : EDGE, view.height - EDGE];
  layer.select("path").attr("d", "M" + x + " " + (y - 5) + "v5h" + dots + "v-5");
  layer.select("text").attr("x", x + dots / 2).attr("y", y - 9).text(numeral(Number(length.toPrecision(12)) + " " + context.unit));
}
