// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * From the block's frame in metres (x along the mean plane of the base, y up) to dots of the screen (y down): turned
 * by the tilt, scaled to fit, then moved and scaled by the hand that zooms. Coordinates are relative to an origin near
 * the block, so that a block far from zero keeps its digits.
 */

const MARGIN = 0.14;
const NARROW = 700; // dots: a drawing below the badge, in a wider one it stands beside
const BADGE = 70;

/** How much of the upper edge of a drawing stands below the badge, dots. @param {number} width of the drawing @param {number} [height] @param {number} [badge] its lower edge */
export function belowBadge(width, height = Infinity, badge = BADGE) {
  return width < NARROW ? Math.min(Math.max(BADGE, badge), 0.6 * height) : 0;
}

export class View {
  constructor() {
    this.width = 800;
    this.height = 600;
    /** Counter-clockwise on the screen, radians. */
    this.turn = 0;
    /** By how much a film of the view turns the base beyond the tilt of the scene, radians. */
    this.swing = 0;
    /** What the drawing turns about, and what the frame's zero is. */
    this.centre = { x: 0, y: 0 };
    this.scale = 1;
    /** d3's transform of the hand. */
    this.zoom = { k: 1, x: 0, y: 0 };
    /** Dots at the upper edge that something else stands over. */
    this.top = 0;
  }

  /** Of the window, dots. @param {number} width @param {number} height @param {number} badge its lower edge */
  resize(width, height, badge) {
    [this.width, this.height] = [width, height];
    this.top = belowBadge(width, height, badge);
  }

  /** @param {number[]} box x0, y0, x1, y1 of what is to be seen, whatever the tilt @param {number|null} [turn] or at this one alone */
  fit([x0, y0, x1, y1], turn = null) {
    this.centre = { x: (x0 + x1) / 2, y: (y0 + y1) / 2 };
    const [width, height] = [x1 - x0, y1 - y0];
    const across = Math.hypot(width, height);
    const [cosine, sine] = turn === null ? [0, 0] : [Math.abs(Math.cos(turn)), Math.abs(Math.sin(turn))];
    const [wide, high] = turn === null ? [0.75 * across + 0.25 * width, across] : [cosine * width + sine * height, sine * width + cosine * height];
    const room = Math.min(this.width / wide, (this.height - this.top) / high);
    this.scale = across > 0 && Number.isFinite(across) ? room * (1 - MARGIN) : 1;
  }

  get dotsPerMetre() {
    return this.scale * this.zoom.k;
  }

  /** As a matrix of SVG: a b c d e f. @returns {number[]} */
  get matrix() {
    const k = this.dotsPerMetre;
    const cosine = Math.cos(this.turn) * k;
    const sine = Math.sin(this.turn) * k;
    const middle = { x: (this.width / 2) * this.zoom.k + this.zoom.x, y: ((this.height + this.top) / 2) * this.zoom.k + this.zoom.y };
    const { x, y } = this.centre;
    return [cosine, -sine, -sine, -cosine, middle.x - cosine * x + sine * y, middle.y + sine * x + cosine * y];
  }

  /** @param {number} x @param {number} y in metres @returns {{x: number, y: number}} dots */
  toScreen(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    return { x: a * x + c * y + e, y: b * x + d * y + f };
  }

  /** @param {number} x @param {number} y dots @returns {{x: number, y: number}} metres */
  toFrame(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    const inverse = 1 / (a * d - b * c);
    return { x: (d * (x - e) - c * (y - f)) * inverse, y: (a * (y - f) - b * (x - e)) * inverse };
  }

  /** A direction of the frame on the screen, of length 1. */
  direction(x, y) {
    const [a, b, c, d] = this.matrix;
    const across = { x: a * x + c * y, y: b * x + d * y };
    const length = Math.hypot(across.x, across.y) || 1;
    return { x: across.x / length, y: across.y / length };
  }
}

/**
 * Between the scene's own coordinates and the frame that is drawn, as the core told it.
 * @typedef {{cosine: number, sine: number, x_m: number, y_m: number}} Placed
 */
export class Placement {
  /**
   * @param {Placed} of
   * @param {number} unit metres per length of the scene
   * @param {{x: number, y: number}} shift from the answer's origin to that of the drawing, metres
   */
  constructor(of, unit, shift) {
    this.of = of;
    this.unit = unit;
    this.shift = { x: of.x_m + shift.x, y: of.y_m + shift.y };
  }

  /** That of points which are shifted, in lengths of the scene. */
  shifted(x, y) {
    const at = this.toFrame(x, y);
    return new Placement(this.of, this.unit, { x: at.x - this.of.x_m, y: at.y - this.of.y_m });
  }

  toFrame(x, y) {
    const { cosine, sine } = this.of;
    return { x: (cosine * x - sine * y) * this.unit + this.shift.x, y: (sine * x + cosine * y) * this.unit + this.shift.y };
  }

  toScene(x, y) {
    const { cosine, sine } = this.of;
    const [across, up] = [x - this.shift.x, y - this.shift.y];
    return { x: (cosine * across + sine * up) / this.unit, y: (cosine * up - sine * across) / this.unit };
  }
}
