// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What the core printed for a scene, with what all kinds have: the kind, cases, notes. */

/** @param {"block"|"blocks"|"solid"} kind @param {string} printed JSON */
export function solutionOf(kind, printed) {
  const own = JSON.parse(printed);
  return { kind, cases: kind === "solid" ? casesOfSolid(own) : [], notes: [], ...own };
}

/** A solid has no cases of its own: one, of the contacts that the scene gives, or of the band that governs. */
function casesOfSolid({ bands = [], contacts, governing_band: governing, tilt_angle_deg: tilt }) {
  const band = bands.find(({ band: one }) => one === governing) ?? bands[0];
  const stance = contacts ?? band?.stance;
  if (stance?.verdict === undefined) return band?.mechanism ? [{ mechanism: band.mechanism }] : [];
  const { verdict, fos, fos_mechanism: mechanism } = stance;
  const factor = fos === undefined || fos === null ? {} : { governing_fos: { fos, mechanism, complete: true } };
  return [{ mechanism: verdict, tilt_angle_deg: tilt > 0 ? { value: tilt, error: 0 } : undefined, ...factor }];
}
