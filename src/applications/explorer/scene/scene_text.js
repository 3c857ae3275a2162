// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The text of a scene as a tree of nodes that know where they stand in it. Nothing is evaluated here and no alias is
 * followed: all scalars are text, and what they mean is the core's to say.
 */

import { decimalValue } from "./decimal.js";
import { parseDocument, isAlias, isMap, isSeq, isScalar } from "yaml";
import { say } from "../words/language.js";

/** Longer texts are the core's alone: to parse them here would hold up the page. */
export const PARSED_MAX = 200_000;

/** @typedef {(string|number)[]} Path keys and, in lists, numbers from 0 */

/** The core's reader takes brackets that end at the margin; the one that finds the numbers to be dragged does not. */
function whyUnread(error) {
  if (error.code !== "BAD_INDENT") return say("The text is not valid YAML yet; see its message");
  const line = error.linePos?.[0]?.line ?? 1;
  return say("Brackets go on at the margin at line %s; indent that line, and the scene can be dragged", line);
}

/** @param {string} text @param {{from: number, to: number, text: string}[]} edits from the last one to the first */
function applied(text, edits) {
  return edits.reduce((whole, edit) => whole.slice(0, edit.from) + edit.text + whole.slice(edit.to), text);
}

/**
 * Where nodes stand once scalars have other lengths.
 * @param {Map<object, number>} grown scalars of the tree, and by how many letters each is longer
 */
function shiftRanges(node, grown) {
  if (isMap(node)) {
    for (const { key, value } of node.items) for (const each of [key, value]) shiftRanges(each, grown);
  } else if (isSeq(node)) {
    for (const each of node.items) shiftRanges(each, grown);
  }
  if (node?.range) node.range = node.range.map((at) => shifted(at, grown));
}

/** @param {number} at a place of the text that was read, at the edge of a node */
function shifted(at, grown) {
  let sum = at;
  for (const [{ range }, letters] of grown) if (range[1] <= at) sum += letters;
  return sum;
}

/** Lists of points with other numbers in them. @param {Map<string, {x: number, y: number}[]|null>} lists @param {{path: Path, text: string}[]} numbers */
function movedPoints(lists, numbers) {
  for (const { path, text } of numbers) {
    const list = path.slice(0, -2).join(".");
    const points = lists.get(list) ?? null;
    const [index, axis] = path.slice(-2);
    if (points !== null) lists.set(list, points.map((point, i) => (i === index ? { ...point, ["xy"[axis]]: decimalValue(text) } : point)));
  }
  return lists;
}

/** So many scalars grow before the tree is gone through for all that stands behind them. */
const GROWN_MAX = 32;

export class SceneText {
  #root;
  /** The title as it is written, where there is no tree; "": none. @type {string|null} */
  #written = null;
  /** Scalars that have grown since the tree's ranges were true, and by how many letters. @type {Map<object, number>} */
  #grown;
  /** Lists of points that were asked for, their numbers as doubles, by their path. @type {Map<string, {x: number, y: number}[]|null>} */
  #decimals;

  /** @param {string} text @param {{root: object, grown: Map, decimals: Map}|null} [known] its tree, and what was found in it */
  constructor(text, known = null) {
    this.text = text;
    /** Why there is no tree; null where there is one. @type {string|null} */
    this.unread = null;
    this.#root = known?.root ?? null;
    this.#grown = known?.grown ?? new Map();
    this.#decimals = known?.decimals ?? new Map();
    if (known !== null) return;
    if (text.length > PARSED_MAX) {
      this.unread = say("The scene is too long to be dragged; edit its text");
      return;
    }
    try {
      const document = parseDocument(text, { schema: "failsafe", logLevel: "silent", uniqueKeys: false });
      if (document.errors.length > 0) this.unread = whyUnread(document.errors[0]);
      else this.#root = document.contents;
    } catch (error) {
      this.unread = say("The text is not valid YAML yet: %s", error.message);
    }
  }

  /** The tree, whose nodes know where they stand. */
  get root() {
    this.#settle();
    return this.#root;
  }

  #settle() {
    if (this.#grown.size === 0) return;
    // their ranges of before, as each node gets a new one
    shiftRanges(this.#root, new Map([...this.#grown].map(([{ range }, letters]) => [{ range }, letters])));
    this.#grown.clear();
  }

  /** @param {Path} path whether something stands there */
  has(path) {
    return this.#at(path) !== null;
  }

  /** @param {Path} path @returns the node there, which knows where it stands, or null */
  node(path) {
    return this.root === null ? null : this.#at(path);
  }

  /** The same, where its place is not asked for. */
  #at(path) {
    let node = this.#root;
    for (const key of path) {
      if (isMap(node)) node = node.items.find((pair) => isScalar(pair.key) && pair.key.value === String(key))?.value;
      else if (isSeq(node) && typeof key === "number") node = node.items[key];
      else return null;
      if (node === undefined || node === null) return null;
    }
    return node;
  }

  /** @param {Path} path @returns {string|null} the text of the scalar there */
  scalar(path) {
    const node = this.#at(path);
    return isScalar(node) && typeof node.value === "string" ? node.value : null;
  }

