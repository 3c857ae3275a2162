// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Block, base and contact as the core drew them: paths in metres inside a group that the view turns and scales. */

import { pathPoints, thinPath } from "./thin_path.js";

const ROCK_DEPTH = 0.3; // of the block's height

/**
 * @param {object} outlines of the answer
 * @param {number} dot the length of a dot of the screen, metres
 * @returns {{name: string, path: string, layer: "still"|"moving"|"front"}[]} from the back to the front
 */
export function shapesOf(outlines, dot) {
  const base = thinPath(outlines.base, dot);
  const shapes = [["rock", rockPath(base, outlines.box_m), "still"], ["base", base, "still"], ["block", thinPath(outlines.block, dot), "moving"]];
  outlines.parts.forEach((path, i) => shapes.push([i % 2 === 0 ? "part" : "part other", thinPath(path, dot), "moving"]));
  shapes.push(["elements", outlines.elements, "moving"], ["contact", thinPath(outlines.contact, dot), "front"]);
  return shapes.filter(([, path]) => path !== "").map(([name, path, layer]) => ({ name, path, layer }));
}

/** What lies below the base: down to some way below its deepest point, and cut off upright where it ends. */
function rockPath(base, [, bottom, , top]) {
  const points = pathPoints(base);
  if (points.length < 2) return "";
  const floor = points.reduce((low, [, y]) => Math.min(low, y), bottom) - ROCK_DEPTH * (top - bottom);
  return base + "L" + points[points.length - 1][0] + " " + floor + "L" + points[0][0] + " " + floor + "Z";
}

/** @param {Record<string, object>} layers d3 selections of groups, by name @param {ReturnType<typeof shapesOf>} shapes */
export function drawShapes(layers, shapes) {
  for (const layer of ["still", "moving", "front"]) {
    layers[layer].selectAll("path").data(shapes.filter((shape) => shape.layer === layer)).join("path")
      .attr("class", (shape) => "shape " + shape.name).attr("d", (shape) => shape.path);
  }
}
