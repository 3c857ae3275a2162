// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

import { say } from "../words/language.js";

/**
 * What was clicked in a photograph as a scene: the text that `topple trace --outline` writes for the same points
 * (src/applications/trace), byte by byte, so that either can go on with the other's work.
 *
 * @typedef {{x: number, y: number}} Point in pixels from the upper left corner, y down
 * @typedef {object} Traced
 * @property {string} image its file's name @property {string|null} hash SHA-256 of the file; null: this browser tells none
 * @property {Point[]} outline @property {Point[]} scale two points @property {number} length between them @property {string} unit
 * @property {Point[]} plumb two points, or none @property {Point[]} between likewise
 * @property {string} friction @property {string} unitWeight texts; "" where not known
 */

const CLICK = Math.sqrt(1 / 12); // standard deviation of a place within a pixel
const MITRE_MAX = 1.5;
const SEEN = 20; // of the deviation a twentieth is seen
const BAND = 2;
const LEAST_MOVE = 0.0005;
export const CLICKS_MAX = 200;

/** As C prints it by %.Ng: without needless zeros. */
function general(value, digits) {
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  if (Number(exponent) >= -4 && Number(exponent) < digits) return Number(value).toFixed(Math.max(0, digits - 1 - Number(exponent))).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
  return mantissa.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "") + "e" + (exponent < 0 ? "-" : "+") + exponent.replace(/[-+]/, "").padStart(2, "0");
}

const area = (ring) => ring.reduce((sum, p, k) => sum + ring[(k + ring.length - 1) % ring.length].x * p.y - p.x * ring[(k + ring.length - 1) % ring.length].y, 0) / 2;

/** Scale, down and origin of the scene's coordinates. @param {Traced} traced @returns {(point: Point) => Point} */
export function placing({ outline, scale: [a, b], length, plumb }) {
  const perPixel = length / Math.hypot(b.x - a.x, b.y - a.y);
  const down = downOf(plumb);
  const at = ({ x, y }) => ({ x: perPixel * (x * down.y - y * down.x), y: -perPixel * (x * down.x + y * down.y) });
  const placed = outline.map(at);
  const origin = { x: Math.min(...placed.map(({ x }) => x)), y: Math.min(...placed.map(({ y }) => y)) };
  return (point) => ({ x: at(point).x - origin.x, y: at(point).y - origin.y });
}

function downOf(plumb) {
  if (plumb.length < 2) return { x: 0, y: 1 };
  const [p, q] = plumb;
  const long = Math.hypot(q.x - p.x, q.y - p.y) * (q.y >= p.y ? 1 : -1);
  return { x: (q.x - p.x) / long, y: (q.y - p.y) / long };
}

/** How a vertex moves where all edges move outwards by one: along the bisector, no farther than a mitre allows. */
function moveOf(ring, k) {
  const [p, q, r] = [-1, 0, 1].map((step) => ring[(k + step + ring.length) % ring.length]);
  const [a, b] = [Math.hypot(q.x - p.x, q.y - p.y), Math.hypot(r.x - q.x, r.y - q.y)];
  const [m, n] = [{ x: (q.y - p.y) / a, y: (p.x - q.x) / a }, { x: (r.y - q.y) / b, y: (q.x - r.x) / b }];
  const both = 1 + m.x * n.x + m.y * n.y;
  const move = { x: (m.x + n.x) / both, y: (m.y + n.y) / both };
  if (Math.hypot(move.x, move.y) <= MITRE_MAX) return move;
  const sum = Math.hypot(m.x + n.x, m.y + n.y);
  return sum > 0 ? { x: (MITRE_MAX * (m.x + n.x)) / sum, y: (MITRE_MAX * (m.y + n.y)) / sum } : { x: 0, y: 0 };
}

/** From a point to the line of the ring, pixels. */
function missed(ring, from) {
  return Math.min(...ring.map((p, k) => {
    const q = ring[(k + 1) % ring.length];
    const [x, y] = [q.x - p.x, q.y - p.y];
    const square = x * x + y * y;
    const share = Math.min(1, Math.max(0, square > 0 ? ((from.x - p.x) * x + (from.y - p.y) * y) / square : 0));
    return Math.hypot(p.x + share * x - from.x, p.y + share * y - from.y);
  }));
}

function nearest(ring, to) {
  const far = ring.map((p) => Math.hypot(p.x - to.x, p.y - to.y));
  return far.indexOf(Math.min(...far));
}

