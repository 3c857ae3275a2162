// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Numbers with their bounds as text, in which every digit is certain: the value and both ends of its bound round to
 * the same digits. What has no certain digit is printed with its bound. Factors of safety are rounded down.
 */

import { numeral } from "../words/language.js";

/** @typedef {{value: number, error: number}} Bounded */

/** What a change of the unit, and the sum with a bound, may be off in doubles, as a share of the value. */
const ROUNDING = 2 ** -51;

/** An error of so little of the last digit is only rounding. */
const NOISE = 1e-9;

/**
 * @param {Bounded|null|undefined} number
 * @param {number} decimals at most so many
 * @param {number} [unit] what one of the unit printed is in that of the number
 * @returns {string} an em dash where there is no number
 */
export function certainText(number, decimals, unit = 1) {
  return numeral(plainText(number, decimals, unit));
}

/** As certainText, with a decimal point: what a program reads. */
export function plainText(number, decimals, unit = 1) {
  if (number === null || number === undefined || !Number.isFinite(number.value)) return "—";
  const value = number.value / unit;
  const slack = number.error / unit + Math.abs(value) * ROUNDING;
  if (number.error === 0 && unit === 1) return noMinusZero(String(Number(value.toFixed(decimals))));
  for (let count = decimals; count >= 0; count--) {
    const low = noMinusZero((value - slack).toFixed(count));
    if (low === noMinusZero((value + slack).toFixed(count))) return low;
  }
  const shown = Number(value.toPrecision(3));
  return shown + " ± " + boundText((slack + Math.abs(value - shown)) * (1 + ROUNDING));
}

/** As certainText, with so many digits in all. @param {Bounded|null|undefined} number @param {number} digits */
export function certainDigits(number, digits, unit = 1) {
  if (number === null || number === undefined || !Number.isFinite(number.value)) return "—";
  const size = Math.abs(number.value / unit);
  const before = size > 0 ? Math.floor(Math.log10(size)) + 1 : 1;
  return certainText(number, Math.min(digits, Math.max(0, digits - before)), unit);
}

/** One digit, rounded up: a bound printed must not be less than the bound. @param {number} bound */
export function boundText(bound) {
  if (bound === 0) return "0";
  const power = Math.floor(Math.log10(bound));
  const digit = Math.ceil(bound / 10 ** power);
  return digit >= 10 ? "1e" + (power + 1) : digit + "e" + power;
}

/** @param {Bounded|null|undefined} angle in degrees */
export function degreesText(angle) {
  return angle === null || angle === undefined ? "—" : certainText(angle, 3) + "°";
}

/** A factor of safety, never more than the proven one. @param {Bounded|null|undefined} fos */
export function fosText(fos) {
  return numeral(roundedText(fos, 3, -1));
}

/** A factor of safety that is only bounded above, never less than its bound. @param {Bounded|null|undefined} fos */
export function fosAtMostText(fos) {
  return numeral(roundedText(fos, 3, 1));
}

/**
 * Towards one side from that end of value ± error, with no more decimals than the error leaves. An error that is only
 * rounding, a billionth of the last digit, does not move a number past the digit that it reaches (core/output/text.h).
 * @param {Bounded|null|undefined} number
 * @param {-1|1} side -1: down, 1: up
 */
function roundedText(number, decimals, side) {
  if (number === null || number === undefined || !Number.isFinite(number.value)) return "—";
  let count = decimals;
  while (count > 0 && 10 ** -count < number.error) count--;
  const place = 10 ** -count;
  if (place < number.error) return plainText(number, decimals);
  const isExact = number.error <= NOISE * place;
  const proven = number.value + side * number.error * (1 + ROUNDING);
  const end = isExact ? number.value - side * number.error : proven;
  const text = end.toFixed(count);
  const exceeds = side * (Number(text) - end) < 0;
  const rounded = exceeds ? (end + 0.6 * side * place).toFixed(count) : text;
  return number.error === 0 ? String(Number(rounded)) : noMinusZero(rounded);
}

function noMinusZero(text) {
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text;
}
