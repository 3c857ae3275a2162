// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Block, base and contact as the core drew them: paths in metres inside a group that the view turns and scales. */

import { shapesOfMany } from "./shapes_of_many.js";
import { nearPath, pathPoints, thinPath } from "./thin_path.js";

/** Browsers draw in single precision, and Firefox stops for good at matrices of 4e-12: diagonals beyond these are not drawn, in metres, ... */
const SIZES = { least: 1e-15, most: 1e11 };
/** ... and what lies farther off than so many of them is drawn nearer. */
const REACH = 1e9;
const ROCK_DEPTH = 0.3; // of the block's height

const diagonal = ({ box_m: [x0, y0, x1, y1] }) => Math.hypot(x1 - x0, y1 - y0);

/** @param {object} outlines of an answer @returns {boolean} */
export function isDrawable(outlines) {
  return diagonal(outlines) >= SIZES.least && diagonal(outlines) <= SIZES.most;
}

/** @param {object} outlines @returns {number} metres */
export function reachOf(outlines) {
  return REACH * diagonal(outlines);
}

/**
 * @param {object} answer @param {object} kase of it
 * @param {number} dot the length of a dot of the screen, metres
 * @returns {{name: string, path: string, layer: "still"|"moving"|"front", style?: string|null}[]} from the back to the front
 */
export function shapesOf(answer, kase, dot) {
  const { outlines } = answer;
  return answer.kind === "blocks" ? shapesOfMany(answer, kase, dot, reachOf(outlines)) : shapesOfOne(outlines, dot);
}

function shapesOfOne(outlines, dot) {
  const base = thinPath(nearPath(outlines.base, reachOf(outlines)), dot);
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
      .attr("class", (shape) => "shape " + shape.name).attr("d", (shape) => shape.path).attr("style", (shape) => shape.style ?? null);
  }
}
