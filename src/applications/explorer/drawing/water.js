// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The water behind the block: on the up-dip side, up to its height along the face, or level whatever the tilt. */

const WIDTH = 0.3; // of the block's

/**
 * @param {import("./handle.js").Context} context @param {object} outlines of the answer
 * @param {number} turn of the drawing, radians
 * @returns {string} a path in the frame of the drawing; empty where there is none
 */
export function waterPath(context, outlines, turn) {
  if (outlines.water === undefined) return "";
  const { contact, towards } = context.kase;
  const end = contact[towards === "left" ? "right_end" : "left_end"];
  const foot = context.result(end.x_m, end.y_m);
  const side = towards === "left" ? 1 : -1;
  const across = side * WIDTH * (outlines.box_m[2] - outlines.box_m[0]);
  const { height_m: height, stays_level: level } = outlines.water;
  // over a level face the height is upright, and the surface turns against the tilt
  const top = level ? height / Math.max(0.05, Math.cos(turn)) : height;
  const drop = level ? -across * Math.tan(Math.max(-1.4, Math.min(1.4, turn))) : 0;
  const corners = [[0, 0], [across, 0], [across, Math.max(0, top + drop)], [0, top]];
  return corners.map(([x, y], i) => (i === 0 ? "M" : "L") + (foot.x + x) + " " + (foot.y + y)).join("") + "Z";
}
