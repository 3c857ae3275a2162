// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Numbers as a scene has them: decimals, kept exact. What is dragged comes as a double and goes into the scene as a
 * multiple of a step that is a power of ten, so that its digits say just what is meant.
 */

const DECIMAL = /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d{1,4})?$/;

/** @param {string} text @returns {number|null} its value as a double where it is a plain decimal */
export function decimalValue(text) {
  if (!DECIMAL.test(text.trim())) return null;
  const value = Number(text);
  return Number.isFinite(value) ? value : null;
}

/**
 * The multiple of 10^exponent that is nearest to a value, as text.
 * @param {number} value
 * @param {number} exponent between -20 and 15
 * @returns {string} without an exponent, without needless zeros
 */
export function snap(value, exponent) {
  if (exponent >= 0) {
    const step = 10 ** exponent;
    return noMinusZero(BigInt(Math.round(value / step)) * 10n ** BigInt(exponent) + "");
  }
  const text = value.toFixed(-exponent);
  return noMinusZero(text.replace(/\.?0+$/, ""));
}

function noMinusZero(text) {
  return text === "-0" ? "0" : text;
}

/**
 * The step that suits a drawing: the power of ten nearest below what some dots on the screen are.
 * @param {number} length what one dot of the screen is, in units of the scene
 * @param {number} dots how many dots a step may be at most
 * @returns {number} the exponent of ten
 */
export function stepExponent(length, dots) {
  if (!(length > 0) || !Number.isFinite(length)) return 0;
  return Math.max(-20, Math.min(15, Math.floor(Math.log10(length * dots))));
}
