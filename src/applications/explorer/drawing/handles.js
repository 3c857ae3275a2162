// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** All handles of a scene. */

import { blockHandles, blockVertices } from "./block_handles.js";
import { baseHandles, baseVertices } from "./base_handles.js";
import { columnHandles } from "./column_handles.js";
import { listedCandidates, withSizes } from "./listed_blocks.js";
import { loadHandles } from "./load_handles.js";
import { nearestOf } from "./nearest.js";
import { tiltHandle } from "./tilt_handle.js";

/**
 * @param {import("./handle.js").Context} context @param {import("./view.js").View} view
 * @param {number} sign 1 where the tilt turns counter-clockwise on the screen
 * @param {{hand: import("./handle.js").Point|null, kept: Set<string>, byKeys: string[], only: Set<string>|null}} near the hand on the screen; keys of
 *   handles that stay, of one that keys led to, and of those alone that have them while one is dragged
 * @returns {{handles: import("./handle.js").Handle[], hidden: number|null}} hidden: how many vertices in the window have none; null: as before
 */
export function handlesOf(context, view, sign, near) {
  if (context.scene.unread !== null) return { handles: [], hidden: 0 };
  const only = context.many ? null : near.only;
  const candidates = [...baseVertices(context, only), ...blockVertices(context, only), ...listedCandidates(context, view, near)];
  const { chosen, hidden } = only === null ? nearestOf(candidates, view, { ...near, contact: contactEnds(context) }) : { chosen: candidates, hidden: null };
  const made = chosen.map((candidate) => candidate.made()).filter((handle) => handle !== null);
  const [wholes, vertices] = [true, false].map((whole) => made.filter(({ kind }) => (kind === "whole") === whole));
  // whole blocks below all else, which lies on them
  const handles = [
    ...withSizes(context, view, wholes, near), tiltHandle(context, view, sign), ...baseHandles(context), ...loadHandles(context, view),
    ...blockHandles(context), ...columnHandles(context), ...vertices,
  ];
  return { handles, hidden };
}

/** In the frame of the drawing. @returns {import("./handle.js").Point[]} */
function contactEnds(context) {
  const { contact } = context.kase;
  return [contact?.left_end, contact?.right_end].filter((end) => end?.x_m).map((end) => context.result(end.x_m, end.y_m));
}
