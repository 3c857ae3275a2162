// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The value of a formula of a scene (+ - * / ^, parentheses, parameters) in doubles. It places handles on the screen
 * and nothing else: every result is the core's, which reads the formula itself, exactly.
 */

const TOKEN = /\s*(?:(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?)|([A-Za-z_]\w*)|([-+*/^()]))/y;
const DEPTH_MAX = 100;

/**
 * @param {string} text
 * @param {Map<string, number>} names
 * @returns {number|null} null: no formula, a name that is not known, or no finite number
 */
export function formulaValue(text, names) {
  const tokens = split(text);
  if (tokens === null || tokens.length === 0) return null;
  try {
    const reader = new Reader(tokens, names);
    const value = reader.sum(0);
    return reader.at === tokens.length && Number.isFinite(value) ? value : null;
  } catch (error) {
    if (error instanceof SyntaxError) return null;
    throw error;
  }
}

function split(text) {
  const tokens = [];
  const trimmed = text.trim();
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < trimmed.length) {
    const match = TOKEN.exec(trimmed);
    if (match === null) return null;
    tokens.push(match[1] !== undefined ? Number(match[1]) : match[2] ?? match[3]);
  }
  return tokens;
}

class Reader {
  constructor(tokens, names) {
    this.tokens = tokens;
    this.names = names;
    this.at = 0;
  }

  sum(depth) {
    let value = this.product(depth);
    while (this.sees("+") || this.sees("-")) {
      value = this.tokens[this.at++] === "+" ? value + this.product(depth) : value - this.product(depth);
    }
    return value;
  }

  product(depth) {
    let value = this.signed(depth);
    while (this.sees("*") || this.sees("/")) {
      value = this.tokens[this.at++] === "*" ? value * this.signed(depth) : value / this.signed(depth);
    }
    return value;
  }

  signed(depth) {
    if (depth > DEPTH_MAX) throw new SyntaxError("nested too deeply");
    if (this.sees("-")) {
      this.at++;
      return -this.signed(depth + 1);
    }
    if (this.sees("+")) this.at++;
    return this.power(depth + 1);
  }

  power(depth) {
    const base = this.atom(depth);
    if (!this.sees("^")) return base;
    this.at++;
    return base ** this.signed(depth + 1);
  }

  atom(depth) {
    const token = this.tokens[this.at++];
    if (typeof token === "number") return token;
    if (token === "(") {
      const value = this.sum(depth + 1);
      if (this.tokens[this.at++] !== ")") throw new SyntaxError("a parenthesis is open");
      return value;
    }
    if (typeof token === "string" && this.names.has(token)) return this.names.get(token);
    throw new SyntaxError("no number");
  }

  sees(sign) {
    return this.tokens[this.at] === sign;
  }
}
