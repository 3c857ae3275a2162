// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * What can be dragged: a place on the drawing, and how a place of the hand becomes numbers of the scene.
 *
 * @typedef {{path: (string|number)[], text: string}} Edit
 * @typedef {{x: number, y: number}} Point
 * @typedef {object} Handle
 * @property {string} key stays the same while the scene changes, so that a drag and the keyboard's focus do
 * @property {string} label what it is, with its numbers and their unit
 * @property {"vertex"|"size"|"tilt"|"load"|"base"|"whole"} kind
 * @property {"xy"|"x"|"y"} moves which way the arrow keys move it
 * @property {string|null} fixed why it cannot be dragged; null: it can
 * @property {Point} [at] in the frame of the drawing, metres; or else
 * @property {Point} [dots] on the screen
 * @property {number} [reach] how far from its place the hand takes it, metres; else some dots
 * @property {(hand: Point, exponent: number) => Edit[]} drag to a place in the same measure as its own
 * @property {(dx: number, dy: number, exponent: number) => Edit[]} step by so many steps of 10^exponent
 */

import { parameterValues, quantity } from "../scene/quantity.js";
import { snap } from "../scene/decimal.js";
import { resultPoint } from "./result_point.js";
import { pathEnds } from "./thin_path.js";
import { Placement } from "./view.js";
import { between, numeral, say } from "../words/language.js";

/** What all handles are made from. */
export class Context {
  /**
   * @param {import("../scene/scene_text.js").SceneText} scene
   * @param {object} kase the case that is drawn
   * @param {object} outlines of the same answer
   * @param {{x: number, y: number}} origin of the drawing, where the outlines' origins lie, metres
   */
  constructor(scene, kase, outlines, origin) {
    this.scene = scene;
    this.parameters = parameterValues(scene);
    this.kase = kase;
    this.unit = scene.scalar(["length_unit"]) ?? "";
    this.origin = origin;
    this.outlines = outlines;
    /** Whether the scene is of many blocks. */
    this.many = outlines.blocks !== undefined;
    const { metres_per_unit: metres, block, base } = outlines.placed;
    const shift = { x: outlines.origin_x_m - origin.x, y: outlines.origin_y_m - origin.y };
    this.metres = metres;
    /** Null where the outline is not the scene's point by point. @type {Placement|null} */
    this.block = block === null ? null : new Placement(block, metres, shift);
    /** Null where the base has no profile with the scene's points. @type {Placement|null} */
    this.base = base === null ? null : new Placement(base, metres, shift);
  }

  /** Where the base ends to the right (sign 1) or to the left (-1), in the frame of the drawing. @returns {Point|null} */
  baseEnd(sign) {
    const ends = pathEnds(this.outlines.base);
    if (ends === null) return null;
    const [x, y] = ends[sign > 0 ? 1 : 0];
    return { x: x + this.outlines.origin_x_m - this.origin.x, y: y + this.outlines.origin_y_m - this.origin.y };
  }

  /** A point of the results in the frame of the drawing. */
  result(x, y) {
    const at = resultPoint(this.outlines, x, y);
    return { x: at.x + this.outlines.origin_x_m - this.origin.x, y: at.y + this.outlines.origin_y_m - this.origin.y };
  }

  /** @param {(string|number)[]} path */
  number(path) {
    return quantity(this.scene, path, this.parameters);
  }
}

/** @param {import("../scene/quantity.js").Quantity} of @param {number} value @param {number} exponent @returns {Edit} */
export function edit(of, value, exponent) {
  return { path: of.path, text: snap(value, exponent) };
}

/** Why one of several numbers is not free. @param {import("../scene/quantity.js").Quantity[]} numbers */
export function whyFixed(name, ...numbers) {
  const stuck = numbers.filter((one) => one.fixed !== null);
  return stuck.length === numbers.length ? name + " " + stuck[0].fixed : null;
}

/**
 * A vertex [x, y] of a list.
 * @param {Context} context @param {Placement} placement @param {(string|number)[]} path
 * @param {(string|number)[][]} [places] of points that may be this vertex, named elsewhere: they go with it
 * @returns {Handle|null}
 */
export function vertexHandle(context, placement, path, label, places = []) {
  const x = context.number([...path, 0]);
  const y = context.number([...path, 1]);
  if (x.value === null || y.value === null) return null;
  const same = places.map((place) => [context.number([...place, 0]), context.number([...place, 1])])
    .filter(([across, up]) => across.value === x.value && up.value === y.value);
  const free = (number, value, exponent) => (number.fixed === null ? [edit(number, value, exponent)] : []);
  const put = (across, up, exponent) =>
    sameOnce([[x, y], ...same].flatMap((point) => [...free(point[0], across, exponent), ...free(point[1], up, exponent)]));
  return {
    key: path.join("."), kind: "vertex", moves: "xy", fixed: whyFixed(label, x, y),
    get label() {
      return say("%s at %s", label, numeral(x.value + "") + between + numeral(y.value + "") + " " + context.unit);
    },
    at: placement.toFrame(x.value, y.value),
    drag: (hand, exponent) => {
      const scene = placement.toScene(hand.x, hand.y);
      return put(scene.x, scene.y, exponent);
    },
    step: (dx, dy, exponent) => put(x.value + dx * 10 ** exponent, y.value + dy * 10 ** exponent, exponent),
  };
}

/** Where x and y are one parameter, the first says what it becomes. @param {Edit[]} edits */
function sameOnce(edits) {
  const seen = new Set();
  return edits.filter(({ path }) => !seen.has(path.join(".")) && seen.add(path.join(".")));
}

/**
 * A length that is read off one axis of the drawing.
 * @param {Context} context
 * @param {{key?: string, name: string, of: import("../scene/quantity.js").Quantity, at: Point, moves: "x"|"y", kind: Handle["kind"],
 *   value: (hand: Point) => number, least: number, sign?: number}} says at: where it is, in the frame; value: what the
 *   hand's place there makes of it; least: in steps: 0, 1 where it must stay above 0, or none; sign: -1 where it grows against
 *   the axis
 * @returns {Handle}
 */
export function lengthHandle(context, { name, key = name, of, at, moves, kind, value, least, sign = 1 }) {
  const put = (number, exponent) => [edit(of, Math.max(number, least * 10 ** exponent), exponent)];
  const along = of.parameter === null ? "" : " (" + say("parameter %s", of.parameter) + ")";
  return {
    key, kind, moves, at, fixed: of.fixed === null ? null : say(name) + " " + of.fixed,
    label: say(name) + along + " " + numeral((of.value ?? 0) + "") + " " + context.unit,
    drag: (hand, exponent) => put(value(hand), exponent),
    step: (dx, dy, exponent) => put((of.value ?? 0) + sign * (moves === "x" ? dx : dy) * 10 ** exponent, exponent),
  };
}
