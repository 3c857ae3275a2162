// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Many blocks as the core drew them: each in the tint of how it moves, where the mechanism takes it, the surface of the water. */

import { nearPath, thinPath } from "./thin_path.js";

/** The mechanism is drawn so large, and no block turned by more. */
const MOVED = 0.06; // of the size of all
const TURN_MOST = 0.35; // radians

const TINTS = { slides: "slides", topples: "topples", "slides and topples": "slides-and-topples" };

/**
 * @param {object} answer of many blocks @param {object} kase of it
 * @param {number} dot the length of a dot of the screen, metres @param {number} reach how far off the ground is drawn
 * @returns {ReturnType<import("./shapes.js").shapesOf>} from the back to the front
 */
export function shapesOfMany({ blocks, cases, outlines }, kase, dot, reach) {
  const motionOf = (k) => kase.motions?.[k];
  const shapes = outlines.blocks.map((path, k) => (blocks[k].ground
    ? { name: "ground", path: thinPath(nearPath(path, reach), dot), layer: "still" }
    : { name: "block at-rest " + (TINTS[motionOf(k)?.mechanism] ?? ""), path: thinPath(path, dot), layer: "moving" }));
  const moved = kase.motions === undefined ? 0 : wayOf(outlines.box_m, kase.motions);
  const mechanism = outlines.blocks.map((path, k) => ({ name: "mechanism", path, layer: "front", transform: transformOf(blocks[k], motionOf(k), moved, outlines) }))
    .filter((shape) => shape.transform !== null);
  const more = [...outlines.parts.map((path) => ["part", path, "moving"]), ["surface", outlines.water[cases.indexOf(kase)] ?? "", "front"]];
  return [...shapes, ...mechanism, ...more.map(([name, path, layer]) => ({ name, path, layer }))].filter(({ path }) => path !== "");
}

/** Of the fastest corner, metres. */
function wayOf([x0, y0, x1, y1], motions) {
  const turn = motions.reduce((most, { turn_per_m: one }) => Math.max(most, Math.abs(one)), 0);
  return Math.min(MOVED * Math.max(x1 - x0, y1 - y0), turn > 0 ? TURN_MOST / turn : Infinity);
}

/** @returns {string|null} null: it stays where it is */
function transformOf(block, motion, moved, outlines) {
  if (block.ground || motion === undefined || motion.mechanism === "stands") return null;
  const [x, y] = [block.centroid_x_m.value - outlines.origin_x_m, block.centroid_y_m.value - outlines.origin_y_m];
  const degrees = (motion.turn_per_m * moved * 180) / Math.PI;
  return "translate(" + moved * motion.velocity_x + " " + moved * motion.velocity_y + ") rotate(" + degrees + " " + x + " " + y + ")";
}
