// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Corners that come near to others in x or in y are put level with them, exactly. */

const NEAR_DOTS = 7;
const DIGITS = 12;

export class Alignment {
  /** @param {{x: number, y: number}[]} corners of all blocks, in lengths of the scene @param {number} dots of the screen a length has */
  constructor(corners, dots) {
    this.corners = corners;
    this.near = NEAR_DOTS / dots;
  }

  /**
   * By how much points are shifted, near to what is wanted: such that one of them is level with a corner.
   * @param {{x: number, y: number}[]} points @param {{x: number, y: number}} wanted
   * @param {(corner: object) => boolean} counts whether a corner is another one, which does not come along
   * @param {number} exponent of the step, where there is no such corner
   * @returns {{x: number, y: number, exponent: number}} exponent: of the step that these are multiples of
   */
  shift(points, wanted, counts, exponent) {
    const corners = this.corners.filter(counts);
    const [x, y] = ["x", "y"].map((axis) => this.#level(points.map((point) => point[axis]), wanted[axis], corners.map((corner) => corner[axis])));
    if (x === null && y === null) return { ...wanted, exponent };
    const step = 10 ** exponent;
    const rounded = (value) => Math.round(value / step) * step;
    const shift = { x: x ?? rounded(wanted.x), y: y ?? rounded(wanted.y) };
    const fine = (value) => Math.floor(Math.log10(Math.abs(value) || 1)) + 1 - DIGITS;
    return { ...shift, exponent: Math.max(-20, Math.min(exponent, Math.max(fine(shift.x), fine(shift.y)))) };
  }

  /** @returns {number|null} null: no corner is near */
  #level(values, wanted, corners) {
    let best = null;
    let far = this.near;
    for (const corner of corners) {
      for (const value of values) {
        const off = Math.abs(corner - value - wanted);
        if (off >= far) continue;
        far = off;
        best = corner - value;
      }
    }
    return best;
  }
}
