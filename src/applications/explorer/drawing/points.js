// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The points of a list of the scene, thousands of them in each frame of a drag: their values and no more. */

import { decimalValue } from "../scene/decimal.js";
import { formulaValue } from "../scene/formula.js";

/**
 * @param {import("./handle.js").Context} context @param {(string|number)[]} path
 * @returns {(import("./handle.js").Point|null)[]} null: a point whose numbers cannot be told here
 */
export function pointsOf(context, path) {
  const plain = context.scene.decimals(path);
  if (plain !== null) return plain;
  const value = (text) => (text === null ? null : (decimalValue(text) ?? formulaValue(text, context.parameters)));
  return context.scene.points(path).map(([across, up]) => {
    const [x, y] = [value(across), value(up)];
    return x === null || y === null ? null : { x, y };
  });
}
