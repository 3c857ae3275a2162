// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A scene in another unit of length, with the block as it is: every length of it is another number. Digits stay exact where the
 * factor is a decimal (all metric ones, feet to metres); what would have no end, as a metre in feet, stands as a product.
 */

import { isAlias, isMap, isScalar, isSeq } from "yaml";
import { decimalValue } from "./decimal.js";
import { formulaValue } from "./formula.js";
import { parameterValues } from "./quantity.js";
import { say } from "../words/language.js";

/** Metres in each unit, as quotients of whole numbers, exact by definition. @type {Record<string, [bigint, bigint]>} */
export const UNITS = { mm: [1n, 1000n], cm: [1n, 100n], m: [1n, 1n], km: [1000n, 1n], in: [254n, 10000n], ft: [3048n, 10000n] };

const NAME = /^[A-Za-z_]\w*$/;
/** What stands for points elsewhere: a name of a file. */
const POINTS = ["outline", "profile", "surface", "line"];

/**
 * @param {import("./scene_text.js").SceneText} scene @param {string} unit that it is to have
 * @param {(path: string) => boolean} isLength of the table of keys
 * @returns {string} its text @throws {RangeError} a length is no number that can be changed here
 */
export function inUnit(scene, unit, isLength) {
  const before = scene.scalar(["length_unit"]);
  if (!Object.hasOwn(UNITS, before ?? "") || scene.root === null) throw new RangeError(say("the scene has no length_unit that is known"));
  if (["drawing", "solid"].some((key) => scene.has([key]))) throw new RangeError(say("its lengths stand in a file with a unit of its own"));
  const factor = quotient(UNITS[before], UNITS[unit]);
  const lengths = lengthsIn(scene, isLength);
  const edits = [{ path: ["length_unit"], text: unit }, ...lengths.map(({ path, text }) => ({ path, text: times(text, factor) }))];
  return scene.withNumbers(edits);
}

/** @returns {[bigint, bigint]} */
function quotient([a, b], [c, d]) {
  const [over, under] = [a * d, b * c];
  const common = divisor(over, under);
  return [over / common, under / common];
}

function divisor(a, b) {
  return b === 0n ? a : divisor(b, a % b);
}

/** Each decimal that is a length: those at their places, and parameters that lengths are by name. */
function lengthsIn(scene, isLength) {
  const values = parameterValues(scene);
  const found = [];
  const parameters = new Set();
  const others = [];
  walk(scene.root, [], "", (node, path, key) => {
    if (path[0] === "parameters") return;
    const text = String(node.value).trim();
    if (!isLength(key)) others.push(text);
    else if (decimalValue(text) !== null) found.push({ path, text });
    else if (NAME.test(text) && decimalValue(scene.scalar(["parameters", text]) ?? "") !== null) parameters.add(text);
    else if (formulaValue(text, values) !== null) throw new RangeError(say("%s is the formula %s: change its numbers in the text", path.join("."), text));
    else if (POINTS.includes(path[path.length - 1]) && !NAME.test(text)) throw new RangeError(say("%s stands in the file %s, whose numbers would have to change, too", path.join("."), text));
  });
  for (const name of parameters) {
    if (others.some((text) => new RegExp("(?<!\\w)" + name + "(?!\\w)").test(text))) throw new RangeError(say("the parameter %s is a length and another number, too: change them in the text", name));
    found.push({ path: ["parameters", name], text: scene.scalar(["parameters", name]) });
  }
  for (const name of scene.keys(["parameters"]) ?? []) {
    const text = scene.scalar(["parameters", name]) ?? "";
    if (decimalValue(text) === null) throw new RangeError(say("%s is the formula %s: change its numbers in the text", "parameters." + name, text));
  }
  return found;
}

/** Every scalar below a node, with its path, and the path as the table of keys has it. Keys of `set` are paths themselves. */
function walk(node, path, key, see) {
  if (isMap(node)) {
    for (const pair of node.items) {
      const name = String(pair.key.value);
      walk(pair.value, [...path, name], key.endsWith(".set") ? name.replace(/\[\d+\]/g, "[]") : key === "" ? name : key + "." + name, see);
    }
  } else if (isSeq(node)) node.items.forEach((item, at) => walk(item, [...path, at], key + "[]", see));
  else if (isAlias(node)) throw new RangeError(say("%s is the alias *%s: change what it stands for in the text", path.join("."), node.source));
  else if (isScalar(node)) see(node, path, key);
}

/** A decimal times a quotient: a decimal where that ends, else written as the product. @param {string} text @param {[bigint, bigint]} factor */
export function times(text, [over, under]) {
  const [, sign, whole, part = "", power = "0"] = /^([-+]?)(\d*)\.?(\d*)(?:[eE]([-+]?\d+))?$/.exec(text.trim());
  let [digits, exponent, left] = [BigInt(whole + part) * over, Number(power) - part.length, under];
  const common = divisor(digits, left);
  [digits, left] = [digits / common, left / common];
  for (const prime of [2n, 5n]) {
    for (; left % prime === 0n; left /= prime, exponent--) digits *= 10n / prime;
  }
  return left === 1n ? (sign === "-" && digits !== 0n ? "-" : "") + plainDecimal(digits, exponent) : text.trim() + "*" + over + "/" + under;
}

/** Without an exponent and needless zeros. @param {bigint} digits @param {number} exponent */
function plainDecimal(digits, exponent) {
  if (exponent >= 0) return digits === 0n ? "0" : digits + "0".repeat(exponent);
  const all = String(digits).padStart(1 - exponent, "0");
  return (all.slice(0, exponent) + "." + all.slice(exponent)).replace(/\.?0+$/, "");
}
