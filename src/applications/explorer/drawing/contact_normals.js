// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Which way the faces of the contact look, read off its path: for the friction cones of the reactions. */

/** @param {string} path of straight lines @returns {{from: number[], to: number[]}[]} from left to right */
export function contactFaces(path) {
  const faces = [];
  let last = null;
  for (const [, command, numbers] of path.matchAll(/([MLCZ])([^MLCZ]*)/g)) {
    const at = numbers.trim().split(/[\s,]+/).map(Number).slice(-2);
    if (command !== "M" && command !== "Z" && last !== null) faces.push({ from: last, to: at });
    last = command === "Z" ? null : at;
  }
  return faces;
}

/**
 * The normal of the face at a point that a reaction is nearest to: at a vertex two faces meet, and the reaction is of
 * the one whose friction cone holds it.
 * @param {{from: number[], to: number[]}[]} faces
 * @param {number[]} point @param {number[]} reaction
 * @param {number} near how far a point may be from an end of a face to be on it
 * @returns {number[]|null} of length 1, away from the base
 */
export function normalAt(faces, point, reaction, near) {
  let best = null;
  for (const { from, to } of faces) {
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const length = Math.hypot(dx, dy);
    if (length === 0 || distance(from, to, point) > near) continue;
    const normal = dx < 0 ? [dy / length, -dx / length] : [-dy / length, dx / length];
    const along = normal[0] * reaction[0] + normal[1] * reaction[1];
    if (best === null || along > best.along) best = { normal, along };
  }
  return best === null ? null : best.normal;
}

function distance([x0, y0], [x1, y1], [x, y]) {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const share = Math.max(0, Math.min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(x0 + share * dx - x, y0 + share * dy - y);
}
