// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A solid in small, as lines of SVG: its triangles from the back to the front, each in the light that it has. */

import { element, svgElement } from "../panels/element.js";
import { FIRST, after, seenFrom, tilted, turned } from "./turning.js";

const MOST = 20_000; // triangles; more are not drawn in small
const MARGIN = 1.08;
const LIGHT = [0.32, 0.5, 0.8];

/** @param {any} solution of a solid @param {import("./solid_mesh.js").SolidMesh|null} mesh @returns {Element} empty where there is none */
export function solidSketch(solution, mesh) {
  if (mesh === null || mesh.near.length + mesh.ground.length > 9 * MOST) return element("div", { class: "thumb" });
  const turn = after(seenFrom(FIRST.around, FIRST.height), after(tilted(solution.tilt_angle_deg ?? 0, solution.tilt_azimuth_deg ?? 0), mesh.level));
  const size = MARGIN * mesh.reach;
  const faces = [...facesOf(mesh.near, turn, "rock"), ...facesOf(mesh.ground, turn, "ground")].sort((one, other) => one.depth - other.depth);
  return svgElement("svg", { class: "thumb solid-sketch", viewBox: [-size, -size, 2 * size, 2 * size].join(" "), "aria-hidden": "true" },
    faces.map(({ d, light, name }) => svgElement("path", { class: name, d, style: "--light:" + light.toFixed(2) })));
}

function facesOf(triangles, turn, name) {
  const faces = [];
  for (let k = 0; k < triangles.length; k += 9) {
    const [p, q, r] = [0, 3, 6].map((at) => turned(turn, triangles.slice(k + at, k + at + 3)));
    const [u, v] = [q, r].map((end) => end.map((each, axis) => each - p[axis]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const long = Math.hypot(...normal) || 1;
    const light = Math.abs(normal.reduce((sum, each, axis) => sum + (each / long) * LIGHT[axis], 0));
    faces.push({ name, depth: p[2] + q[2] + r[2], light: 0.35 + 0.65 * light, d: "M" + [p, q, r].map(([x, y]) => x + " " + -y).join("L") + "Z" });
  }
  return faces;
}
