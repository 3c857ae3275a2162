// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Handles of loads: the level of the water behind the block, where an anchor pulls, and which way. */

import { edit, lengthHandle, vertexHandle } from "./handle.js";
import { waterFoot, wettedHeight } from "./water.js";
import { numeral, say } from "../words/language.js";

const ARROW_DOTS = 64;
const DEGREES = 180 / Math.PI;

/** @param {import("./handle.js").Context} context @param {import("./view.js").View} view */
export function loadHandles(context, view) {
  const handles = waterHandles(context, view);
  for (let i = 0; i < (context.scene.count(["loads", "anchors"]) ?? 0); i++) {
    const point = context.block && vertexHandle(context, context.block, ["loads", "anchors", i, "at"], say("anchor %s", i + 1));
    if (point === null) continue;
    point.kind = "load";
    handles.push(point);
    const direction = directionHandle(context, view, i, point.at);
    if (direction !== null) handles.push(direction);
  }
  return handles;
}

/** Its height counts from the up-dip end of the contact; the handle is where the surface meets the face. */
function waterHandles(context, view) {
  const of = context.number(["loads", "water", "height"]);
  if (of.value === null) return [];
  const foot = waterFoot(context);
  const staysLevel = context.outlines.water?.stays_level ?? false;
  const along = wettedHeight(1, staysLevel, view.turn);
  return [lengthHandle(context, {
    name: "height of the water", of, kind: "load", moves: "y", least: 0,
    at: { x: foot.x, y: foot.y + of.value * along * context.metres }, value: (hand) => (hand.y - foot.y) / along / context.metres,
  })];
}

function directionHandle(context, view, i, at) {
  const of = context.number(["loads", "anchors", i, "direction_deg"]);
  if (of.value === null) return null;
  const { cosine, sine } = context.block.of;
  const angle = of.value / DEGREES;
  const along = view.direction(cosine * Math.cos(angle) - sine * Math.sin(angle), sine * Math.cos(angle) + cosine * Math.sin(angle));
  const foot = view.toScreen(at.x, at.y);
  const name = say("direction of anchor %s", i + 1);
  return {
    key: "loads.anchors." + i + ".direction_deg", kind: "load", moves: "y", fixed: of.fixed === null ? null : name + " " + of.fixed,
    label: say("%s %s degrees", name, numeral(of.value + "")),
    dots: { x: foot.x + ARROW_DOTS * along.x, y: foot.y + ARROW_DOTS * along.y },
    drag: (hand) => {
      const frame = view.toFrame(hand.x, hand.y);
      const [dx, dy] = [frame.x - at.x, frame.y - at.y];
      return [edit(of, Math.atan2(cosine * dy - sine * dx, cosine * dx + sine * dy) * DEGREES, 0)];
    },
    step: (dx, dy) => [edit(of, of.value + dy - dx, 0)],
  };
}
