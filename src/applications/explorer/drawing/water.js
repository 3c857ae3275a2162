// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The water behind the block, on the up-dip side: its surface is level whatever the tilt. The load is hydrostatic below the
 * point of the face that the water reaches: a `height` is measured along the face, and with `stays_level` upright, so that
 * the point rises along the face as the table is tilted (docs/loads.md). Water by its `level` is drawn as its pressures.
 */

const WIDTH = 0.3; // of the block's
const LEAST_COSINE = 0.05; // nearly upright the face would be wetted without end

/**
 * Where the water meets the face, above its foot along the face.
 * @param {number} height @param {boolean} staysLevel @param {number} turn of the drawing, radians
 */
export function wettedHeight(height, staysLevel, turn) {
  return staysLevel ? height / Math.max(LEAST_COSINE, Math.cos(turn)) : height;
}

/** Up-dip is where the base rises to. @returns {1|-1} along x of the frame */
const upDip = ({ towards }) => (towards === "left" ? 1 : -1);

/** Where the foot of the wetted face is, in the frame of the drawing. @param {import("./handle.js").Context} context */
export function waterFoot(context) {
  const end = context.kase.contact[upDip(context.kase) > 0 ? "right_end" : "left_end"];
  return context.result(end.x_m, end.y_m);
}

/**
 * Corners from the foot of the face, in lengths along the base, up-dip being positive, and upright to it.
 * @param {number} top where the surface meets the face @param {number} width of the water along the base, at most
 * @param {number} tilt by which the base rises up-dip, radians
 * @returns {[number, number][]} none where there is nothing to be seen
 */
export function waterCorners(top, width, tilt) {
  if (!(top > 0) || Math.abs(tilt) >= Math.PI / 2) return [];
  const slope = Math.tan(tilt);
  const far = top - width * slope;
  // where the base rises above the surface within the width, the water ends there
  return far > 0 ? [[0, 0], [width, 0], [width, far], [0, top]] : [[0, 0], [top / slope, 0], [0, top]];
}

/**
 * @param {import("./handle.js").Context} context @param {object} outlines of the answer
 * @param {number} turn of the drawing, radians, counter-clockwise
 * @returns {string} a path in the frame of the drawing; empty where there is none
 */
export function waterPath(context, outlines, turn) {
  if (outlines.water === undefined) return "";
  const foot = waterFoot(context);
  const side = upDip(context.kase);
  const { height_m: height, stays_level: staysLevel } = outlines.water;
  const corners = waterCorners(wettedHeight(height, staysLevel, turn), WIDTH * (outlines.box_m[2] - outlines.box_m[0]), side * turn);
  return corners.map(([x, y], i) => (i === 0 ? "M" : "L") + (foot.x + side * x) + " " + (foot.y + y)).join("") + (corners.length > 0 ? "Z" : "");
}
