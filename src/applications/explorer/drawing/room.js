// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What of the scene a window is fitted to. */

import { zoomIdentity } from "d3-zoom";
import { resultPoint } from "./result_point.js";

const OTHER_SIZE = 2.5;
const CENTRE_NEAR = 0.6; // of the block's size

/** The block, room below it for the rock and the reactions that it bears, and its centre of rotation where that is near. */
export function roomOf(outlines, kase) {
  const [x0, y0, x1, y1] = outlines.box_m;
  const size = Math.max(y1 - y0, 0.4 * (x1 - x0));
  const room = [x0, y0 - 0.2 * size, x1, y1];
  const { centre_x_m: x, centre_y_m: y } = kase?.limit ?? {};
  if (x == null || y == null) return room;
  const at = resultPoint(outlines, x, y);
  const grown = [Math.min(room[0], at.x), Math.min(room[1], at.y), Math.max(room[2], at.x), Math.max(room[3], at.y)];
  const much = grown[2] - grown[0] > x1 - x0 + CENTRE_NEAR * size || grown[3] - grown[1] > y1 - y0 + CENTRE_NEAR * size;
  return much ? room : grown;
}

/**
 * Whether an answer lies by far elsewhere than what was fitted, is by far larger or smaller, or leaves a window that no hand has moved.
 * @param {import("./view.js").View} view @param {number[]} fitted box @param {object} outlines @param {{x: number, y: number}} origin
 */
export function isElsewhere(view, fitted, outlines, origin) {
  const [dx, dy] = [outlines.origin_x_m - origin.x, outlines.origin_y_m - origin.y];
  const box = roomOf(outlines);
  const size = Math.hypot(box[2] - box[0], box[3] - box[1]);
  const before = Math.hypot(fitted[2] - fitted[0], fitted[3] - fitted[1]);
  if (size > OTHER_SIZE * before || before > OTHER_SIZE * size || Math.hypot(dx, dy) > OTHER_SIZE * before) return true;
  const out = (x, y) => {
    const at = view.toScreen(x + dx, y + dy);
    return at.x < 0 || at.y < 0 || at.x > view.width || at.y > view.height;
  };
  const [x0, y0, x1, y1] = outlines.box_m;
  return view.zoom === zoomIdentity && [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].some(([x, y]) => out(x, y));
}
