// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The tilt as an arc in a corner of the drawing: its arm lies as the base does. */

import { edit } from "./handle.js";
import { numeral, say } from "../words/language.js";

const DEGREES = 180 / Math.PI;
const EDGE = 30;

/**
 * @param {import("./handle.js").Context} context
 * @param {import("./view.js").View} view
 * @param {number} sign 1 where the tilt turns counter-clockwise on the screen, that is towards the left
 */
export function tiltHandle(context, view, sign) {
  const of = context.number(tiltPath(context));
  const shape = tiltArc(view, sign);
  const angle = Math.abs(view.turn);
  const beyond = angle * DEGREES - (of.value ?? 0); // what the base is turned by beyond the number
  const put = (degrees, exponent) => [edit(of, Math.min(90, Math.max(0, degrees)), exponent)];
  return {
    key: "tilt.angle_deg", kind: "tilt", moves: "xy", fixed: of.fixed === null ? null : say("the tilt") + " " + of.fixed,
    label: of.present ? say("tilt %s degrees", numeral(of.value + "")) : say("tilt: the scene gives none; drag to give it one"),
    dots: { x: shape.x + sign * shape.radius * Math.cos(angle), y: shape.y - shape.radius * Math.sin(angle) },
    drag: (hand) => put(Math.atan2(shape.y - hand.y, sign * (hand.x - shape.x)) * DEGREES - beyond, -1),
    step: (dx, dy) => put((of.value ?? 0) + (dx + dy) * 0.1, -1),
  };
}

/** Where the angle stands at which all lies: on a slope its dip, unless one block is tilted there further. @param {import("./handle.js").Context} context */
export function tiltPath(context) {
  const isDip = context.scene.has(["slope", "dip_deg"]) && (context.many || !context.scene.has(["tilt", "angle_deg"]));
  return isDip ? ["slope", "dip_deg"] : ["tilt", "angle_deg"];
}

/** The arc, its two arms, and the angle between them. @param layer a d3 selection with a path and a text */
export function drawArc(layer, view, sign, decimals = 4) {
  const { x, y, radius } = tiltArc(view, sign);
  const angle = Math.abs(view.turn);
  const on = (r, a) => (x + sign * r * Math.cos(a)) + " " + (y - r * Math.sin(a));
  const path = "M" + on(radius, 0) + "L" + x + " " + y + "L" + on(radius, angle) +
    "M" + on(0.6 * radius, 0) + "A" + 0.6 * radius + " " + 0.6 * radius + " 0 0 " + (sign > 0 ? 0 : 1) + " " + on(0.6 * radius, angle);
  layer.select("path").attr("d", path);
  layer.select("text").attr("x", x + sign * 0.72 * radius * Math.cos(angle / 2)).attr("y", y - 0.72 * radius * Math.sin(angle / 2) + 4)
    .attr("text-anchor", sign > 0 ? "start" : "end").text(numeral(+(angle * DEGREES).toFixed(decimals) + "°"));
}

/**
 * By how much the drawing is turned: the tilt of the answer, or of a text that is newer, over the dip at which the section lies. A load
 * case may have another tilt or dip than the text says first.
 * @param {import("./handle.js").Context} context @param {boolean} isSolved whether the answer is of that text @param {number} sign
 * @returns {number} radians, counter-clockwise on the screen
 */
export function turnOf(context, isSolved, sign) {
  const { frame, tilt_angle_deg: answered } = context.kase;
  const isOnSlope = frame?.is === "slope";
  if (isSolved && (context.many || isOnSlope)) return (sign * (answered?.value ?? frame.dip_deg.value)) / DEGREES;
  const path = tiltPath(context);
  const own = isSolved && frame?.is === "base" ? answered?.value ?? 0 : context.number(path).value ?? (path[0] === "slope" ? frame?.dip_deg?.value : 0) ?? 0;
  const dip = frame?.inclined ? frame.inclination_deg.value : frame?.is === "world" || (isOnSlope && path[0] === "tilt") ? frame.dip_deg.value : 0;
  return (sign * Math.min(180, Math.max(0, own) + Math.abs(dip))) / DEGREES;
}

/** Where its arc is, dots. */
export function tiltArc(view, sign) {
  const radius = Math.max(60, Math.min(150, 0.25 * view.width, 0.4 * view.height));
  return { x: sign > 0 ? EDGE : view.width - EDGE, y: view.height - EDGE, radius };
}
