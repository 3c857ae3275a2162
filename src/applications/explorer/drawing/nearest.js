// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Which of many vertices get handles: those nearest to the hand, and those nearest to the contact. */

/** So many at most: more of them could not be told apart. */
export const HANDLES_MAX = 150;
const AROUND = 20; // dots beyond the window

/**
 * @typedef {object} Candidate
 * @property {string} key of its handle
 * @property {{x: number, y: number}} at in the frame of the drawing
 * @property {() => import("./handle.js").Handle|null} made its handle
 */

/**
 * @param {Candidate[]} candidates
 * @param {import("./view.js").View} view
 * @param {{hand: {x: number, y: number}|null, contact: {x: number, y: number}[], kept: Set<string>}} near hand: on the screen;
 *   contact: its ends, in the frame; kept: keys of those that have a handle in any case, as one that is dragged
 * @returns {{chosen: Candidate[], hidden: number}} in the order that they came in; how many more are in the window
 */
export function nearestOf(candidates, view, { hand, contact, kept }) {
  const [a, b, c, d, e, f] = view.matrix;
  const seen = candidates.map((candidate, index) => {
    const { x, y } = candidate.at;
    return { candidate, index, x: a * x + c * y + e, y: b * x + d * y + f };
  }).filter(({ candidate, x, y }) => kept.has(candidate.key) || inWindow(view, x, y));
  if (seen.length <= HANDLES_MAX) return { chosen: seen.map(({ candidate }) => candidate), hidden: 0 };
  const chosen = new Set(seen.filter(({ candidate }) => kept.has(candidate.key)));
  const ends = contact.map(({ x, y }) => view.toScreen(x, y));
  const middle = { x: view.width / 2, y: view.height / 2 };
  if (hand !== null) take(seen, (one) => Math.hypot(one.x - hand.x, one.y - hand.y), HANDLES_MAX / 2, chosen);
  take(seen, (one) => fromSegment(one, ends[0] ?? middle, ends[1] ?? ends[0] ?? middle), HANDLES_MAX, chosen);
  const ordered = [...chosen].sort((one, other) => one.index - other.index);
  return { chosen: ordered.map(({ candidate }) => candidate), hidden: seen.length - ordered.length };
}

/** The nearest ones, until there are so many. */
function take(seen, distance, most, chosen) {
  const far = Float64Array.from(seen, distance);
  // none of those that are taken lies farther off: thousands of numbers are sorted sooner than what they belong to
  const farthest = Float64Array.from(far).sort()[Math.min(most, far.length) - 1];
  const near = seen.flatMap((one, i) => (far[i] <= farthest ? [{ one, distance: far[i] }] : []));
  for (const { one } of near.sort((one, other) => one.distance - other.distance)) {
    if (chosen.size >= most) return;
    chosen.add(one);
  }
}

function inWindow(view, x, y) {
  return x > -AROUND && y > -AROUND && x < view.width + AROUND && y < view.height + AROUND;
}

function fromSegment({ x, y }, from, to) {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const share = Math.max(0, Math.min(1, ((x - from.x) * dx + (y - from.y) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(from.x + share * dx - x, from.y + share * dy - y);
}
