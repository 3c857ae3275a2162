// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The surfaces of a solid and of its ground as the core has them, repaired and thinned, out of the model of glTF that it writes
 * (Khronos Group, glTF 2.0 Specification, 2021): one buffer, a mesh a node, points of three floats, corners of 32 bits.
 */

import { inverse, turned } from "./turning.js";

const HEAD = 20; // bytes of the file before its JSON
const CHUNK = 8; // before the buffer

/** What the file is called where the core runs. */
export const MODEL = "solid-model.glb";

/** Whether the mesh in the scene's file is not all that is to be seen. @param {import("../scene/scene_text.js").SceneText} scene */
export function needsModel(scene) {
  return ["repair", "thin"].some((key) => scene.scalar(["solid", key]) !== null || scene.keys(["solid", key]) !== null) || scene.scalar(["solid", "base", "file"]) !== null;
}

/**
 * @param {Uint8Array} bytes @param {import("./turning.js").Turn} level that which makes the base level
 * @returns {{rock: Float64Array, ground: Float64Array}} nine numbers a triangle, metres from the centroid in the axes of the mesh; without a ground none
 */
export function surfacesOf(bytes, level) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const size = view.getUint32(12, true);
  const head = JSON.parse(new TextDecoder().decode(bytes.subarray(HEAD, HEAD + size)));
  const buffer = HEAD + size + CHUNK;
  const height = head.nodes[0].extras.centroid_height_m;
  const turn = inverse(level);
  const made = (name) => {
    const node = head.nodes.find((own) => own.mesh !== undefined && head.materials[head.meshes[own.mesh].primitives[0].material].name === name);
    if (node === undefined) return new Float64Array(0);
    const { attributes, indices } = head.meshes[node.mesh].primitives[0];
    const start = (accessor) => buffer + head.bufferViews[head.accessors[accessor].bufferView].byteOffset;
    const [points, corners] = [start(attributes.POSITION), start(indices)];
    const triangles = new Float64Array(3 * head.accessors[indices].count);
    for (let k = 0; k < triangles.length; k += 3) {
      const at = points + 12 * view.getUint32(corners + (4 * k) / 3, true);
      const [east, up, south] = [0, 4, 8].map((byte) => view.getFloat32(at + byte, true));
      triangles.set(turned(turn, [east, -south, up - height]), k);
    }
    return triangles;
  };
  return { rock: made("rock"), ground: made("ground") };
}
