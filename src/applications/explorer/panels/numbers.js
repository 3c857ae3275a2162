// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The numbers of a scene that can be swept, and the scene made ready for a sweep. */

import { isMap, isScalar, isSeq } from "yaml";
import { decimalValue } from "../scene/decimal.js";

/** A menu has no room for more. */
const LISTED_MAX = 120;
/** Numbers that say how many, or of which version: between two of them there is nothing. */
const WHOLE = new Set(["count", "topple", "facet", "seed"]);
export const TILT = "tilt.angle_deg";

/**
 * @typedef {object} SceneNumber
 * @property {string} key as `--set` and `sweep` name it
 * @property {(string|number)[]} path where it stands
 * @property {number|null} value null: the scene does not have it yet
 * @property {boolean} present
 */

/** @param {import("../scene/scene_text.js").SceneText} scene @returns {SceneNumber[]} the tilt first */
export function sceneNumbers(scene) {
  /** @type {SceneNumber[]} */
  const found = [tiltOf(scene)];
  walk(scene.root, [], found);
  return found;
}

function tiltOf(scene) {
  const text = scene.scalar(["tilt", "angle_deg"]);
  return { key: TILT, path: ["tilt", "angle_deg"], value: text === null ? null : decimalValue(text), present: text !== null };
}

function walk(node, path, found) {
  if (found.length >= LISTED_MAX) return;
  if (isMap(node)) {
    for (const { key, value } of node.items) {
      if (isScalar(key) && !WHOLE.has(String(key.value))) walk(value, [...path, String(key.value)], found);
    }
  } else if (isSeq(node)) {
    node.items.forEach((item, index) => walk(item, [...path, index], found));
  } else if (isScalar(node) && typeof node.value === "string") {
    const value = decimalValue(node.value);
    const key = keyOf(path);
    if (value !== null && key !== TILT) found.push({ key, path, value, present: true });
  }
}

/** Parameters go by their names, entries of lists count from 1. */
function keyOf(path) {
  if (path.length === 2 && path[0] === "parameters") return String(path[1]);
  return path.map((part) => (typeof part === "number" ? part + 1 : part)).join(".");
}

/** A range of a number that is worth a look. @param {SceneNumber} number @param {number} width of the block, in scene lengths */
export function usualRange(number, width) {
  if (number.key === TILT) return { from: 0, to: 60 };
  if (/(^|\.)(friction_angle_deg|basic_angle_deg|residual_angle_deg|angle_deg)$/.test(number.key)) {
    return { from: 5, to: number.value !== null && number.value > 50 ? 80 : 60 };
  }
  if (number.value === null || number.value === 0) return { from: 0, to: rounded(/beyond|outline|profile|shift/.test(number.key) ? width : 1) };
  const [one, other] = [number.value * 0.25, number.value * 2].map(rounded);
  return { from: Math.min(one, other), to: Math.max(one, other) };
}

function rounded(value) {
  return Number(value.toPrecision(2));
}

/**
 * The scene with one direction of tilt, or as many as it has, and with a tilt that can be swept.
 * @param {import("../scene/scene_text.js").SceneText} scene
 * @param {string|null} towards null: as it is
 * @returns {string}
 */
export function sweepable(scene, towards) {
  if (scene.root === null) return scene.text;
  if (!scene.has(["tilt"])) {
    return scene.withNumbers([{ path: ["tilt"], text: "{towards: " + (towards ?? "both") + ", angle_deg: 0}" }]);
  }
  const edits = [];
  if (scene.scalar(["tilt", "angle_deg"]) === null) edits.push({ path: ["tilt", "angle_deg"], text: "0" });
  if (towards !== null && scene.scalar(["tilt", "towards"]) !== null) edits.push({ path: ["tilt", "towards"], text: towards });
  const text = edits.length === 0 ? scene.text : scene.withNumbers(edits);
  if (towards === null || scene.scalar(["tilt", "towards"]) !== null) return text;
  return new scene.constructor(text).withNumbers([{ path: ["tilt", "towards"], text: towards }]);
}
