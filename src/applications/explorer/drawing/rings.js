// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A block as the text has it: a ring of straight edges, in its own coordinates. */

import { teethOf } from "./block_handles.js";
import { pointsOf } from "./points.js";

/** @param {import("./handle.js").Context} context @param {(string|number)[]} [of] the block @returns {import("./handle.js").Point[]|null} in the scene's coordinates; null: it has arcs, or cannot be told */
export function ringOf(context, of = ["block"]) {
  return slabRing(context, of) ?? teethRing(context, of) ?? outlineRing(context, of);
}

function slabRing(context, of) {
  const width = context.number([...of, "slab", "width"]).value;
  const height = context.number([...of, "slab", "height"]).value;
  if (width === null || height === null) return null;
  return [{ x: 0, y: 0 }, { x: width, y: 0 }, { x: width, y: height }, { x: 0, y: height }];
}

function teethRing(context, of) {
  if (context.scene.keys([...of, "teeth"]) === null) return null;
  const teeth = teethOf(context, of);
  if (teeth === null) return null;
  const { count, a, b, c, valley } = teeth;
  const ring = [];
  for (let i = 0; i <= count; i++) ring.push({ x: i * a, y: (i % 2 === 0) === valley ? 0 : c });
  return [...ring, { x: count * a, y: b + c }, { x: 0, y: b + c }];
}

function outlineRing(context, of) {
  if (context.scene.count([...of, "arcs"]) !== null) return null;
  const ring = pointsOf(context, [...of, "outline"]);
  return ring.includes(null) ? null : ring;
}
