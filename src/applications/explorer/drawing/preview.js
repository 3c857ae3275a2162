// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The block as the text has it now, for the moment until the core has answered: a ring of straight edges, in the
 * scene's own coordinates. Shapes of arcs have none, and wait for the core.
 */

import { teethOf } from "./block_handles.js";
import { pointsOf } from "./points.js";

/**
 * @param {import("./handle.js").Context} context
 * @param {number} dot the length of a dot of the screen: of vertices that lie within one of each other the first is drawn
 * @returns {string|null} a path in the frame of the drawing
 */
export function previewPath(context, dot) {
  if (context.block === null) return null;
  const ring = ringOf(context);
  if (ring === null || ring.length < 3) return null;
  const pieces = [];
  let last = null;
  for (const { x, y } of ring) {
    const at = context.block.toFrame(x, y);
    if (last !== null && Math.abs(at.x - last.x) < dot && Math.abs(at.y - last.y) < dot) continue;
    pieces.push((last === null ? "M" : "L") + at.x + " " + at.y);
    last = at;
  }
  return pieces.join("") + "Z";
}

/** @param {import("./handle.js").Context} context @returns {import("./handle.js").Point[]|null} in the scene's coordinates; null: it has arcs, or cannot be told */
export function ringOf(context) {
  return slabRing(context) ?? teethRing(context) ?? outlineRing(context);
}

function slabRing(context) {
  const width = context.number(["block", "slab", "width"]).value;
  const height = context.number(["block", "slab", "height"]).value;
  if (width === null || height === null) return null;
  return [{ x: 0, y: 0 }, { x: width, y: 0 }, { x: width, y: height }, { x: 0, y: height }];
}

function teethRing(context) {
  if (context.scene.keys(["block", "teeth"]) === null) return null;
  const teeth = teethOf(context);
  if (teeth === null) return null;
  const { count, a, b, c, valley } = teeth;
  const ring = [];
  for (let i = 0; i <= count; i++) ring.push({ x: i * a, y: (i % 2 === 0) === valley ? 0 : c });
  return [...ring, { x: count * a, y: b + c }, { x: 0, y: b + c }];
}

function outlineRing(context) {
  if (context.scene.count(["block", "arcs"]) !== null) return null;
  const ring = pointsOf(context, ["block", "outline"]);
  return ring.includes(null) ? null : ring;
}
