// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A number of the scene as something that can be changed: the decimal that stands there, or the parameter that does
 * where it is one by name. A longer formula is read for its value alone, in doubles, so that its handle has a place.
 */

import { decimalValue } from "./decimal.js";
import { formulaValue } from "./formula.js";
import { say } from "../words/language.js";

const NAME = /^[A-Za-z_][A-Za-z_0-9]*$/;

/**
 * @typedef {object} Quantity
 * @property {(string|number)[]} path where its decimal stands
 * @property {number|null} value null: it cannot be told here
 * @property {boolean} present it stands in the scene
 * @property {string|null} fixed why it cannot be dragged; null: it can
 * @property {string|null} parameter the parameter that it is, by name
 */

/** @param {import("./scene_text.js").SceneText} scene @returns {Map<string, number>} what can be told of them */
export function parameterValues(scene) {
  const values = new Map();
  for (const name of scene.keys(["parameters"]) ?? []) {
    const value = formulaValue(scene.scalar(["parameters", name]) ?? "", values);
    if (value !== null) values.set(name, value);
  }
  return values;
}

/**
 * @param {import("./scene_text.js").SceneText} scene
 * @param {(string|number)[]} path
 * @param {Map<string, number>} parameters
 * @returns {Quantity}
 */
export function quantity(scene, path, parameters) {
  const text = scene.scalar(path);
  const found = { path, value: null, present: text !== null, fixed: null, parameter: null };
  if (text === null) return { ...found, fixed: scene.unread === null ? scene.whyNoNumber(path) : null };
  found.value = decimalValue(text);
  if (found.value !== null) return found;
  found.value = formulaValue(text, parameters);
  const own = NAME.test(text.trim()) ? scene.scalar(["parameters", text.trim()]) : null;
  if (own !== null && decimalValue(own) !== null) {
    found.parameter = text.trim();
    found.path = ["parameters", found.parameter];
  } else {
    found.fixed = say("is the formula %s; change it, or its parameters, in the text", text.trim());
  }
  return found;
}
