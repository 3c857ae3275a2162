// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Paths with more points than a screen has dots are drawn with fewer: what lies within a dot of the point before goes. */

const LONG = 20_000;
const FAR_NUMBER = /e\+?(1[5-9]|[2-9]\d|\d{3})/;
const COMMAND = /([MLCZ])([^MLCZ]*)/g;

/** @param {string} path @returns {number[][]} the ends of its edges */
export function pathPoints(path) {
  return [...path.matchAll(COMMAND)].filter(([, command]) => command !== "Z").map(([, , numbers]) => ends(numbers));
}

/** @param {string} path of one open chain @returns {number[][]|null} its first and its last point, without reading the rest */
export function pathEnds(path) {
  const first = /^M([^MLCZ]*)/.exec(path);
  const last = /[ML]([^MLCZ]*)$/.exec(path.slice(-100));
  return first === null || last === null ? null : [ends(first[1]), ends(last[1])];
}

function ends(numbers) {
  return numbers.trim().split(/[\s,]+/).slice(-2).map(Number);
}

/**
 * Ends of edges that lie beyond all reach are drawn nearer, in their direction: browsers draw in single precision.
 * @param {string} path M, L, Z @param {number} reach metres @returns {string}
 */
export function nearPath(path, reach) {
  if (!FAR_NUMBER.test(path)) return path;
  let last = null;
  return [...path.matchAll(COMMAND)].map(([, command, numbers]) => {
    if (command === "Z") return command;
    const [x, y] = ends(numbers);
    const from = last ?? { x: 0, y: 0 };
    const share = Math.min(1, reach / Math.max(Math.abs(x - from.x), Math.abs(y - from.y)));
    last = share < 1 ? { x: from.x + share * (x - from.x), y: from.y + share * (y - from.y) } : { x, y };
    return command + last.x + " " + last.y;
  }).join("");
}

/**
 * @param {string} path M, L, C, Z with absolute coordinates
 * @param {number} dot the length of a dot of the screen
 * @returns {string} the same path where it is short; else one of straight lines that leaves it by at most a dot
 */
export function thinPath(path, dot) {
  if (path.length <= LONG) return path;
  const pieces = [];
  let last = null;
  let left = null; // the last point that was left out
  for (const [, command, numbers] of path.matchAll(COMMAND)) {
    if (command === "Z") {
      pieces.push("Z");
      last = left = null;
      continue;
    }
    const [x, y] = ends(numbers);
    if (command === "M") {
      pieces.push("M" + x + " " + y);
    } else if (last !== null && Math.abs(x - last.x) < dot && Math.abs(y - last.y) < dot) {
      left = { x, y };
      continue;
    } else {
      if (left !== null) pieces.push("L" + left.x + " " + left.y);
      pieces.push("L" + x + " " + y);
    }
    last = { x, y };
    left = null;
  }
  return pieces.join("");
}
