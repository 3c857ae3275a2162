// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What a scene is of: one block in a section, many blocks, or a solid. The core is asked in another way for each. */

const MANY = ["blocks", "columns", "jointed_slope"];

/** @param {import("./scene_text.js").SceneText} scene @returns {"block"|"blocks"|"solid"} */
export function kindOf(scene) {
  const keys = scene.keys([]) ?? [...scene.text.matchAll(/^(\w+):/gm)].map(([, key]) => key);
  if (keys.includes("solid")) return "solid";
  const layers = scene.keys(["drawing"]) ?? [];
  return MANY.some((key) => keys.includes(key)) || layers.includes("blocks") ? "blocks" : "block";
}
