// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A mesh that a plane cuts: the triangles that lie above, with those that it meets cut, and where it meets them. */

/**
 * @typedef {object} Cut
 * @property {Float64Array} above nine numbers for each triangle
 * @property {number[][][]} section pairs of points, which are its edges; the rock lies to the left of each, seen from above
 */

/** @param {Float64Array} triangles nine numbers each, counterclockwise from outside @param {number[]} up across the plane, of length 1 @param {number} level along it @returns {Cut} */
export function cutMesh(triangles, up, level) {
  const above = [];
  const section = [];
  for (let k = 0; k < triangles.length; k += 9) {
    const corners = [0, 3, 6].map((at) => triangles.subarray(k + at, k + at + 3));
    const heights = corners.map((corner) => along(corner, up) - level);
    if (heights.every((height) => height >= 0)) above.push(...triangles.subarray(k, k + 9));
    else if (heights.some((height) => height > 0)) pieceOf(corners, heights, above, section);
  }
  return { above: Float64Array.from(above), section };
}

/** The lowest height of points. @param {Float64Array} points three numbers each @param {number[]} up */
export function lowestOf(points, up) {
  let lowest = Infinity;
  for (let k = 0; k < points.length; k += 3) lowest = Math.min(lowest, along(points.subarray(k, k + 3), up));
  return lowest;
}

/** What of a triangle lies above is one or two; where it is left and entered again is an edge of the section. */
function pieceOf(corners, heights, above, section) {
  const kept = [];
  const edge = [];
  for (let from = 0; from < 3; from++) {
    const to = (from + 1) % 3;
    if (heights[from] >= 0) kept.push(corners[from]);
    if (heights[from] >= 0 === heights[to] >= 0) continue;
    const share = heights[from] / (heights[from] - heights[to]);
    const met = [...corners[from]].map((value, axis) => value + share * (corners[to][axis] - value));
    kept.push(met);
    edge[heights[from] >= 0 ? 0 : 1] = met; // left, entered
  }
  for (let k = 1; k + 1 < kept.length; k++) above.push(...kept[0], ...kept[k], ...kept[k + 1]);
  section.push(edge);
}

function along(point, up) {
  return point[0] * up[0] + point[1] * up[1] + point[2] * up[2];
}
