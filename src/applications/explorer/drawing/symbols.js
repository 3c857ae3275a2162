// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * What is drawn over the block in dots of the screen: weight, pivots by number, reactions with their friction cones at
 * the limit, the centre of rotation, loads. All numbers are those of the answer.
 */

import { contactFaces, normalAt } from "./contact_normals.js";
import { resultPoint } from "./result_point.js";
import { numeral, say } from "../words/language.js";

const PIVOTS_MAX = 60;
const FORCE_DOTS = 120; // of the block's weight
const NAME_DOTS = 20; // that two numbers need between them
const GOVERNING_DOTS = 13;
const HEAD = 9;
const COMB = 6; // gaps between the arrows of a pressure
const COMB_DOTS = 30;
const PULL_DOTS = 58;

/**
 * @typedef {{kind: string, d?: string, x?: number, y?: number, text?: string, title?: string}} Symbol
 * @param {object} answer of one block @param {object} kase of it
 * @param {import("./view.js").View} view @param {{x: number, y: number}} origin metres
 * @returns {Symbol[]} from the back to the front
 */
export function symbolsOf({ outlines }, kase, view, origin) {
  const shift = { x: outlines.origin_x_m - origin.x, y: outlines.origin_y_m - origin.y };
  const on = (x, y) => {
    const at = resultPoint(outlines, x, y);
    return view.toScreen(at.x + shift.x, at.y + shift.y);
  };
  return [
    ...reactions(kase, outlines, view, on),
    ...loads(outlines, view, shift),
    ...weight(kase, on),
    ...centre(kase, on),
    ...pivots(kase, on),
  ];
}

/** @returns {string} a line from one dot to another with a head at its end */
export function arrow(from, to) {
  const length = Math.hypot(to.x - from.x, to.y - from.y) || 1;
  const [ux, uy] = [(to.x - from.x) / length, (to.y - from.y) / length];
  const barb = (side) => "M" + to.x + " " + to.y + "L" + (to.x - HEAD * (ux - 0.45 * side * uy)) + " " + (to.y - HEAD * (uy + 0.45 * side * ux));
  return "M" + from.x + " " + from.y + "L" + to.x + " " + to.y + barb(1) + barb(-1);
}

function weight(kase, on) {
  const { block } = kase;
  const from = on(block.centroid_x_m, block.centroid_y_m);
  const title = block.weight_n ? say("weight") + " " + numeral(block.weight_n.value.toPrecision(4)) + " N" : say("weight");
  return [
    { kind: "weight", d: arrow(from, { x: from.x, y: from.y + FORCE_DOTS }), title },
    { kind: "centroid", d: disc(from, 4.5), title: say("centroid") },
  ];
}

/** Those that matter most are named first; a number that another one would lie on is left out. */
function pivots(kase, on) {
  const governing = kase.toppling?.pivot;
  const rank = (pivot) => (pivot.index === governing ? 0 : pivot.admissible ? 1 : 2);
  const named = [];
  const drawn = [...(kase.pivots ?? [])].sort((one, other) => rank(one) - rank(other)).slice(0, PIVOTS_MAX).map((pivot) => {
    const at = on(pivot.x_m, pivot.y_m);
    const kind = ["pivot governing", "pivot admissible", "pivot"][rank(pivot)];
    const angle = pivot.critical_angle_deg?.value;
    const name = say("pivot %s", pivot.index + 1);
    const title = angle === undefined ? name : say("%s: passes the weight at %s", name, numeral(angle.toFixed(2)) + "°");
    const free = named.every((other) => Math.hypot(other.x - at.x, other.y - at.y) > NAME_DOTS);
    if (free) named.push(at);
    const governs = rank(pivot) === 0;
    // its handle, where it is a vertex, lies within the ring and hides nothing of it
    const d = governs ? disc(at, GOVERNING_DOTS) : disc(at, 4);
    return { kind, d, x: at.x, y: at.y + (governs ? GOVERNING_DOTS + 15 : 17), text: free ? String(pivot.index + 1) : "", title };
  });
  return drawn.reverse();
}

