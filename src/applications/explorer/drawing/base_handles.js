// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Handles of the base: points of its profile, or how far a mated base extends beyond the block; the shift along it. */

import { lengthHandle } from "./handle.js";
import { listHandles } from "./block_handles.js";
import { say } from "../words/language.js";

/** @param {import("./handle.js").Context} context @returns {import("./handle.js").Handle[]} */
export function baseHandles(context) {
  return [...jointHandle(context), ...baseEnds(context)];
}

function baseEnds(context) {
  if (hasProfile(context) || !context.kase.contact?.mated) return [];
  return [beyondHandle(context, "left", -1), beyondHandle(context, "right", 1)];
}

/** At the centroid: the block is dragged along the base that it fits. What it was shifted by is the answer's number. */
function jointHandle(context) {
  const of = context.number(["joint", "shift"]);
  const shifted = context.kase.joint?.shift_m;
  if (of.value === null || shifted === undefined) return [];
  const at = context.result(context.kase.block.centroid_x_m, context.kase.block.centroid_y_m);
  const value = (hand) => (shifted.value + hand.x - at.x) / context.metres;
  return [lengthHandle(context, { name: "shift along the joint", of, kind: "size", moves: "x", least: -Infinity, at, value })];
}

function hasProfile(context) {
  return (context.scene.keys(["base"]) ?? []).includes("profile");
}

/** @param {import("./handle.js").Context} context @param {Set<string>|null} only as `listHandles` takes it @returns {import("./nearest.js").Candidate[]} points of the profile */
export function baseVertices(context, only) {
  if (!hasProfile(context) || context.base === null) return [];
  return listHandles(context, context.base, ["base", "profile"], say("the profile"), { only }).map(({ key, at, made }) => {
    return { key, at, made: () => ({ ...made(), kind: "base" }) };
  });
}

/**
 * It counts from the end of the contact outwards; the handle is where the base ends. The core asks for both sides where
 * the scene gives one.
 */
function beyondHandle(context, side, sign) {
  const of = context.number(["base", "beyond", side]);
  const end = context.kase.contact[side + "_end"];
  const foot = context.result(end.x_m, end.y_m);
  const handle = lengthHandle(context, {
    name: "base beyond the block to the " + side, of, kind: "base", moves: "x", least: 0, sign,
    at: context.baseEnd(sign) ?? foot, value: (hand) => (sign * (hand.x - foot.x)) / context.metres,
  });
  if (context.scene.keys(["base", "beyond"]) !== null) return handle;
  const both = ([{ text }]) => [{ path: ["base", "beyond"], text: side === "left" ? "{left: " + text + ", right: 0}" : "{left: 0, right: " + text + "}" }];
  return { ...handle, drag: (...hand) => both(handle.drag(...hand)), step: (...steps) => both(handle.step(...steps)) };
}
