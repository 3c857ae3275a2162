// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The block at its limit: the table tilted so far, the two forces of the base in their friction cones, the weight, and
 * the centre about which it begins to turn.
 */

import { resultPoint } from "../drawing/result_point.js";
import { svgElement } from "./element.js";

/** Of the diagonal of the block: the weight's arrow, and the room around the figure. */
const WEIGHT_LENGTH = 0.45;
const MARGIN = 0.12;
/** A centre of rotation farther off than so many diagonals is told in words alone. */
const FAR = 1.5;
/** SVG computes in single precision: sizes beyond are left to the table. */
const SIZES = { least: 1e-30, most: 1e30 };

/**
 * @param {any} theCase
 * @param {any} outlines
 * @param {import("./friction_cones.js").Cone[]} cones
 * @returns {SVGElement|null} null: too small or too large to be drawn
 */
export function forcesFigure(theCase, outlines, cones) {
  const { limit, block } = theCase;
  const [x0, y0, x1, y1] = outlines.box_m;
  const diagonal = Math.hypot(x1 - x0, y1 - y0);
  if (!(diagonal >= SIZES.least && diagonal <= SIZES.most)) return null;
  const scale = WEIGHT_LENGTH * diagonal;
  const tilt = (limit.critical_angle_deg.value * Math.PI) / 180;
  const sense = theCase.towards === "right" ? -1 : 1;
  const turned = turning(sense * tilt);
  const centroid = resultPoint(outlines, block.centroid_x_m, block.centroid_y_m);
  const down = { x: -sense * Math.sin(tilt) * scale, y: -Math.cos(tilt) * scale };
  const centre = nearCentre(limit, outlines, centroid, diagonal);
  const reach = [
    { x: x0, y: y0 }, { x: x1, y: y0 }, { x: x0, y: y1 }, { x: x1, y: y1 }, plus(centroid, down),
    ...cones.map((cone) => plus(cone, { x: cone.along * scale, y: cone.across * scale })),
    ...(centre === null ? [] : [centre]),
  ].map(turned);
  return svgElement(
    "svg",
    { class: "forces", viewBox: viewBox(reach, MARGIN * diagonal), role: "img", "aria-label": "Forces at the limit" },
    arrowHeads(),
    svgElement(
      "g",
      { transform: "scale(1 -1) rotate(" + (sense * limit.critical_angle_deg.value).toFixed(6) + ")", style: "--one:" + diagonal / 300 },
      svgElement("path", { class: "base", d: outlines.base ?? "" }),
      svgElement("path", { class: "block", d: outlines.block }),
      svgElement("path", { class: "contact", d: outlines.contact ?? "" }),
      cones.map((cone) => coneParts(cone, limit.friction_angle_deg.value, scale)),
      arrow("weight", centroid, plus(centroid, down)),
      svgElement("circle", { class: "centroid", cx: centroid.x, cy: centroid.y, r: diagonal / 90 }),
      centre === null ? null : centreMark(centre, diagonal / 50),
    ),
  );
}

function coneParts(cone, friction, scale) {
  const tip = plus(cone, { x: cone.along * scale, y: cone.across * scale });
  if (cone.normal === null) return [arrow("reaction", cone, tip)];
  const length = Math.hypot(cone.along, cone.across) * scale * 1.1;
  const edges = [friction, -friction].map((angle) => plus(cone, times(turning((angle * Math.PI) / 180)(cone.normal), length)));
  const data = "M" + [edges[0], cone, edges[1]].map((point) => point.x + " " + point.y).join("L");
  return [svgElement("path", { class: "cone", d: data + "Z" }), arrow("reaction", cone, tip)];
}

function arrow(kind, from, to) {
  return svgElement("line", { class: "arrow " + kind, x1: from.x, y1: from.y, x2: to.x, y2: to.y, "marker-end": "url(#head-" + kind + ")" });
}

function centreMark(centre, size) {
  const { x, y } = centre;
  const data = "M" + (x - size) + " " + y + "H" + (x + size) + "M" + x + " " + (y - size) + "V" + (y + size);
  return svgElement("g", { class: "centre" }, svgElement("circle", { cx: x, cy: y, r: size * 0.7 }), svgElement("path", { d: data }));
}

function nearCentre(limit, outlines, centroid, diagonal) {
  if (!limit.centre_x_m || !limit.centre_y_m) return null;
  const centre = resultPoint(outlines, limit.centre_x_m, limit.centre_y_m);
  return Math.hypot(centre.x - centroid.x, centre.y - centroid.y) <= FAR * diagonal ? centre : null;
}

function arrowHeads() {
  return svgElement(
    "defs",
    {},
    ["weight", "reaction"].map((kind) =>
      svgElement(
        "marker",
        { id: "head-" + kind, class: "head " + kind, viewBox: "0 0 10 10", refX: 9, refY: 5, markerWidth: 6, markerHeight: 6, orient: "auto" },
        svgElement("path", { d: "M0 0L10 5L0 10Z" }),
      ),
    ),
  );
}

/** Of the screen, whose y goes down. */
function viewBox(points, margin) {
  const xs = points.map((point) => point.x);
  const ys = points.map((point) => -point.y);
  const left = Math.min(...xs) - margin;
  const top = Math.min(...ys) - margin;
  return [left, top, Math.max(...xs) + margin - left, Math.max(...ys) + margin - top].join(" ");
}

function turning(angle) {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  return ({ x, y }) => ({ x: cosine * x - sine * y, y: sine * x + cosine * y });
}

const plus = (one, other) => ({ x: one.x + other.x, y: one.y + other.y });
const times = (vector, factor) => ({ x: vector.x * factor, y: vector.y * factor });
