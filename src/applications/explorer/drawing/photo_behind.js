// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A photograph behind the block that was traced over it, turned and scaled with it. */

/**
 * @param layer a d3 selection of an image @param {import("./handle.js").Context|null} context
 * @param {{href: string, width: number, height: number, corners: {x: number, y: number}[]}|null} photograph corners: where its upper left
 *   corner, the dot to the right of it and that below lie, in the scene's coordinates
 */
export function drawPhotograph(layer, context, photograph) {
  const shown = photograph !== null && context?.block;
  layer.attr("display", shown ? null : "none");
  if (!shown) return;
  const [o, a, b] = photograph.corners.map(({ x, y }) => context.block.toFrame(x, y));
  layer.attr("href", photograph.href).attr("width", photograph.width).attr("height", photograph.height)
    .attr("transform", "matrix(" + [a.x - o.x, a.y - o.y, b.x - o.x, b.y - o.y, o.x, o.y].join(" ") + ")");
}
