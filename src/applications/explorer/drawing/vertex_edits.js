// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Vertices come and go by hand: a double click on an edge puts one there, and one that has the focus can be deleted. */

import { isSeq } from "yaml";
import { snap } from "../scene/decimal.js";
import { withItem, withoutItem } from "../scene/list_edits.js";
import { ringsOf } from "./block_handles.js";
import { listedBlocks } from "./listed_blocks.js";
import { pointsOf } from "./points.js";

const REACH = 14; // dots from an edge

/** Lists of points of a scene that are drawn. @param {import("./handle.js").Context} context */
function listsOf(context) {
  const blocks = context.many ? listedBlocks(context) : [{ path: ["block"], placement: context.block }];
  const rings = context.block === null ? [] : blocks.flatMap(({ path: of, placement }) => ringsOf(context, of).map(([path]) => ({ path, placement, closed: true })));
  const profile = context.base === null ? [] : [{ path: ["base", "profile"], placement: context.base, closed: false }];
  return [...rings, ...profile].filter(({ path }) => isSeq(context.scene.node(path)));
}

/**
 * The text with a vertex where an edge is near to a place of the screen.
 * @param {import("./handle.js").Context} context @param {import("./view.js").View} view @param {{x: number, y: number}} dots
 * @param {number} exponent of the step of its numbers @returns {string|null} null: there is no edge
 */
export function withVertexAt(context, view, dots, exponent) {
  let best = { far: REACH };
  for (const { path, placement, closed } of listsOf(context)) {
    const points = pointsOf(context, path);
    if (points.includes(null)) continue;
    const seen = points.map(({ x, y }) => {
      const at = placement.toFrame(x, y);
      return view.toScreen(at.x, at.y);
    });
    for (let i = 0; i < seen.length - (closed ? 0 : 1); i++) {
      const found = nearestOn(seen[i], seen[(i + 1) % seen.length], dots);
      if (found.far < best.far) best = { ...found, path, after: i, placement };
    }
  }
  if (best.path === undefined) return null;
  const frame = view.toFrame(best.at.x, best.at.y);
  return withPoint(context, best, best.placement.toScene(frame.x, frame.y), exponent);
}

/** The text with a vertex in the middle between one and the next. @param {string} key of the handle of the one @returns {string|null} */
export function withVertexAfter(context, key, exponent) {
  const found = placeOf(context, key);
  if (found === null) return null;
  const points = pointsOf(context, found.path);
  const [from, to] = [points[found.index], points[(found.index + 1) % points.length]];
  if (!from || !to || (!found.closed && found.index + 1 === points.length)) return null;
  return withPoint(context, { path: found.path, after: found.index }, { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 }, exponent);
}

/** The text without a vertex. @param {string} key of its handle @returns {string|null} null: it is none, or too few would be left */
export function withoutVertex(context, key) {
  const found = placeOf(context, key);
  if (found === null || (context.scene.count(found.path) ?? 0) <= (found.closed ? 3 : 2)) return null;
  return withoutItem(context.scene, found.path, found.index);
}

function withPoint(context, { path, after }, { x, y }, exponent) {
  return withItem(context.scene, path, after, "[" + snap(x, exponent) + ", " + snap(y, exponent) + "]");
}

/** Which list a handle is of, and where it stands there. */
function placeOf(context, key) {
  const list = listsOf(context).find(({ path }) => key.startsWith(path.join(".") + ".") && /^\d+$/.test(key.slice(path.join(".").length + 1)));
  return list === undefined ? null : { ...list, index: Number(key.slice(list.path.join(".").length + 1)) };
}

function nearestOn(from, to, { x, y }) {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const share = Math.max(0, Math.min(1, ((x - from.x) * dx + (y - from.y) * dy) / (dx * dx + dy * dy || 1)));
  const at = { x: from.x + share * dx, y: from.y + share * dy };
  return { at, far: Math.hypot(at.x - x, at.y - y) };
}
