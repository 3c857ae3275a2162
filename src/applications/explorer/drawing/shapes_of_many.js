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
  const motions = kase.motions ?? [];
  const moved = wayOf(outlines.box_m, motions);
  const styles = blocks.map((block, k) => styleOf(block, motions[k], moved, outlines));
  const shapes = outlines.blocks.map((path, k) => (blocks[k].ground
    ? { name: "ground", path: thinPath(nearPath(path, reach), dot), layer: "still" }
    : { name: "block at-rest " + (TINTS[motions[k]?.mechanism] ?? ""), path: thinPath(path, dot), layer: "moving", style: styles[k] }));
  const mechanism = outlines.blocks.map((path, k) => ({ name: "mechanism", path, layer: "front", style: styles[k] })).filter(({ style }) => style !== null);
  const more = [...outlines.parts.map((path) => ["part", path, "moving"]), ["surface", outlines.water[cases.indexOf(kase)] ?? "", "front"]];
  return [...shapes, ...mechanism, ...more.map(([name, path, layer]) => ({ name, path, layer }))].filter(({ path }) => path !== "");
}

/** Of the fastest corner, metres. */
function wayOf([x0, y0, x1, y1], motions) {
  const turn = motions.reduce((most, { turn_per_m: one }) => Math.max(most, Math.abs(one)), 0);
  return Math.min(MOVED * Math.max(x1 - x0, y1 - y0), turn > 0 ? TURN_MOST / turn : Infinity);
}

/** What the style sheet moves it by. @returns {string|null} null: it stays where it is */
function styleOf(block, motion, moved, outlines) {
  if (block.ground || motion === undefined || motion.mechanism === "stands") return null;
  const [x, y] = [block.centroid_x_m.value - outlines.origin_x_m, block.centroid_y_m.value - outlines.origin_y_m];
  const [dx, dy] = [moved * motion.velocity_x, moved * motion.velocity_y];
  return "--cx:" + x + "px;--cy:" + y + "px;--dx:" + dx + "px;--dy:" + dy + "px;--turn:" + motion.turn_per_m * moved + "rad";
}
