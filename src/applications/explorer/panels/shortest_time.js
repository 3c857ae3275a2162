// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The clock of a browser ticks in steps, and what took less than one took nothing by it: such a run stands at the shortest time that
 * was measured, which is a bound on its own, as no logarithm has a place for nothing.
 * @param {{seconds: number}[]} runs @returns {number} seconds
 */
export function shortestTime(runs) {
  const measured = runs.map(({ seconds }) => seconds).filter((seconds) => seconds > 0);
  return measured.length > 0 ? Math.min(...measured) : 1e-6;
}
