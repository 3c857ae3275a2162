// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What of a scene has a shape that cannot be dragged, and why: words for below the drawing. */

import { say } from "../words/language.js";

/** Whose points may stand in a CSV file instead of in the scene. */
export const SHAPES = [
  { path: ["block", "outline"], what: "The outline" },
  { path: ["base", "profile"], what: "The profile" },
];

/** @param {import("../scene/scene_text.js").SceneText} scene @returns {string[]} */
export function fixedShapes(scene) {
  if (scene.unread !== null) return [scene.unread];
  const drawing = scene.scalar(["drawing"]) ?? scene.scalar(["drawing", "file"]);
  const said = drawing === null ? [] : [say("Block and base stand in the file %s; change it there and open it again", drawing)];
  return said.concat(...SHAPES.map(({ path, what }) => shapeOf(scene, path, what)));
}

function shapeOf(scene, path, what) {
  const file = scene.scalar(path);
  if (file !== null) return [say("%s stands in the file %s; change it there and open it again", say(what), file)];
  const keys = scene.keys(path);
  if (keys === null) return [];
  if (keys.includes("mesh")) return [say("%s is a section of the mesh %s", say(what), scene.scalar([...path, "mesh"]))];
  return [say("%s is made by a rule (%s); its numbers stand in the text", say(what), keys[0])];
}
