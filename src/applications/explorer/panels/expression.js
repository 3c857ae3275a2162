// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Formulas as `derive` and `verify` print them: sums, products, quotients and powers of numbers, names and functions.
 * Read into a tree, from which come MathML and, in doubles, a value: what is certain is the core's, this follows sliders.
 *
 * @typedef {{kind: "number", text: string}|{kind: "name", text: string}|{kind: "call", name: string, of: Tree}|
 *   {kind: "minus", of: Tree}|{kind: "sum", parts: {sign: string, of: Tree}[]}|{kind: "product", parts: Tree[]}|
 *   {kind: "quotient", over: Tree, under: Tree}|{kind: "power", base: Tree, to: Tree}} Tree
 */

const TOKEN = /\s*(?:(\d+\.?\d*)|([\p{L}_][\p{L}\p{N}_]*)|([-+*/^()]))/uy;
const DEPTH_MAX = 200;
const RADIANS = Math.PI / 180;

/** @param {string} text @returns {Tree|null} null: no formula of this kind */
export function readExpression(text) {
  const tokens = split(text.trim());
  if (tokens === null || tokens.length === 0) return null;
  try {
    const reader = new Reader(tokens);
    const tree = reader.sum(0);
    return reader.at === tokens.length ? tree : null;
  } catch (error) {
    if (error instanceof SyntaxError) return null;
    throw error;
  }
}

function split(text) {
  const tokens = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const match = TOKEN.exec(text);
    if (match === null) return null;
    if (match[1] !== undefined) tokens.push({ kind: "number", text: match[1] });
    else if (match[2] !== undefined) tokens.push({ kind: "name", text: match[2] });
    else tokens.push({ kind: "sign", text: match[3] });
  }
  return tokens;
}

class Reader {
  constructor(tokens) {
    this.tokens = tokens;
    this.at = 0;
  }

  sum(depth) {
    if (depth > DEPTH_MAX) throw new SyntaxError("nested too deeply");
    const parts = [{ sign: "+", of: this.product(depth) }];
    while (this.sees("+") || this.sees("-")) parts.push({ sign: this.take().text, of: this.product(depth) });
    return parts.length === 1 ? parts[0].of : { kind: "sum", parts };
  }

  product(depth) {
    let parts = [this.signed(depth)];
    while (this.sees("*") || this.sees("/")) {
      const sign = this.take().text;
      const next = this.signed(depth);
      if (sign === "*") parts.push(next);
      else parts = [{ kind: "quotient", over: joined(parts), under: next }];
    }
    return joined(parts);
  }

  signed(depth) {
    if (!this.sees("-")) return this.power(depth);
    this.take();
    if (depth > DEPTH_MAX) throw new SyntaxError("nested too deeply");
    return { kind: "minus", of: this.signed(depth + 1) };
  }

  power(depth) {
    const base = this.atom(depth);
    if (!this.sees("^")) return base;
    this.take();
    return { kind: "power", base, to: this.signed(depth + 1) };
  }

  atom(depth) {
    const token = this.take();
    if (token === undefined) throw new SyntaxError("ends too early");
    if (token.kind === "number") return token;
    if (token.kind === "name" && this.sees("(")) return { kind: "call", name: token.text, of: this.bracket(depth) };
    if (token.kind === "name") return token;
    if (token.text !== "(") throw new SyntaxError("no number, name or bracket");
    this.at--;
    return this.bracket(depth);
  }

  bracket(depth) {
    this.take();
    const inner = this.sum(depth + 1);
    if (this.take()?.text !== ")") throw new SyntaxError("a bracket is open");
    return inner;
  }

  sees(sign) {
    return this.tokens[this.at]?.text === sign;
  }

  take() {
    return this.tokens[this.at++];
  }
}

function joined(parts) {
  return parts.length === 1 ? parts[0] : { kind: "product", parts };
}

const FUNCTIONS = {
  tan: (angle) => Math.tan(angle * RADIANS),
  sin: (angle) => Math.sin(angle * RADIANS),
  cos: (angle) => Math.cos(angle * RADIANS),
  cot: (angle) => 1 / Math.tan(angle * RADIANS),
  atan: (tangent) => Math.atan(tangent) / RADIANS,
  sqrt: Math.sqrt,
};

/** In doubles, angles in degrees. @param {Tree} tree @param {Map<string, number>} names @returns {number} NaN: it has none */
export function valueOf(tree, names) {
  const value = (part) => valueOf(part, names);
  switch (tree.kind) {
    case "number": return Number(tree.text);
    case "name": return names.get(tree.text) ?? NaN;
    case "call": return Object.hasOwn(FUNCTIONS, tree.name) ? FUNCTIONS[tree.name](value(tree.of)) : NaN;
    case "minus": return -value(tree.of);
    case "sum": return tree.parts.reduce((total, { sign, of }) => (sign === "-" ? total - value(of) : total + value(of)), 0);
    case "product": return tree.parts.reduce((total, part) => total * value(part), 1);
    case "quotient": return value(tree.over) / value(tree.under);
    case "power": return value(tree.base) ** value(tree.to);
    default: return NaN;
  }
}
