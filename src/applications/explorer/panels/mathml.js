// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Formulas as MathML, which browsers draw themselves: no fonts, no library, and nothing that could be markup. */

import { element, mathElement } from "./element.js";
import { readExpression } from "./expression.js";

const GREEK = {
  alpha: "α", beta: "β", gamma: "γ", delta: "δ", phi: "φ", theta: "θ", lambda: "λ", mu: "μ", rho: "ρ", sigma: "σ", tau: "τ",
};

/** @param {import("./expression.js").Tree} tree @returns {Element} */
function mathOf(tree) {
  switch (tree.kind) {
    case "number": return mathElement("mn", {}, tree.text);
    case "name": return name(tree.text);
    case "call": return row(mathElement("mi", {}, tree.name), applied(tree.of));
    case "minus": return row(sign("−"), factor(tree.of));
    case "sum": return row(...tree.parts.flatMap(({ sign: text, of }, at) => [at === 0 && text === "+" ? null : sign(text === "-" ? "−" : "+"), mathOf(of)]));
    case "product": return row(...tree.parts.flatMap((part, at) => [at > 0 && part.kind === "number" ? sign("·") : null, factor(part)]));
    case "quotient": return mathElement("mfrac", {}, mathOf(tree.over), mathOf(tree.under));
    case "power": return power(tree);
    default: throw new RangeError("no formula has " + tree.kind);
  }
}

/** A numerator over a denominator as derive prints them. @param {{numerator: string, denominator: string}} quotient */
export function fraction({ numerator, denominator }) {
  const [over, under] = [numerator, denominator].map((text) => readExpression(text));
  if (over === null || under === null) return mathElement("mtext", {}, "(" + numerator + ")/(" + denominator + ")");
  return denominator === "1" ? mathOf(over) : mathElement("mfrac", {}, mathOf(over), mathOf(under));
}

/** left = right, as a formula of its own line. @param {Element[]} left @param {...Element} right */
export function equation(left, ...right) {
  return element(
    "div",
    { class: "equation wide", tabindex: 0 },
    mathElement("math", { display: "block" }, mathElement("mrow", {}, left, right.flatMap((part) => [sign("="), part]))),
  );
}

/** A name with what stands below it, as tan α_crit. @param {...string} words functions first, the last with its index */
export function symbol(...words) {
  return words.map((word, at) => {
    const [letter, index] = word.split("_");
    const one = mathElement("mi", {}, letter);
    const sub = index === undefined ? one : mathElement("msub", {}, one, mathElement("mi", {}, index));
    return at < words.length - 1 ? [sub, space()] : sub;
  });
}

/** A printed formula typeset, or as it is where it cannot be read. @param {string} text */
export function formula(text) {
  const tree = readExpression(text);
  return tree === null ? mathElement("mtext", {}, text) : mathOf(tree);
}

function power({ base, to }) {
  if (base.kind !== "call") return mathElement("msup", {}, factor(base, true), mathOf(to));
  return row(mathElement("msup", {}, mathElement("mi", {}, base.name), mathOf(to)), applied(base.of));
}

/** A function is set before a name, with a blank; before anything else, in brackets. */
function applied(of) {
  return of.kind === "name" ? row(space(), mathOf(of)) : bracketed(of);
}

function factor(tree, strict = false) {
  const loose = tree.kind === "sum" || tree.kind === "minus" || (strict && ["product", "quotient", "power"].includes(tree.kind));
  return loose ? bracketed(tree) : mathOf(tree);
}

function bracketed(tree) {
  return row(sign("("), mathOf(tree), sign(")"));
}

/** Letters before an underscore and what stands below them. */
function name(text) {
  const [letter, ...rest] = text.split("_");
  const shown = mathElement("mi", {}, Object.hasOwn(GREEK, letter) ? GREEK[letter] : letter);
  return rest.length === 0 || letter === "" ? shown : mathElement("msub", {}, shown, mathElement("mi", {}, rest.join("_")));
}

const row = (...parts) => mathElement("mrow", {}, ...parts);
const sign = (text) => mathElement("mo", {}, text);
const space = () => mathElement("mspace", { width: "0.2em" });
