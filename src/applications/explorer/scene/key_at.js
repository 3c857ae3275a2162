// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

import { isMap, isScalar, isSeq } from "yaml";

/**
 * Which key of a scene stands at a place of its text, by the path that `topple explain` knows it by: loads.anchors[].at. On a
 * value it is the key of that value.
 * @param {import("./scene_text.js").SceneText} scene @param {number} offset
 * @returns {{path: string, from: number, to: number}|null} from, to: where the key's word stands
 */
export function keyAt(scene, offset) {
  let found = null;
  let path = "";
  let node = scene.root;
  while (node !== null && node !== undefined) {
    if (isMap(node)) {
      const pair = node.items.find(({ key, value }) => isScalar(key) && key.range[0] <= offset && offset <= (value?.range?.[1] ?? key.range[1]));
      if (pair === undefined) return found;
      path += (path === "" ? "" : ".") + pair.key.value;
      found = { path, from: pair.key.range[0], to: pair.key.range[1] };
      if (offset <= pair.key.range[1]) return found;
      node = pair.value;
    } else if (isSeq(node)) {
      node = node.items.find((item) => item?.range && item.range[0] <= offset && offset <= item.range[1]);
      path += "[]";
    } else {
      return found;
    }
  }
  return found;
}
