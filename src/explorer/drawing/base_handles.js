// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Handles of the base: points of its profile, or how far a mated base goes on beyond the block. */

import { lengthHandle } from "./handle.js";
import { listHandles } from "./block_handles.js";

/** @param {import("./handle.js").Context} context @returns {import("./handle.js").Handle[]} */
export function baseHandles(context) {
  const keys = context.scene.keys(["base"]) ?? [];
  if (keys.includes("profile")) return context.base === null ? [] : listHandles(context, context.base, ["base", "profile"], "the profile");
  if (!context.kase.contact?.mated) return [];
  return [beyondHandle(context, "left", -1), beyondHandle(context, "right", 1)];
}

/** It counts from the end of the contact outwards; the handle is where the base ends. */
function beyondHandle(context, side, sign) {
  const of = context.number(["base", "beyond", side]);
  const end = context.kase.contact[side + "_end"];
  const foot = context.result(end.x_m, end.y_m);
  return lengthHandle(context, {
    name: "base beyond the block to the " + side, of, kind: "base", moves: "x", least: 0, sign,
    at: context.baseEnd(sign) ?? foot, value: (hand) => (sign * (hand.x - foot.x)) / context.metres,
  });
}
