// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Handles of loads: the level of the water behind the block, where an anchor pulls, and which way. */

import { edit, lengthHandle, vertexHandle } from "./handle.js";

const ARROW_DOTS = 64;
const DEGREES = 180 / Math.PI;

/** @param {import("./handle.js").Context} context @param {import("./view.js").View} view */
export function loadHandles(context, view) {
  const handles = waterHandles(context);
  for (let i = 0; i < (context.scene.count(["loads", "anchors"]) ?? 0); i++) {
    const point = vertexHandle(context, ["loads", "anchors", i, "at"], "anchor " + (i + 1));
    if (point === null) continue;
    point.kind = "load";
    handles.push(point);
    const direction = directionHandle(context, view, i, point.at);
    if (direction !== null) handles.push(direction);
  }
  return handles;
}

/** Its height counts from the up-dip end of the contact. */
function waterHandles(context) {
  const of = context.number(["loads", "water", "height"]);
  if (of.value === null || context.kase === null) return [];
  const end = context.kase.contact[context.kase.towards === "left" ? "right_end" : "left_end"];
  const { placement } = context;
  const foot = { x: end.x_m.value - placement.origin.x, y: end.y_m.value - placement.origin.y };
  const handle = lengthHandle(context, {
    name: "height of the water", of, kind: "load", moves: "y", least: 0, at: { x: 0, y: 0 }, value: () => 0,
  });
  handle.at = { x: foot.x, y: foot.y + of.value * placement.unit };
  handle.drag = (hand, exponent) => [edit(of, Math.max(0, (hand.y - foot.y) / placement.unit), exponent)];
  return [handle];
}

function directionHandle(context, view, i, at) {
  const of = context.number(["loads", "anchors", i, "direction_deg"]);
  if (of.value === null) return null;
  const { cosine, sine } = context.placement.of;
  const angle = of.value / DEGREES;
  const along = view.direction(cosine * Math.cos(angle) - sine * Math.sin(angle), sine * Math.cos(angle) + cosine * Math.sin(angle));
  const foot = view.toScreen(at.x, at.y);
  const name = "direction of anchor " + (i + 1);
  return {
    key: "loads.anchors." + i + ".direction_deg", kind: "load", moves: "y", fixed: of.fixed === null ? null : name + " " + of.fixed,
    label: name + " " + of.value + " degrees",
    dots: { x: foot.x + ARROW_DOTS * along.x, y: foot.y + ARROW_DOTS * along.y },
    drag: (hand) => {
      const frame = view.toFrame(hand.x, hand.y);
      const [dx, dy] = [frame.x - at.x, frame.y - at.y];
      return [edit(of, Math.atan2(cosine * dy - sine * dx, cosine * dx + sine * dy) * DEGREES, 0)];
    },
    step: (dx, dy) => [edit(of, of.value + dy - dx, 0)],
  };
}
