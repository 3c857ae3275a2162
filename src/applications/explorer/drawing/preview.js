// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The block as the text has it now, for the moment until the core has answered. Shapes of arcs wait for the core. */

import { listedBlocks } from "./listed_blocks.js";
import { ringOf } from "./rings.js";

/**
 * @param {import("./handle.js").Context} context
 * @param {number} dot the length of a dot of the screen: of vertices that lie within one of each other the first is drawn
 * @param {Set<number>} touched of many blocks those that were dragged
 * @returns {string} a path in the frame of the drawing
 */
export function previewPath(context, dot, touched) {
  if (context.block === null) return "";
  if (!context.many) return ringPath(ringOf(context), context.block, dot);
  return listedBlocks(context).filter(({ path }) => touched.has(path[1])).map(({ path, placement }) => ringPath(ringOf(context, path), placement, dot)).join("");
}

function ringPath(ring, placement, dot) {
  if (ring === null || ring.length < 3) return "";
  const pieces = [];
  let last = null;
  for (const { x, y } of ring) {
    const at = placement.toFrame(x, y);
    if (last !== null && Math.abs(at.x - last.x) < dot && Math.abs(at.y - last.y) < dot) continue;
    pieces.push((last === null ? "M" : "L") + at.x + " " + at.y);
    last = at;
  }
  return pieces.join("") + "Z";
}
