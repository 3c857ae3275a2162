// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The block as the text has it now, for the moment until the core has answered. Shapes of arcs wait for the core. */

import { listedBlocks } from "./listed_blocks.js";
import { ringOf } from "./rings.js";

/**
 * @param {import("./handle.js").Context} context
 * @param {number} dot the length of a dot of the screen: of vertices that lie within one of each other the first is drawn
 * @param {(string|number)[][]|null} touched paths of the numbers that were dragged since the last answer; null: the text was changed otherwise
 * @returns {string} a path in the frame of the drawing
 */
export function previewPath(context, dot, touched) {
  if (context.block === null) return "";
  if (context.many) {
    const blocks = new Set(touched?.map((path) => path[1]));
    return listedBlocks(context).filter(({ path }) => blocks.has(path[1])).map(({ path, placement }) => ringPath(ringOf(context, path), placement, dot)).join("");
  }
  const ring = ringOf(context);
  const vertices = ring === null ? null : verticesOf(touched);
  return vertices === null ? ringPath(ring, context.block, dot) : edgesPath(ring, context.block, vertices);
}

/** Those of the outline, where no other number was dragged. @returns {number[]|null} */
function verticesOf(touched) {
  const isVertex = (path) => path.length === 4 && path[0] === "block" && path[1] === "outline";
  return touched !== null && touched.length > 0 && touched.every(isVertex) ? [...new Set(touched.map((path) => path[2]))] : null;
}

/** The edges at some vertices: of thousands the others lie where they are drawn. */
function edgesPath(ring, placement, vertices) {
  const at = (i) => {
    const { x, y } = ring[(i + ring.length) % ring.length];
    const { x: across, y: up } = placement.toFrame(x, y);
    return across + " " + up;
  };
  return vertices.map((i) => "M" + at(i - 1) + "L" + at(i) + "L" + at(i + 1)).join("");
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
