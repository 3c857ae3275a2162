// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The outlines of a solution, which are SVG path data in metres, as points: for places beside them, never for results. */

const COMMAND = /([MLCZ])([^MLCZ]*)/g;

/**
 * Polylines of path data; of a curve only its end is taken.
 * @param {string} data
 * @returns {{points: {x: number, y: number}[], closed: boolean}[]}
 */
function polylines(data) {
  const found = [];
  for (const [, command, numbers] of data.matchAll(COMMAND)) {
    const values = numbers.trim().split(/[\s,]+/).filter((each) => each !== "").map(Number);
    if (command === "M") found.push({ points: [], closed: false });
    const line = found[found.length - 1];
    if (line === undefined) continue;
    if (command === "Z") line.closed = true;
    const step = command === "C" ? 6 : 2;
    for (let at = step - 2; at + 1 < values.length; at += step) line.points.push({ x: values[at], y: values[at + 1] });
  }
  return found;
}

/** The pieces of polylines, each from one point to the next. @param {string} data */
export function segments(data) {
  return polylines(data).flatMap(({ points, closed }) => {
    const ends = closed && points.length > 0 ? [...points, points[0]] : points;
    return ends.slice(1).map((to, index) => ({ from: ends[index], to }));
  });
}
