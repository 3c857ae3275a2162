// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Items of a list of the scene's text come and go, as vertices do; what stands around them, comments and layout, stays. */

import { isSeq } from "yaml";
import { say } from "../words/language.js";

/**
 * @param {import("./scene_text.js").SceneText} scene @param {(string|number)[]} path of a list @param {number} after which of its
 *   items @param {string} item @returns {string} the text with it
 */
export function withItem(scene, path, after, item) {
  const list = listAt(scene, path);
  const before = list.items[after];
  const end = before.range[1];
  if (list.flow) return scene.text.slice(0, end) + ", " + item + scene.text.slice(end);
  const { from, to } = linesOf(scene.text, list, after);
  const dash = scene.text.slice(from, scene.text.indexOf("-", from));
  const newLine = scene.text.includes("\r\n") ? "\r\n" : "\n";
  const closed = scene.text[to - 1] === "\n";
  return scene.text.slice(0, to) + (closed ? "" : newLine) + dash + "- " + item + (closed ? newLine : "") + scene.text.slice(to);
}

/** @param {import("./scene_text.js").SceneText} scene @param {(string|number)[]} path @param {number} index @returns {string} the text without it */
export function withoutItem(scene, path, index) {
  const list = listAt(scene, path);
  const { text } = scene;
  if (!list.flow) {
    const { from, to } = linesOf(text, list, index);
    return text.slice(0, from) + text.slice(to);
  }
  const [before, item, next] = [-1, 0, 1].map((step) => list.items[index + step]);
  if (before !== undefined) return text.slice(0, before.range[1]) + text.slice(item.range[1]);
  return text.slice(0, item.range[0]) + text.slice(next === undefined ? item.range[1] : next.range[0]);
}

function listAt(scene, path) {
  const list = scene.node(path);
  if (!isSeq(list)) throw new RangeError(say("%s is no list in the text", path.join(".")));
  return list;
}

/** The lines of an item behind a dash: from where its line begins to where that of the next one does, or the last of its own ends. */
function linesOf(text, list, index) {
  const begin = (at) => text.lastIndexOf("\n", text.lastIndexOf("-", list.items[at].range[0])) + 1;
  if (index + 1 < list.items.length) return { from: begin(index), to: begin(index + 1) };
  const end = text.indexOf("\n", list.items[index].range[1] - 1);
  return { from: begin(index), to: end < 0 ? text.length : end + 1 };
}
