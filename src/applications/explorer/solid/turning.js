// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Turns of a solid: matrices of nine numbers, row by row, that act on columns. */

/** @typedef {number[]} Turn @typedef {[number, number, number]} Vector */

/** @param {Turn} a @param {Turn} b @returns {Turn} first b, then a */
export function after(a, b) {
  return a.map((_, k) => [0, 1, 2].reduce((sum, j) => sum + a[3 * Math.floor(k / 3) + j] * b[3 * j + (k % 3)], 0));
}

/** @param {Turn} turn @param {Vector} v @returns {Vector} */
export function turned(turn, [x, y, z]) {
  return [0, 3, 6].map((k) => turn[k] * x + turn[k + 1] * y + turn[k + 2] * z);
}

/** About an axis of length 1, by radians. @param {Vector} axis @param {number} angle @returns {Turn} */
export function about([x, y, z], angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const d = 1 - c;
  return [c + x * x * d, x * y * d - z * s, x * z * d + y * s, y * x * d + z * s, c + y * y * d, y * z * d - x * s, z * x * d - y * s, z * y * d + x * s, c + z * z * d];
}

/** The least turn that brings a direction upright. @param {Vector} up @returns {Turn} */
export function upright(up) {
  const long = Math.hypot(...up);
  const [x, y, z] = up.map((each) => each / long);
  const sine = Math.hypot(x, y);
  if (sine < 1e-15) return z > 0 ? about([1, 0, 0], 0) : about([1, 0, 0], Math.PI);
  return about([y / sine, -x / sine, 0], Math.atan2(sine, z));
}

/** A base that dips by so many degrees towards an azimuth, clockwise from north, which is y. @returns {Turn} */
export function tilted(degrees, azimuth) {
  const way = (azimuth * Math.PI) / 180;
  // the axis lies across the way down: east is x
  return about([-Math.cos(way), Math.sin(way), 0].map((each) => (Object.is(each, -0) ? 0 : each)), (degrees * Math.PI) / 180);
}

/** @param {Turn} turn @returns {Turn} */
export function inverse(turn) {
  return turn.map((_, k) => turn[3 * (k % 3) + Math.floor(k / 3)]);
}

/** As it is seen: from an azimuth, and from so high, both in radians. @returns {Turn} x to the right, y up, z to the eye */
export function seenFrom(around, height) {
  return after(about([1, 0, 0], -Math.PI / 2 + height), about([0, 0, 1], around));
}

/** Where a solid is looked at from at first, radians. */
export const FIRST = { around: 0.5, height: 0.35 };
