// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Block, base, contact and water as the core drew them: paths in metres inside a group that the view turns and scales. */

import { thinPath } from "./thin_path.js";

/**
 * @param {object} outlines of the answer
 * @param {number} dot the length of a dot of the screen, metres
 * @returns {{name: string, path: string, moves: boolean}[]} from the back to the front; moves: with the block
 */
export function shapesOf(outlines, dot) {
  const shapes = [["base", outlines.base, false], ["water", outlines.water, false], ["block", outlines.block, true]];
  (outlines.parts ?? []).forEach((path, i) => shapes.push([i % 2 === 0 ? "part" : "part other", path, true]));
  shapes.push(["contact", outlines.contact, false]);
  return shapes
    .filter(([, path]) => typeof path === "string" && path !== "")
    .map(([name, path, moves]) => ({ name, path: thinPath(path, dot), moves }));
}

/** @param selections d3 selections of the groups that stay and that move @param {ReturnType<typeof shapesOf>} shapes */
export function drawShapes({ still, moving, front }, shapes) {
  const into = (group, kept) => {
    group.selectAll("path").data(kept).join("path").attr("class", (shape) => "shape " + shape.name).attr("d", (shape) => shape.path);
  };
  into(still, shapes.filter((shape) => !shape.moves && shape.name !== "contact"));
  into(moving, shapes.filter((shape) => shape.moves));
  into(front, shapes.filter((shape) => shape.name === "contact"));
}
