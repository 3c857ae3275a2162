// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What is drawn over many blocks in dots of the screen: forces in their contacts just before the collapse, loads, names. */

import { arrow, loads } from "./symbols.js";
import { pathPoints } from "./thin_path.js";
import { numeral, say } from "../words/language.js";

const FORCE_SHARE = 0.13; // of the largest force, of the lesser side of the window
const NEGLIGIBLE = 0.02; // of it
const DOWNWARDS = 0.1; // of a force: what counts as such
const LETTER_DOTS = 7.5;
const NAME_DOTS = 9;
const DIGITS = 4;

/**
 * @param {object} answer of many blocks @param {object} kase of it @param {import("./view.js").View} view @param {{x: number, y: number}} origin metres
 * @returns {import("./symbols.js").Symbol[]} from the back to the front
 */
export function symbolsOfMany({ blocks, contacts, outlines }, kase, view, origin) {
  const shift = { x: outlines.origin_x_m - origin.x, y: outlines.origin_y_m - origin.y };
  const on = (x, y) => view.toScreen(x - origin.x, y - origin.y);
  return [...forces(blocks, contacts, kase, view, on), ...loads(outlines, view, shift), ...names(blocks, outlines, view, on)];
}

function forces(blocks, contacts, kase, view, on) {
  const found = kase.forces ?? [];
  const size = (force) => Math.hypot(force.normal_n_m, force.shear_n_m);
  const largest = found.reduce((most, force) => Math.max(most, size(force)), 0);
  const ground = new Set(blocks.filter((block) => block.ground).map((block) => block.name));
  return found.flatMap((force, k) => {
    if (!(size(force) > NEGLIGIBLE * largest)) return [];
    const { first, second } = contacts[k];
    const push = pushOf(contacts[k], force);
    const sign = isOnFirst(ground.has(first), ground.has(second), view.direction(push.x, push.y), kase.towards) ? 1 : -1;
    const along = view.direction(sign * push.x, sign * push.y);
    const long = (FORCE_SHARE * Math.min(view.width, view.height) * size(force)) / largest;
    const to = on(force.x_m, force.y_m);
    return [{ kind: "contact-force", d: arrow({ x: to.x - long * along.x, y: to.y - long * along.y }, to),
      title: say("between %s and %s: N %s, T %s kN/m", first, second, ...[force.normal_n_m, force.shear_n_m].map((each) => numeral((each / 1000).toPrecision(DIGITS)))) }];
  });
}

/** The force on the first block, which lies on the left of the way from one end of the contact to the other. */
function pushOf(contact, { normal_n_m: normal, shear_n_m: shear }) {
  const [dx, dy] = [contact.to_x_m.value - contact.from_x_m.value, contact.to_y_m.value - contact.from_y_m.value];
  const length = Math.hypot(dx, dy) || 1;
  return { x: (shear * dx - normal * dy) / length, y: (shear * dy + normal * dx) / length };
}

/** The arrow is that on the free block where the other is ground, between two free ones on the one that it presses down, or else to the side of the tilt. */
function isOnFirst(firstIsGround, secondIsGround, { x, y }, towards) {
  if (secondIsGround || firstIsGround) return secondIsGround;
  return Math.abs(y) > DOWNWARDS ? y > 0 : (x < 0) === (towards === "left");
}

/** Those that their blocks have room for, above the handle in the middle. */
function names(blocks, outlines, view, on) {
  const sizes = sizesOf(outlines);
  const [cosine, sine] = [Math.cos(view.turn), Math.sin(view.turn)].map((each) => Math.abs(each) / view.dotsPerMetre);
  return blocks.flatMap(({ name, ground, centroid_x_m: x, centroid_y_m: y }, k) => {
    const [width, height] = sizes[k];
    if (ground || Math.min(width / cosine, height / sine) < LETTER_DOTS * name.length) return [];
    const at = on(x.value, y.value);
    return [{ kind: "name", x: at.x, y: at.y - NAME_DOTS, text: name, title: name }];
  });
}

const measured = new WeakMap();

/** Width and height of each block, metres, measured once for each answer. @returns {number[][]} */
function sizesOf(outlines) {
  if (!measured.has(outlines)) {
    measured.set(outlines, outlines.blocks.map((path) => [0, 1].map((axis) => {
      const [least, most] = pathPoints(path).reduce(([low, high], point) => [Math.min(low, point[axis]), Math.max(high, point[axis])], [Infinity, -Infinity]);
      return most - least;
    })));
  }
  return measured.get(outlines);
}
