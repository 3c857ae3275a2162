// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The points of a CSV file as a list of a scene, digit by digit, so that they can be dragged. The core reads the file
 * itself; whether this list means the same is seen by its answer, which must not change.
 */

/** More points than that are no longer dragged one by one. */
export const POINTS_MAX = 400;
const SEPARATORS = [";", "\t", ","];
const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/;

/** @param {string} text @returns {string|null} [[x, y], …]; null: no points, too many, or columns told by a header */
export function pointsOfCsv(text) {
  const points = rowsOfCsv(text);
  return points === null || points.length > POINTS_MAX ? null : "[" + points.map(([x, y]) => "[" + x + ", " + y + "]").join(", ") + "]";
}

/**
 * What a file of points is, where nobody says so: points whose x goes one way alone are a profile of ground, others go
 * round a block.
 * @param {string} text @returns {{from: number, to: number, top: number}|null} where the profile ends and how high it is; null: none
 */
export function profileOfCsv(text) {
  const points = rowsOfCsv(text)?.map((row) => row.map(Number)) ?? [];
  if (points.length < 2) return null;
  const way = Math.sign(points[1][0] - points[0][0]);
  if (points.some(([x], i) => i > 0 && Math.sign(x - points[i - 1][0]) !== way) || way === 0) return null;
  const [from, to] = [points[0][0], points[points.length - 1][0]].sort((a, b) => a - b);
  return { from, to, top: Math.max(...points.map(([, y]) => y)) };
}

/** @returns {string[][]|null} rows of two numbers each, those twice in a row once */
function rowsOfCsv(text) {
  const rows = text.split(/\r?\n/).map((line) => line.replace(/#.*/, "").trim()).filter((line) => line !== "").map(cells);
  const first = rows.findIndex((row) => row.length >= 2 && row.every((cell) => NUMBER.test(cell)));
  if (first < 0 || rows.slice(first).some((row) => row.length !== 2 || !row.every((cell) => NUMBER.test(cell)))) return null;
  const points = rows.slice(first).filter((row, i, all) => i === 0 || row.join() !== all[i - 1].join());
  return points.length < 2 ? null : points;
}

function cells(line) {
  const separator = SEPARATORS.find((one) => line.includes(one)) ?? /\s+/;
  return line.split(separator).map((cell) => cell.trim().replace(/^"(.*)"$/, "$1"));
}
