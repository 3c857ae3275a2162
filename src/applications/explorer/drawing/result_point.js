// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Points of results have the coordinates that the scene is given in; outlines lie along the mean plane, from an origin of their own.
 * @param {object} outlines @param {{value: number}} x metres @param {{value: number}} y
 * @returns {{x: number, y: number}} the point among the outlines, metres
 */
export function resultPoint(outlines, x, y) {
  const { cosine, sine, x_m, y_m } = outlines.placed.results;
  return { x: cosine * x.value - sine * y.value + x_m, y: sine * x.value + cosine * y.value + y_m };
}
