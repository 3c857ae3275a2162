// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The tilts from level to upright as a bar: where the block is certain to stand, where history decides, where it is
 * certain to move; and the scene's tilt as a mark on it. Colour, hatching and a number at each border say the same.
 */

import { svgElement } from "./element.js";
import { degreesText } from "./certain.js";
import { numeral, say } from "../words/language.js";

const WIDTH = 360;
const TOP = 18;
const HEIGHT = 16;

/** @param {number} angle in degrees */
const along = (angle) => (Math.max(0, Math.min(90, angle)) / 90) * WIDTH;

/**
 * @typedef {{from: number, to: number, kind: "stands"|"may-move"|"moves"}} Stretch of tilts, degrees
 * @param {any} theCase
 * @returns {Stretch[]} from level up, without gaps; none where the onset is not known
 */
export function stretches(theCase) {
  const { onset, limit } = theCase;
  if (onset === undefined || limit === undefined || onset.kind === "undecided") return [];
  const lets = limitAngle(limit);
  if (lets === null) return [];
  const found = [];
  let at = 0;
  const put = (to, kind) => {
    if (to > at) found.push({ from: at, to, kind });
    at = Math.max(at, to);
  };
  // what moves below the limit may do so: forces that would hold it exist
  for (const { from_deg: from, to_deg: to } of onset.windows ?? []) {
    const begins = from === null ? 0 : from.value;
    put(Math.min(begins, lets), "stands");
    put(Math.min(to === null ? 90 : to.value, lets), "may-move");
  }
  put(lets, "stands");
  put(90, "moves");
  return found;
}

/** Beyond which tilt no forces hold it: 90 where they always do, null where that is not decided. */
function limitAngle(limit) {
  if (limit.critical_angle_deg !== null) return Math.max(0, Math.min(90, limit.critical_angle_deg.value));
  if (limit.mechanism === "holds nowhere") return 0;
  return limit.mechanism === "undecided" ? null : 90;
}

/** @param {any} theCase @returns {SVGElement|null} */
export function windowGauge(theCase) {
  const parts = stretches(theCase);
  if (parts.length === 0) return null;
  const tilt = theCase.tilt_angle_deg ?? null;
  const words = { stands: "certain to stand", "may-move": "depends on history", moves: "certain to move" };
  const told = parts.map((part) => say("%s from %s to %s", say(words[part.kind]), ...[part.from, part.to].map((each) => numeral(each.toFixed(1)) + "°")));
  return svgElement(
    "svg",
    { class: "gauge", viewBox: "-14 0 " + (WIDTH + 28) + " 52", role: "img", "aria-label": told.join("; ") },
    hatching(),
    parts.map((part) =>
      svgElement("rect", {
        class: part.kind, x: along(part.from), y: TOP, width: along(part.to) - along(part.from), height: HEIGHT,
      }),
    ),
    [0, 30, 60, 90].map((angle) => [
      svgElement("line", { class: "tick", x1: along(angle), x2: along(angle), y1: TOP + HEIGHT, y2: TOP + HEIGHT + 4 }),
      svgElement("text", { x: along(angle), y: TOP + HEIGHT + 16, "text-anchor": "middle" }, angle + "°"),
    ]),
    tilt === null
      ? null
      : svgElement(
          "g",
          { class: "present", transform: "translate(" + along(tilt.value) + " 0)" },
          svgElement("path", { d: "M-5 6L5 6L0 14Z" }),
          svgElement("line", { x1: 0, x2: 0, y1: 12, y2: TOP + HEIGHT }),
          svgElement("title", {}, say("the scene's tilt") + ", " + degreesText(tilt)),
        ),
  );
}

function hatching() {
  return svgElement(
    "defs",
    {},
    svgElement(
      "pattern",
      { id: "history", width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
      svgElement("rect", { class: "may-move-ground", width: 6, height: 6 }),
      svgElement("rect", { class: "may-move-line", width: 2, height: 6 }),
    ),
  );
}
