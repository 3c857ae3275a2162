// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Where the forces of the base lie in their friction cones. The core tells the forces; the normal of a cone is that of
 * the facet of contact which ends where the force acts, read from the outlines, in doubles: a drawing, not a result.
 */

import { resultPoint } from "../drawing/result_point.js";
import { segments } from "./path_data.js";

/** A force on the edge of its cone may seem to lie outside by so much, degrees: what doubles lose. */
const ON_EDGE = 1e-6;
/** An end is where a force acts if it is nearer than this share of the box. */
const NEAR = 1e-9;

/**
 * @typedef {object} Cone
 * @property {number} x where it acts, metres from the origin of the outlines
 * @property {number} y
 * @property {number} along the force as a share of the weight, along the mean plane
 * @property {number} across normal to it, upwards
 * @property {{x: number, y: number}|null} normal of the facet; null where that cannot be told
 * @property {number|null} angle from the normal, degrees
 */

/** @param {any} theCase @param {any} outlines of the solution @returns {Cone[]} */
export function cones(theCase, outlines) {
  const { limit } = theCase;
  const friction = limit?.friction_angle_deg?.value ?? 0;
  const facets = segments(outlines.contact ?? "");
  const [x0, y0, x1, y1] = outlines.box_m;
  const near = NEAR * Math.hypot(x1 - x0, y1 - y0);
  return (limit?.reactions ?? []).map((reaction) => {
    const force = {
      ...resultPoint(outlines, reaction.x_m, reaction.y_m),
      along: reaction.share_x.value, across: reaction.share_y.value,
    };
    return { ...force, ...nearestNormal(force, facets, near, friction) };
  });
}

function nearestNormal(force, facets, near, friction) {
  let best = { normal: null, angle: null };
  for (const { from, to } of facets) {
    const touches = [from, to].some((end) => Math.hypot(end.x - force.x, end.y - force.y) <= near);
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    if (!touches || length === 0) continue;
    const upward = Math.sign(to.x - from.x) || 1;
    const normal = { x: (-upward * (to.y - from.y)) / length, y: (upward * (to.x - from.x)) / length };
    const turn = normal.x * force.across - normal.y * force.along;
    const angle = (Math.atan2(turn, normal.x * force.along + normal.y * force.across) * 180) / Math.PI;
    if (Math.abs(angle) > friction + ON_EDGE) continue;
    if (best.angle === null || Math.abs(angle) > Math.abs(best.angle)) best = { normal, angle };
  }
  return best;
}
