// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * What the reactions of the base at the static limit are in balance with: the weight alone, or the weight with the loads
 * that the answer lists and the strength of the contact. The answer has the sum of what is applied (`limit.balance`).
 */

/** Of what is applied, by which a number may differ from its printed sum: doubles, as shares of the weight. */
const ROUNDING = 1e-9;
const WEIGHT = "weight";
const STRENGTHS = ["bond", "cohesion"];

/** @param {{value: number, error: number}|null|undefined} share */
const bounds = (share) => Math.abs(share?.error ?? 0) + ROUNDING;

/** Loads by their first word, as "water" of "water, normal"; each once. @param {{name: string}[]|undefined} loads @returns {string[]} */
function loadNames(loads) {
  return [...new Set((loads ?? []).map(({ name }) => name.split(",")[0]))].filter((name) => name !== WEIGHT && !STRENGTHS.includes(name));
}

/** @param {any} strength of `limit.balance` @returns {boolean} whether cohesion or bond take a part */
function isStrong(strength) {
  return ["share_x", "share_y", "moment_m"].some((key) => Math.abs(strength?.[key]?.value ?? 0) > bounds(strength?.[key]));
}

/**
 * @param {any} theCase with its static limit
 * @returns {{weight: boolean, others: string[]}|null} weight: alone; others: names of what is in balance with it; null: the
 *   answer does not say what else there is
 */
export function balancedBy({ limit, loads }) {
  const { balance } = limit;
  if (balance === undefined || balance === null) return null;
  const others = [...loadNames(loads), ...(isStrong(balance.strength) ? ["cohesion or bond"] : [])];
  if (others.length > 0) return { weight: false, others };
  const { share_x: x, share_y: y } = balance.applied;
  const isWeight = Math.abs(Math.hypot(x.value, y.value) - 1) <= bounds(x) + bounds(y);
  return isWeight ? { weight: true, others } : null;
}