  /** The title of the scene, also where the text is no tree, or not yet. @returns {string|null} */
  get title() {
    if (this.#root !== null) return this.scalar(["title"]);
    // long texts have no tree: they are looked through once
    this.#written ??= /^title: *["']?(.*?)["']?$/m.exec(this.text)?.[1] ?? "";
    return this.#written === "" ? null : this.#written;
  }

  /** @param {Path} path @returns {string|null} why no number can be put there; null: one can */
  whyNoNumber(path) {
    for (let depth = path.length; depth > 0; depth--) {
      const node = this.#at(path.slice(0, depth));
      if (node === null) continue;
      if (isAlias(node)) return say("is the alias *%s; change what it stands for in the text", node.source);
      if (depth === path.length) return isScalar(node) ? null : say("is a list or a map; change it in the text");
      return isMap(node) ? null : say("has no place: %s is no map of keys; change it in the text", path.slice(0, depth).join("."));
    }
    return isMap(this.#root) ? null : say("has no place in this text");
  }

  /** @param {Path} path @returns {number|null} how many items the list there has; null: no list */
  count(path) {
    const node = this.#at(path);
    return isSeq(node) ? node.items.length : null;
  }

  /** @param {Path} path @returns {string[]|null} the keys of the map there; null: no map */
  keys(path) {
    const node = this.#at(path);
    return isMap(node) ? node.items.filter((pair) => isScalar(pair.key)).map((pair) => String(pair.key.value)) : null;
  }

  /** @param {Path} path of a list of points @returns {[string|null, string|null][]} the texts of their two numbers */
  points(path) {
    const node = this.#at(path);
    if (!isSeq(node)) return [];
    const textOf = (scalar) => (isScalar(scalar) && typeof scalar.value === "string" ? scalar.value : null);
    return node.items.map((point) => (isSeq(point) ? [textOf(point.items[0]), textOf(point.items[1])] : [null, null]));
  }

  /**
   * The points of a list whose numbers are all plain decimals: thousands of them, in each frame of a drag.
   * @param {Path} path @returns {{x: number, y: number}[]|null} null: some are not, or it is no list
   */
  decimals(path) {
    const key = path.join(".");
    if (!this.#decimals.has(key)) {
      const read = (text) => (text === null ? null : decimalValue(text));
      const points = this.points(path).map(([x, y]) => ({ x: read(x), y: read(y) }));
      this.#decimals.set(key, points.length === 0 || points.some(({ x, y }) => x === null || y === null) ? null : points);
    }
    return this.#decimals.get(key);
  }

  /**
   * The text with other numbers in it: what stands around them, comments and layout, stays as it is.
   * @param {{path: Path, text: string}[]} numbers
   * @returns {string}
   */
  withNumbers(numbers) {
    return applied(this.text, this.#edits(numbers));
  }

  /**
   * The same, as a tree. Where numbers take the places of numbers, it takes this tree over, which is then no more to be used:
   * to read thousands of vertices anew for each that is dragged would cost the drawing its frames.
   * @param {{path: Path, text: string}[]} numbers @returns {SceneText}
   */
  movedTo(numbers) {
    const edits = this.#edits(numbers);
    const text = applied(this.text, edits);
    const isMove = edits.every(({ from, to, scalar, text: number }) => scalar !== null && from < to && decimalValue(number) !== null);
    if (this.#root === null || !isMove || text.length > PARSED_MAX) return new SceneText(text);
    for (const { from, to, scalar, text: number } of edits) {
      this.#grown.set(scalar, (this.#grown.get(scalar) ?? 0) + number.length - (to - from));
      scalar.value = number;
    }
    const moved = new SceneText(text, { root: this.#root, grown: this.#grown, decimals: movedPoints(this.#decimals, numbers) });
    if (this.#grown.size > GROWN_MAX) moved.#settle();
    return moved;
  }

  /** From the last one in the text to the first. */
  #edits(numbers) {
    return numbers.map(({ path, text }) => this.#edit(path, text)).sort((a, b) => b.from - a.from);
  }

  /** Where a scalar stands, or where one that is not there yet would. */
  #edit(path, text) {
    const node = this.#at(path);
    if (isScalar(node) && node.range) {
      const [from, to] = node.range.map((at) => shifted(at, this.#grown));
      return { from, to, text, scalar: node };
    }
    if (node !== null) throw new RangeError(say("%s is not a number but a list or a map", path.join(".")));
    return this.#insertion(path, text);
  }

  #insertion(path, text) {
    this.#settle();
    let depth = path.length - 1;
    while (depth > 0 && this.#at(path.slice(0, depth)) === null) depth--;
    const map = depth === 0 ? this.root : this.#at(path.slice(0, depth));
    if (!isMap(map)) throw new RangeError(say("%s is not a map that could take another key", path.slice(0, depth).join(".")));
    const inner = path.slice(depth + 1).reduceRight((value, key) => "{" + key + ": " + value + "}", text);
    const pair = path[depth] + ": " + inner;
    const last = map.items[map.items.length - 1];
    const lastEnd = last === undefined ? null : (last.value?.range?.[1] ?? last.key.range[1]);
    if (map.flow) {
      const end = this.text.lastIndexOf("}", map.range[1] - 1);
      return { from: end, to: end, text: this.#separator(lastEnd, end) + pair, scalar: null };
    }
    const end = this.#lineEnd(lastEnd);
    const newLine = this.text[end] === "\r" ? "\r\n" : "\n";
    return { from: end, to: end, text: newLine + " ".repeat(this.#column(last.key.range[0])) + pair, scalar: null };
  }

  /** What goes before one more pair in braces, where a comma may stand already behind the last one. */
  #separator(lastEnd, end) {
    if (lastEnd === null) return "";
    const between = this.text.slice(lastEnd, end).replace(/#.*/g, "");
    return !between.includes(",") ? ", " : /\s$/.test(between) ? "" : " ";
  }

  /** The end of the line in which a character stands that ends a value, its comment included; before a \r that ends it. */
  #lineEnd(offset) {
    const end = this.text.indexOf("\n", Math.max(0, offset - (this.text[offset - 1] === "\n" ? 1 : 0)));
    if (end < 0) return this.text.length;
    return this.text[end - 1] === "\r" ? end - 1 : end;
  }

  #column(offset) {
    return offset - (this.text.lastIndexOf("\n", offset - 1) + 1);
  }
}
