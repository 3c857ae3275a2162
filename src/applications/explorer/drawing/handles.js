// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** All handles of a scene. */

import { blockHandles } from "./block_handles.js";
import { baseHandles } from "./base_handles.js";
import { loadHandles } from "./load_handles.js";
import { tiltHandle } from "./tilt_handle.js";

/**
 * @param {import("./handle.js").Context} context @param {import("./view.js").View} view
 * @param {number} sign 1 where the tilt turns counter-clockwise on the screen
 * @returns {import("./handle.js").Handle[]}
 */
export function handlesOf(context, view, sign) {
  if (context.scene.unread !== null) return [];
  return [tiltHandle(context, view, sign), ...baseHandles(context), ...loadHandles(context, view), ...blockHandles(context)];
}
