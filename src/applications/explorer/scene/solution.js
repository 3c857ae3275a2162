// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** What the core printed for a scene, with what all kinds have: the kind, cases, notes. */

/** @param {"block"|"blocks"|"solid"} kind @param {string} printed JSON */
export function solutionOf(kind, printed) {
  const own = JSON.parse(printed);
  return { kind, cases: kind === "solid" ? casesOfSolid(own) : [], notes: [], ...own };
}

/** A solid has no cases of its own: one, of its wedge, of the contacts that the scene gives, or of the band that governs. */
function casesOfSolid({ bands = [], wedge, contacts, safety, governing_band: governing, tilt_angle_deg: tilt }) {
  if (wedge !== undefined) return [{ mechanism: wedge.verdict, in_place: true, ...factorOf(safety) }];
  const band = bands.find(({ band: one }) => one === governing) ?? bands[0];
  const stance = contacts ?? band?.stance;
  if (stance?.verdict === undefined) return band?.mechanism ? [{ mechanism: band.mechanism }] : [];
  return [{ mechanism: stance.verdict, tilt_angle_deg: tilt > 0 ? { value: tilt, error: 0 } : undefined, ...factorOf(safety) }];
}

/** The factor that governs a solid, or its upper bound where it is not decided. @param {object|undefined} safety */
function factorOf(safety) {
  if (safety === undefined) return {};
  const { fos, most, mechanism = "slides", fos_is } = safety;
  if (fos !== null) return { governing_fos: { fos, mechanism, complete: true } };
  if (most === undefined || most === null) return { governing_fos: { fos, fos_is } };
  return { governing_fos: { fos: { value: most, error: 0 }, mechanism, complete: false } };
}

/** Whether of many blocks the factor on driving loads is certainly the lesser of the two, and governs. */
export function drives({ fos, fos_driving: driving }) {
  return Boolean(driving) && driving.value + driving.error < (fos?.value ?? Infinity);
}

/** The factor that governs a case, of whatever kind; undefined: there is none. */
export function governingFactor(kase) {
  if (kase.governing_fos !== undefined) return kase.governing_fos.fos;
  return drives(kase) ? kase.fos_driving : kase.fos;
}
