// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The motion that begins, from the accelerations that the core proves: a block released from rest moves by half of
 * them times the square of the time. Shown slower than it is, up to a fixed share of the block's size.
 */

import { resultPoint } from "./result_point.js";

const SHOWN_MS = 1800;
const REST_MS = 500;
const SHARE = 0.22; // of the block's size

/**
 * @param {object} kase @param {object} outlines of the same answer
 * @returns {((share: number) => string)|null} the block's transform in its frame at a share of the way, 0 to 1
 */
export function motionOf(kase, outlines) {
  const motion = kase.motions?.[0];
  if (motion === undefined || !motion.accelerations_fixed) return null;
  const { x, y } = resultPoint(outlines, kase.block.centroid_x_m, kase.block.centroid_y_m);
  const box = outlines.box_m;
  const [ax, ay, turn] = [motion.acceleration_x_g, motion.acceleration_y_g, motion.angular_g_per_m].map((a) => a?.value ?? 0);
  const size = Math.hypot(box[2] - box[0], box[3] - box[1]);
  const fastest = Math.hypot(ax, ay) + Math.abs(turn) * size * 0.5;
  if (!(fastest > 0)) return null;
  const reach = (SHARE * size) / fastest;
  return (share) => {
    const way = share * reach;
    return "translate(" + (x + ax * way) + " " + (y + ay * way) + ") rotate(" + (turn * way * 180) / Math.PI + ") translate(" + -x + " " + -y + ")";
  };
}

export class Motion {
  #frame = 0;

  /** @param {() => (((share: number) => string)|null)} current @param {(transform: string|null) => void} put */
  constructor(current, put) {
    this.current = current;
    this.put = put;
    this.playing = false;
  }

  /** Where the reader asked for less motion, the end of it is shown, standing still. */
  play() {
    this.playing = true;
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const began = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      const at = this.current();
      const time = (now - began) % (SHOWN_MS + REST_MS);
      this.put(at === null ? null : at(still ? 1 : Math.min(1, Math.max(0, time / SHOWN_MS)) ** 2));
      if (!still) this.#frame = requestAnimationFrame(step);
    };
    step(began);
  }

  stop() {
    this.playing = false;
    cancelAnimationFrame(this.#frame);
    this.put(null);
  }
}
