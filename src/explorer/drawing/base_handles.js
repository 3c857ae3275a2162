// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Handles of the base: points of its profile, or how far a mated base goes on beyond the block. */

import { lengthHandle } from "./handle.js";
import { listHandles } from "./block_handles.js";

/** @param {import("./handle.js").Context} context @returns {import("./handle.js").Handle[]} */
export function baseHandles(context) {
  const keys = context.scene.keys(["base"]) ?? [];
  if (keys.includes("profile")) return listHandles(context, ["base", "profile"], "the profile");
  if (context.kase === null || !context.kase.contact?.mated) return [];
  return [beyondHandle(context, "left", -1), beyondHandle(context, "right", 1)];
}

function beyondHandle(context, side, sign) {
  const of = context.number(["base", "beyond", side]);
  const { contact } = context.kase;
  const end = contact[side + "_end"];
  const { placement } = context;
  const foot = { x: end.x_m.value - placement.origin.x, y: end.y_m.value - placement.origin.y };
  const unit = placement.unit;
  const handle = lengthHandle(context, {
    name: "base beyond the block to the " + side, of, kind: "base", moves: "x", least: 0, sign,
    at: { x: 0, y: 0 }, value: () => 0,
  });
  const put = handle.step;
  handle.at = { x: foot.x + sign * (of.value ?? 0) * unit, y: foot.y };
  handle.drag = (hand, exponent) => {
    const wanted = Math.max(0, (sign * (hand.x - foot.x)) / unit);
    return put((sign * (wanted - (of.value ?? 0))) / 10 ** exponent, 0, exponent);
  };
  return handle;
}
