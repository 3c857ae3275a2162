// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * What a scene can be given without a word of YAML: loads to be placed and dragged, and an outline in place of a slab or
 * of teeth. Sizes are assumed from the block's own, to be changed.
 *
 * @typedef {object} Sizes of the block
 * @property {number} height in lengths of the scene
 * @property {{x: number, y: number}} centroid where the outline has it
 * @property {number|null} weightKn
 * @property {{x: number, y: number}[]|null} ring its corners, where it has straight edges
 */

import { snap, stepExponent } from "./decimal.js";
import { withItem } from "./list_edits.js";

const SHARES = { water: 0.5, anchor: 0.1 }; // of the height, of the weight
const FORCE_KN = 10; // of an anchor of a block whose weight is not told
const DIGITS = 12;
const ROCK_KN_M3 = "26";

/** A number of one digit, near to a value. */
function rough(value) {
  return snap(value, stepExponent(value, 1));
}

/** By their names in the menu: the text of a scene with them, or why it cannot have them. @type {Record<string, object>} */
export const ADDITIONS = {
  water: {
    label: "Water behind it",
    has: (scene) => scene.has(["loads", "water"]),
    text: (scene, { height }) => put(scene, ["loads", "water", "height"], rough(SHARES.water * height)),
  },
  anchor: {
    label: "An anchor",
    has: () => false,
    text: (scene, sizes) => withAnchor(scene, sizes),
  },
  earthquake: {
    label: "An earthquake",
    has: (scene) => scene.has(["loads", "seismic"]),
    text: (scene) => put(scene, ["loads", "seismic", "horizontal"], "0.1"),
  },
  cohesion: {
    label: "Cohesion of its joint",
    has: (scene) => scene.has(["loads", "cohesion_kpa"]),
    text: (scene) => put(scene, ["loads", "cohesion_kpa"], "5"),
  },
  outline: {
    label: "Corners of its own",
    has: (scene, { ring }) => shapeOf(scene) === null || ring === null,
    text: (scene, { ring }) => withOutline(scene, ring),
  },
};

/** Loads are weighed against the block: one without a unit weight gets that of common rock, which the scene then shows. */
function put(scene, path, text) {
  const weight = ["block", "unit_weight_kn_m3"];
  return scene.withNumbers(scene.has(weight) ? [{ path, text }] : [{ path, text }, { path: weight, text: ROCK_KN_M3 }]);
}

function withAnchor(scene, { centroid, weightKn, height }) {
  const exponent = stepExponent(height, 0.05);
  const force = rough(weightKn === null ? FORCE_KN : SHARES.anchor * weightKn);
  const anchor = "{at: [" + snap(centroid.x, exponent) + ", " + snap(centroid.y, exponent) + "], direction_deg: 0, force_kn: " + force + "}";
  const path = ["loads", "anchors"];
  const count = scene.count(path);
  return count === null ? put(scene, path, "[" + anchor + "]") : withItem(scene, path, count - 1, anchor);
}

/** Which key makes the block of numbers. @returns {string|null} */
function shapeOf(scene) {
  return (scene.keys(["block"]) ?? []).find((key) => key === "slab" || key === "teeth") ?? null;
}

/** The corners in place of the numbers that they were made from. */
function withOutline(scene, ring) {
  const key = shapeOf(scene);
  const value = scene.node(["block", key]);
  const end = value.range[1];
  const from = scene.text.lastIndexOf(key, value.range[0]);
  const kept = /\s*$/.exec(scene.text.slice(from, end))[0];
  const decimal = (number) => String(Number(number.toPrecision(DIGITS)));
  const points = ring.map(({ x, y }) => "[" + decimal(x) + ", " + decimal(y) + "]").join(", ");
  return scene.text.slice(0, from) + "outline: [" + points + "]" + kept + scene.text.slice(end);
}