function centre(kase, on) {
  const { limit } = kase;
  if (limit?.centre_x_m === undefined || limit.centre_x_m === null) return [];
  const at = on(limit.centre_x_m, limit.centre_y_m);
  const cross = "M" + (at.x - 7) + " " + at.y + "h14M" + at.x + " " + (at.y - 7) + "v14";
  return [{ kind: "centre", d: disc(at, 7) + cross, title: say("centre of rotation at the limit: %s", say(limit.mechanism)) }];
}

function reactions(kase, outlines, view, on) {
  const found = kase.limit?.reactions ?? [];
  if (found.length === 0) return [];
  const faces = contactFaces(outlines.contact);
  const cone = (kase.limit.friction_angle_deg.value * Math.PI) / 180;
  return found.flatMap((one) => {
    const share = [one.share_x.value, one.share_y.value];
    const at = on(one.x_m, one.y_m);
    const size = Math.hypot(...share);
    const along = view.direction(...share);
    const long = FORCE_DOTS * size;
    const point = resultPoint(outlines, one.x_m, one.y_m);
    const normal = normalAt(faces, [point.x, point.y], share, 2 / view.dotsPerMetre);
    const force = { kind: "reaction", d: arrow({ x: at.x - long * along.x, y: at.y - long * along.y }, at),
      title: say("reaction at the limit: %s % of the weight", numeral((100 * size).toFixed(1))) };
    if (normal === null) return [force];
    return [{ kind: "cone", d: wedge(at, view, normal, cone, Math.max(long, 30)), title: say("friction cone") }, force];
  });
}

/** The cone of forces that the base can put on the block, drawn where these forces come from. */
function wedge(at, view, [nx, ny], half, long) {
  const side = (angle) => {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const along = view.direction(nx * c - ny * s, nx * s + ny * c);
    return (at.x - long * along.x) + " " + (at.y - long * along.y);
  };
  return "M" + at.x + " " + at.y + "L" + side(half) + "L" + side(-half) + "Z";
}

/** A pull begins at its point, a force from outside ends there. */
export function loads(outlines, view, shift) {
  const pull = (from, to, title) => (own, i) => {
    const at = view.toScreen(own.x_m + shift.x, own.y_m + shift.y);
    const angle = (own.direction_deg * Math.PI) / 180;
    const along = view.direction(Math.cos(angle), Math.sin(angle));
    const on = (dots) => ({ x: at.x + dots * along.x, y: at.y + dots * along.y });
    return { kind: "anchor", d: arrow(on(from), on(to)), title: say(title, i + 1) };
  };
  const anchors = [...(outlines.anchors ?? []).map(pull(0, PULL_DOTS, "anchor %s")), ...(outlines.forces ?? []).map(pull(-PULL_DOTS, 0, "force %s"))];
  const spread = (list, kind) => (list ?? []).map((one) => ({ kind, d: comb(one, view, shift, kind), title: say(kind) }));
  return [...anchors, ...spread(outlines.pressures, "pressure"), ...spread(outlines.surcharges, "surcharge")];
}

/** Arrows along a line, their heads on it: a pressure comes from the right of the line, a surcharge from above. */
function comb(one, view, shift, kind) {
  const [from, to] = [view.toScreen(one.x0_m + shift.x, one.y0_m + shift.y), view.toScreen(one.x1_m + shift.x, one.y1_m + shift.y)];
  const back = kind === "surcharge" ? { x: 0, y: -1 } : view.direction(one.y1_m - one.y0_m, one.x0_m - one.x1_m);
  const strongest = Math.max(Math.abs(one.first_kpa), Math.abs(one.last_kpa)) || 1;
  let path = "";
  for (let i = 0; i <= COMB; i++) {
    const share = i / COMB;
    const long = (COMB_DOTS * (one.first_kpa * (1 - share) + one.last_kpa * share)) / strongest;
    if (Math.abs(long) < 3) continue;
    const at = { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
    path += arrow({ x: at.x + long * back.x, y: at.y + long * back.y }, at);
  }
  return path || "M0 0";
}

function disc({ x, y }, radius) {
  return "M" + (x - radius) + " " + y + "a" + radius + " " + radius + " 0 1 0 " + 2 * radius + " 0a" + radius + " " + radius + " 0 1 0 " + -2 * radius + " 0Z";
}
