// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The triangles of a scene's solid, to be looked at: of the file that it names, or of the wedge between its planes. They are drawn
 * only where they are as many as the core counts, and a wedge only where it encloses the core's volume. What a plane cuts is not drawn.
 */

import { UNITS } from "../scene/length_units.js";
import { parameterValues, quantity } from "../scene/quantity.js";
import { trianglesOf, volumeOf } from "./mesh.js";

const AGREES = 1e-6; // of the volume
const FACES = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];

/**
 * @typedef {object} SolidMesh
 * @property {Float64Array} near triangles from the centroid, in lengths of the mesh
 * @property {number} unit metres in such a length @property {number[]} centroid @property {number} reach of the farthest corner
 */

/** @param {any} solution of a solid @param {import("../scene/scene_text.js").SceneText} scene @param {Record<string, string|Uint8Array>} files @returns {SolidMesh|null} */
export function meshOf(solution, scene, files) {
  if (solution.below !== undefined) return null; // of what a plane cuts off the core tells no unit
  const content = files[scene.scalar(["solid", "file"]) ?? ""];
  const triangles = content === undefined ? wedgeOf(scene, solution.volume_m3.value) : trianglesOf(content);
  if (triangles === null || triangles.length !== 9 * solution.triangles) return null;
  // metres in a length of the mesh, by the volume that the core tells
  const unit = Math.cbrt(solution.volume_m3.value / volumeOf(triangles));
  const centroid = solution.centroid_m.map(({ value }) => value / unit);
  const near = triangles.map((value, k) => value - centroid[k % 3]);
  let reach = 0;
  for (let k = 0; k < near.length; k += 3) reach = Math.max(reach, Math.hypot(near[k], near[k + 1], near[k + 2]));
  return { near, unit, centroid, reach };
}

/**
 * Its corners are the toe, which is the origin, the other end of the line of both joints, and where either joint meets face and
 * ground above. With a tension crack it has others, and is not drawn.
 * @returns {Float64Array|null}
 */
export function wedgeOf(scene, volume) {
  const parameters = parameterValues(scene);
  const number = (...path) => quantity(scene, ["solid", "wedge", ...path], parameters).value;
  const [a, b, face, upper] = ["a", "b", "face", "upper"].map((name) => normalOf(number(name, "dip_deg"), number(name, "dip_direction_deg")));
  const height = number("height");
  const [over, under] = UNITS[scene.scalar(["length_unit"])] ?? [];
  if ([a, b, face, upper, height, over].some((each) => each === null || each === undefined)) return null;
  const line = cross(a, b);
  const top = line.map((each) => (each * height) / line[2]);
  const side = (joint) => {
    const along = cross(joint, face);
    return along.map((each) => (each * dot(upper, top)) / dot(upper, along));
  };
  const corners = [[0, 0, 0], top, side(a), side(b)];
  const triangles = Float64Array.from(FACES.flatMap((corner) => corner.flatMap((at) => corners[at])));
  const own = volumeOf(triangles) * (Number(over) / Number(under)) ** 3;
  return Math.abs(own - volume) <= AGREES * volume ? triangles : null;
}

/** Upwards, of a plane that dips towards an azimuth. @returns {number[]|null} */
function normalOf(dip, azimuth) {
  if (dip === null || azimuth === null) return null;
  const [d, a] = [(dip * Math.PI) / 180, (azimuth * Math.PI) / 180];
  return [Math.sin(d) * Math.sin(a), Math.sin(d) * Math.cos(a), Math.cos(d)];
}

function cross([x, y, z], [u, v, w]) {
  return [y * w - z * v, z * u - x * w, x * v - y * u];
}

function dot(one, other) {
  return one.reduce((sum, each, k) => sum + each * other[k], 0);
}
