// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The text of a scene as a tree of nodes that know where they stand in it. Nothing is evaluated here and no alias is
 * followed: all scalars are text, and what they mean is the core's to say.
 */

import { parseDocument, isMap, isSeq, isScalar } from "yaml";

/** Longer texts are the core's alone: to parse them here would hold up the page. */
export const PARSED_MAX = 200_000;

/** @typedef {(string|number)[]} Path keys and, in lists, numbers from 0 */

/** The core's reader takes brackets that end at the margin; the one that finds the numbers to be dragged does not. */
function whyUnread(error) {
  if (error.code !== "BAD_INDENT") return "The text is not valid YAML yet; see its message";
  const line = error.linePos?.[0]?.line ?? 1;
  return "Brackets go on at the margin at line " + line + "; indent that line, and the scene can be dragged";
}

export class SceneText {
  /** @param {string} text */
  constructor(text) {
    this.text = text;
    /** Why there is no tree; null where there is one. @type {string|null} */
    this.unread = null;
    this.root = null;
    if (text.length > PARSED_MAX) {
      this.unread = "The scene is too long to be dragged; edit its text";
      return;
    }
    try {
      const document = parseDocument(text, { schema: "failsafe", logLevel: "silent", uniqueKeys: false });
      if (document.errors.length > 0) this.unread = whyUnread(document.errors[0]);
      else this.root = document.contents;
    } catch (error) {
      this.unread = "The text is not valid YAML yet: " + error.message;
    }
  }

  /** @param {Path} path @returns the node there, or null */
  node(path) {
    let node = this.root;
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
    const node = this.node(path);
    return isScalar(node) && typeof node.value === "string" ? node.value : null;
  }

  /** @param {Path} path @returns {number|null} how many items the list there has; null: no list */
  count(path) {
    const node = this.node(path);
    return isSeq(node) ? node.items.length : null;
  }

  /** @param {Path} path @returns {string[]|null} the keys of the map there; null: no map */
  keys(path) {
    const node = this.node(path);
    return isMap(node) ? node.items.filter((pair) => isScalar(pair.key)).map((pair) => String(pair.key.value)) : null;
  }

  /**
   * The text with other numbers in it: what stands around them, comments and layout, stays as it is.
   * @param {{path: Path, text: string}[]} numbers
   * @returns {string}
   */
  withNumbers(numbers) {
    const edits = numbers.map(({ path, text }) => this.#edit(path, text)).sort((a, b) => b.from - a.from);
    return edits.reduce((whole, { from, to, text }) => whole.slice(0, from) + text + whole.slice(to), this.text);
  }

  /** Where a scalar stands, or where one that is not there yet would. */
  #edit(path, text) {
    const node = this.node(path);
    if (isScalar(node) && node.range) return { from: node.range[0], to: node.range[1], text };
    if (node !== null) throw new RangeError(path.join(".") + " is not a number but a list or a map");
    return this.#insertion(path, text);
  }

  #insertion(path, text) {
    let depth = path.length - 1;
    while (depth > 0 && this.node(path.slice(0, depth)) === null) depth--;
    const map = depth === 0 ? this.root : this.node(path.slice(0, depth));
    if (!isMap(map)) throw new RangeError(path.slice(0, depth).join(".") + " is not a map that could take another key");
    const inner = path.slice(depth + 1).reduceRight((value, key) => "{" + key + ": " + value + "}", text);
    const pair = path[depth] + ": " + inner;
    if (map.flow) {
      const end = this.text.lastIndexOf("}", map.range[1] - 1);
      return { from: end, to: end, text: (map.items.length > 0 ? ", " : "") + pair };
    }
    const last = map.items[map.items.length - 1];
    const end = this.#lineEnd(last.value?.range?.[1] ?? last.key.range[1]);
    return { from: end, to: end, text: "\n" + " ".repeat(this.#column(last.key.range[0])) + pair };
  }

  /** The end of the line in which a character stands that ends a value, its comment included. */
  #lineEnd(offset) {
    const end = this.text.indexOf("\n", Math.max(0, offset - (this.text[offset - 1] === "\n" ? 1 : 0)));
    return end < 0 ? this.text.length : end;
  }

  #column(offset) {
    return offset - (this.text.lastIndexOf("\n", offset - 1) + 1);
  }
}
