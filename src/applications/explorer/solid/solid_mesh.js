// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The triangles of a scene's solid, to be looked at: of the file that it names, what a plane leaves of it, or the wedge between its
 * planes. They are drawn only where they are as many as the core counts and enclose the core's volume.
 */

import { cutMesh, lowestOf } from "./cut_mesh.js";
import { UNITS } from "../scene/length_units.js";
import { parameterValues, quantity } from "../scene/quantity.js";
import { trianglesOf, volumeOf } from "./mesh.js";
import { surfacesOf } from "./model.js";
import { after, inverse, tilted, upright } from "./turning.js";

const AGREES = 1e-6; // of the volume
const BESIDE = 1.6; // of the rock's reach: what is drawn of a larger ground, from its centroid
const FACES = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];

/**
 * @typedef {object} SolidMesh
 * @property {Float64Array} near triangles from the centroid, in lengths of the mesh
 * @property {number} unit metres in such a length @property {number[]} centroid @property {number} reach of the farthest corner
 * @property {import("./turning.js").Turn} level from axes of the mesh to its base, as if that were level
 * @property {number[][][]} section where a plane cuts it, pairs of points from the centroid; empty: none does
 * @property {Float64Array} ground triangles of what it rests on, likewise; empty: it has no mesh @property {boolean} goesOn there is more of it
 */

/** Whether its base dips: the mesh then has the vertical that it says, and lies on the slope. @param {import("../scene/scene_text.js").SceneText} scene */
export function isOnSlope(scene) {
  return scene.keys(["solid", "base"])?.includes("dip_deg") ?? false;
}

/**
 * From axes of the mesh to its base, as if that were level, which is leant over by the tilt: on a base that dips so that both turns
 * together bring the mesh upright, and leave it where it lies.
 * @param {any} solution of a solid @param {import("../scene/scene_text.js").SceneText} scene @returns {import("./turning.js").Turn}
 */
export function levelled(solution, scene) {
  const up = upright(solution.up);
  return isOnSlope(scene) ? after(inverse(tilted(solution.tilt_angle_deg, solution.tilt_azimuth_deg)), up) : up;
}

/** Across the base, of length 1. @param {import("./turning.js").Turn} level */
const normalOn = (level) => level.slice(6);

/** @param {any} solution of a solid @param {import("../scene/scene_text.js").SceneText} scene @param {Record<string, string|Uint8Array>} files @returns {SolidMesh|null} */
export function meshOf(solution, scene, files) {
  if (solution.model !== undefined) return ofModel(solution, scene);
  const content = files[scene.scalar(["solid", "file"]) ?? ""];
  const triangles = content === undefined ? wedgeOf(scene) : trianglesOf(content);
  const unit = content === undefined ? sceneUnit(scene) : meshUnit(scene);
  if (triangles === null || unit === null || triangles.length !== 9 * solution.triangles) return null;
  const centroid = solution.centroid_m.map(({ value }) => value / unit);
  const whole = triangles.map((value, k) => value - centroid[k % 3]);
  const level = levelled(solution, scene);
  const up = normalOn(level);
  const cut = solution.below === undefined ? null : lowestOf(whole, up) + (solution.below * sceneUnit(scene)) / unit;
  const { above: near, section } = cut === null ? { above: whole, section: [] } : cutMesh(whole, up, cut);
  const volume = volumeOf(near, cut === null ? [0, 0, 0] : up.map((each) => each * cut)) * unit ** 3;
  // cavities are not seen, but taken off by the core
  if (scene.count(["solid", "holes"]) === null && Math.abs(volume - solution.volume_m3.value) > AGREES * volume) return null;
  return { near, unit, level, centroid, reach: reachOf(near), section, ground: new Float64Array(0), goesOn: false };
}

/** As the core has it, with its ground. @returns {SolidMesh|null} */
function ofModel(solution, scene) {
  const unit = meshUnit(scene);
  if (unit === null) return null;
  const level = levelled(solution, scene);
  const surfaces = surfacesOf(solution.model, level);
  const [near, whole] = [surfaces.rock, surfaces.ground].map((triangles) => triangles.map((each) => each / unit));
  const reach = reachOf(near);
  const ground = groundNear(whole, level, BESIDE * reach);
  return { near, unit, level, centroid: solution.centroid_m.map(({ value }) => value / unit), reach, section: [], ground, goesOn: ground !== whole };
}

function reachOf(points) {
  let reach = 0;
  for (let k = 0; k < points.length; k += 3) reach = Math.max(reach, Math.hypot(points[k], points[k + 1], points[k + 2]));
  return reach;
}

/** What of a ground lies within a box about the centroid, along the map and up; all of it where that is not much more. */
function groundNear(whole, level, far) {
  const axes = [0, 1, 2].map((row) => level.slice(3 * row, 3 * row + 3));
  if (reachOf(whole) <= 2 * far) return whole;
  return axes.flatMap((axis) => [axis, axis.map((each) => -each)]).reduce((left, axis) => cutMesh(left, axis, -far).above, whole);
}

/** Metres in a length of the scene. @returns {number|null} */
function sceneUnit(scene) {
  return metresIn(scene.scalar(["length_unit"]));
}

/** Metres in a length of its mesh, which has a unit, or two points that lie so far apart. @returns {number|null} */
function meshUnit(scene) {
  const parameters = parameterValues(scene);
  const number = (...path) => quantity(scene, ["solid", "scale", ...path], parameters).value;
  const long = number("length");
  if (long === null) return metresIn(scene.scalar(["solid", "unit"])) ?? sceneUnit(scene);
  return (long * sceneUnit(scene)) / Math.hypot(...[0, 1, 2].map((axis) => number("to", axis) - number("from", axis)));
}

function metresIn(unit) {
  const [over, under] = UNITS[unit] ?? [];
  return over === undefined ? null : Number(over) / Number(under);
}

/**
 * Its corners are the toe, which is the origin, the other end of the line of both joints, and where either joint meets face and
 * ground above. With a tension crack it has others, so that volumes differ, and is not drawn.
 * @returns {Float64Array|null}
 */
export function wedgeOf(scene) {
  const parameters = parameterValues(scene);
  const number = (...path) => quantity(scene, ["solid", "wedge", ...path], parameters).value;
  const [a, b, face, upper] = ["a", "b", "face", "upper"].map((name) => normalOf(number(name, "dip_deg"), number(name, "dip_direction_deg")));
  const height = number("height");
  if ([a, b, face, upper, height].includes(null)) return null;
  const line = cross(a, b);
  const top = line.map((each) => (each * height) / line[2]);
  const side = (joint) => {
    const along = cross(joint, face);
    return along.map((each) => (each * dot(upper, top)) / dot(upper, along));
  };
  const corners = [[0, 0, 0], top, side(a), side(b)];
  return Float64Array.from(FACES.flatMap((corner) => corner.flatMap((at) => corners[at])));
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
