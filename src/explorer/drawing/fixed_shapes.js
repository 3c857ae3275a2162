// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What of a scene has a shape that cannot be dragged, and why: words for below the drawing. */

/** @param {import("../scene/scene_text.js").SceneText} scene @returns {string[]} */
export function fixedShapes(scene) {
  if (scene.unread !== null) return [scene.unread];
  const said = [];
  const file = (path, what) => {
    const name = scene.scalar(path);
    if (name !== null) said.push(what + " stands in the file " + name + "; change it there and open it again");
  };
  file(["block", "outline"], "The outline");
  file(["base", "profile"], "The profile");
  file(["drawing", "file"], "The drawing");
  file(["drawing"], "The drawing");
  if (scene.keys(["block", "outline"])?.includes("mesh")) said.push("The outline is a section of a mesh");
  const rule = scene.keys(["base", "profile"]);
  if (rule !== null) said.push("The profile is made by the rule " + rule[0] + "; its numbers stand in the text");
  if (scene.scalar(["base", "place"]) === "rest" || scene.keys(["joint"]) !== null || scene.keys(["contact"]) !== null) {
    said.push("The block is drawn where it came to rest; its handles lie where the scene put it");
  }
  return said;
}