/** The vertices in which the contact ends, the left one first. @returns {number[]} none where none is given */
function ends(ring, { between }, at) {
  if (between.length < 2) return [];
  const [left, right] = at(between[0]).x <= at(between[1]).x ? between : [between[1], between[0]];
  const found = [nearest(ring, left), nearest(ring, right)];
  if (found[0] === found[1]) throw new RangeError(say("both ends of the contact are nearest to one point of the outline; take them farther apart"));
  return found;
}

/** @param {Traced} traced @returns {string} the scene */
export function traceScene(traced) {
  const { outline, scale, plumb, between } = traced;
  if (outline.length < 3 || outline.length > CLICKS_MAX || Math.abs(area(outline)) === 0) throw new RangeError(say("an outline has from 3 to %s points around an area", CLICKS_MAX));
  const ring = area(outline) < 0 ? [...outline].reverse() : outline;
  const at = placing(traced);
  const down = downOf(plumb);
  const deviation = (CLICK * traced.length) / Math.hypot(scale[1].x - scale[0].x, scale[1].y - scale[0].y);
  const decimals = Math.max(0, Math.min(12, Math.ceil(-Math.log10(deviation / SEEN))));
  const point = (k) => {
    const [place, move] = [at(ring[k]), moveOf(ring, k)];
    const one = (value, by) => value.toFixed(decimals) + (Math.abs(by) < LEAST_MOVE ? "" : " " + (by < 0 ? "-" : "+") + " " + Math.abs(by).toFixed(3) + "*outline_offset");
    return "  - [" + one(place.x, move.x * down.y - move.y * down.x) + ", " + one(place.y, -(move.x * down.x + move.y * down.y)) + "]\n";
  };
  const contact = ends(ring, traced, at);
  const farthest = Math.max(0, ...between.map((end) => missed(ring, end)));
  return headOf(traced, deviation, between.length === 2 && farthest > BAND * CLICK ? farthest : null) +
    "topple: 1\ntitle: " + JSON.stringify("Traced in " + traced.image) + "\nlength_unit: " + traced.unit +
    "\nframe: world\nparameters: {outline_offset: 0}\nblock:\n  outline:\n" + ring.map((_, k) => point(ring.length - 1 - k)).join("") +
    rockOf(traced) + "base:\n  mated: true               # the counterpart of its underside: NOT conservative if there are gaps\n" +
    (contact.length === 0
      ? "  # between: [[x, y], [x, y]] # missing: the contact goes on to where sides begin, steeper than 45°\n"
      : "  between:                  # where the contact begins and ends\n" + contact.map(point).join("")) +
    (traced.friction !== "" ? "friction_angle_deg: " + traced.friction + "\n"
      : "# friction_angle_deg: 30    # missing: sliding is not judged, and no design factor is met\n");
}

function rockOf({ unitWeight }) {
  return (unitWeight !== "" ? "  unit_weight_kn_m3: " + unitWeight + "\n" : "  # unit_weight_kn_m3: 26   # missing: forces and loads need it\n") +
    "  # thickness: 1            # 1 m where it is not given\n";
}

/** What it can be traced again by, and what its numbers mean. @param {number|null} farthest by which an end of the contact is missed */
function headOf({ image, hash, outline, scale, length, unit, plumb, between }, deviation, farthest) {
  const list = (points) => points.flatMap(({ x, y }) => [general(x, 10), general(y, 10)]).join(",");
  const said = general(deviation, 3);
  return "# Traced by topple trace in " + image + ", SHA-256\n# " + (hash ?? "not told by this browser") + "\n# --outline=" + list(outline) +
    "\n# --scale=" + list(scale) + "," + general(length, 10) + " --unit=" + unit + (plumb.length === 2 ? " --plumb=" + list(plumb) : "") +
    (between.length === 2 ? " --between=" + list(between) : "") + "\n# x runs to the right and y up, " +
    (plumb.length === 2 ? "along the plumb line of the picture" : "as the picture is held: no plumb line was given") +
    ".\n# outline_offset moves the outline outwards as a whole; the standard deviation with which\n# a click is exact to its pixel is " +
    said + " " + unit + ", so that a study that takes it for normal says\n#   vary: {outline_offset: {normal: {mean: 0, deviation: " + said +
    "}}}\n# That is no more than the precision in the picture: two hands that draw one block may\n# differ by much more.\n" +
    (farthest === null ? "" : "# Caution: the outline misses an end of the contact that was given by " + farthest.toFixed(1) + " pixels, more\n# than its band.\n");
}
