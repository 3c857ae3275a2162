// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A scene in small, from an answer of the core: blocks as they are tilted. */

import { isDrawable, shapesOf } from "../drawing/shapes.js";
import { SceneText } from "../scene/scene_text.js";
import { meshOf } from "../solid/solid_mesh.js";
import { solidSketch } from "../solid/solid_sketch.js";
import { element, svgElement } from "../panels/element.js";
import { COLOUR_CLASS, sentence } from "../panels/words.js";
import { fosText } from "../panels/certain.js";
import { governingFactor } from "../scene/solution.js";
import { say } from "../words/language.js";

const MARGIN = 0.06;
const DOTS = 200; // across it

/** @param {any} solution with its kind @param {{text: string, files: Record<string, string|Uint8Array>}} scene @returns {Element} */
export function thumbnail(solution, { text, files }) {
  if (solution.kind === "solid") return solidSketch(solution, meshOf(solution, new SceneText(text), files));
  const { outlines, cases } = solution;
  if (outlines === undefined || !isDrawable(outlines)) return element("div", { class: "thumb" });
  const tilt = (cases[0].tilt_angle_deg?.value ?? 0) * (cases[0].towards === "right" ? -1 : 1);
  return svgElement("svg", { class: "thumb", viewBox: boxOf(outlines.box_m, (tilt * Math.PI) / 180), "aria-hidden": "true" },
    svgElement("g", { transform: "scale(1 -1) rotate(" + tilt + ")" },
      shapesOf(solution, cases[0], dotOf(outlines.box_m)).map(({ name, path, style }) => svgElement("path", { class: "shape " + name, d: path, style }))));
}

const dotOf = ([x0, y0, x1, y1]) => Math.hypot(x1 - x0, y1 - y0) / DOTS;

/** Of a box that is turned, on the screen, whose y goes down. */
function boxOf([x0, y0, x1, y1], angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const corners = [[x0, y0], [x1, y0], [x0, y1], [x1, y1]].map(([x, y]) => [c * x - s * y, -s * x - c * y]);
  const [xs, ys] = [0, 1].map((axis) => corners.map((corner) => corner[axis]));
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [width, height] = [Math.max(...xs) - left, Math.max(...ys) - top];
  const margin = MARGIN * Math.max(width, height);
  return [left - margin, top - margin, width + 2 * margin, height + 2 * margin].join(" ");
}

/** What it does, in a word and a factor. @param {any} solution @returns {{words: string, kind: string}} */
export function shortVerdict(solution) {
  const kase = solution.cases[0];
  const mechanism = kase?.mechanism ?? kase?.verdict ?? kase?.first?.mechanism;
  if (mechanism === undefined) return { words: "", kind: "undecided" };
  const fos = governingFactor(kase);
  return { words: sentence(say(mechanism)) + (fos?.value !== undefined ? ", " + say("FoS") + " " + fosText(fos) : ""), kind: COLOUR_CLASS[mechanism] ?? "undecided" };
}
