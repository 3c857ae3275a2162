// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Where in a scene a key is being typed, read off the text alone: while one types, it is seldom valid YAML. Maps by
 * indentation and in braces, lists by dashes and in brackets; quoted scalars and comments are passed over.
 */

/**
 * @typedef {{path: string, keys: Set<string>, indent: number, pending: string, list?: string, inList?: boolean}} Level a map, or an item of a list:
 * its path, the keys it has, and the one whose value comes next
 */

const WORD = /[A-Za-z_]\w*$/;
const TOKEN = /"(?:[^"\\]|\\.)*"?|'(?:[^']|'')*'?|\s+#.*|[{}[\],]|:(?=\s|$)|[^\s{}[\],:"']+|\s+|./g;

const below = (path, key) => (path === "" ? key : key === "" ? path : path + "." + key);

/**
 * @param {string} text @param {number} offset
 * @returns {{path: string, from: number, keys: Set<string>, flow: boolean}|null} path of the map, as loads.anchors[]; from: where the
 *   word begins that is typed; keys: those that the map has besides it; null: no key can stand there
 */
export function keyPlace(text, offset) {
  const word = WORD.exec(text.slice(text.lastIndexOf("\n", offset - 1) + 1, offset))?.[0] ?? "";
  const from = offset - word.length;
  /** @type {Level[]} */
  const blocks = [{ path: "", keys: new Set(), indent: 0, pending: "" }];
  /** @type {Level[]} */
  const flows = [];
  let found = null;
  let at = 0;
  for (const line of text.split("\n")) {
    const end = at + line.length;
    if (flows.length === 0 && line.trim() !== "" && !line.trim().startsWith("#")) enterLine(blocks, line);
    else if (flows.length === 0 && at <= offset && offset <= end && line.trim() === "") inner(blocks, line.length);
    const here = at <= from && from <= end ? from - at : -1;
    const seen = scanLine(line, blocks, flows, here);
    if (seen !== undefined) found = seen;
    at = end + 1;
  }
  return found === null ? null : { path: found.level.path, from, flow: found.flow, keys: without(found.level.keys, found.flow || text[offset] === ":" ? "" : word) };
}

/** What is typed may look like a key of its own: it is none. */
function without(keys, word) {
  return new Set([...keys].filter((key) => key !== word));
}

function leaveTo(blocks, indent) {
  while (blocks.length > 1 && blocks[blocks.length - 1].indent > indent) blocks.pop();
}

/** The map whose keys stand at an indentation: it may begin there. */
function inner(blocks, indent) {
  leaveTo(blocks, indent);
  // dashes may stand at the margin of their key: what stands there without one is a key beside it
  if (blocks[blocks.length - 1].list !== undefined && blocks[blocks.length - 1].indent === indent) blocks.pop();
  const top = blocks[blocks.length - 1];
  if (top.indent < indent) blocks.push({ path: below(top.path, top.pending), keys: new Set(), indent, pending: "" });
}

/** A line begins: which map or item it belongs to. */
function enterLine(blocks, line) {
  let indent = /^ */.exec(line)[0].length;
  let rest = line.slice(indent);
  for (let dash = /^-\s+|^-$/.exec(rest); dash !== null; dash = /^-\s+|^-$/.exec(rest)) {
    leaveTo(blocks, indent);
    const top = blocks[blocks.length - 1];
    // a list of a key may stand at the margin of that key itself
    const isNext = top.indent === indent && top.list !== undefined;
    const list = isNext ? top.list : below(top.path, top.pending);
    if (isNext) blocks.pop();
    blocks.push({ path: list + "[]", list, keys: new Set(), indent, pending: "" });
    indent += dash[0].length;
    rest = rest.slice(dash[0].length);
    blocks.push({ path: list + "[]", keys: new Set(), indent, pending: "" });
  }
  inner(blocks, indent);
}

/** @param {number} here where the word begins that is typed, or -1 @returns {{level: Level, flow: boolean}|null|undefined} undefined: not in this line */
function scanLine(line, blocks, flows, here) {
  let last = "";
  let fresh = true; // a key may stand here
  let found;
  const base = () => flows[flows.length - 1] ?? blocks[blocks.length - 1];
  const look = (at) => {
    if (found !== undefined || here < 0 || at < here) return;
    const level = base();
    found = fresh && !level.inList ? { level, flow: flows.length > 0 } : null;
  };
  const start = /^(?: *-\s+)* */.exec(line)[0].length;
  if (here >= 0 && here < start && flows.length === 0) found = here === /^ */.exec(line)[0].length ? { level: base(), flow: false } : null;
  TOKEN.lastIndex = start;
  for (let match = TOKEN.exec(line); match !== null; match = TOKEN.exec(line)) {
    const token = match[0];
    if (token.trim() !== "") look(match.index);
    const level = base();
    if (/^\s+#/.test(token)) {
      if (here > match.index) found = null;
      break;
    } else if (token === "{" || token === "[") {
      const path = level.inList ? level.path : below(level.path, level.pending);
      flows.push({ path: token === "[" ? path + "[]" : path, keys: new Set(), indent: 0, pending: "", inList: token === "[" });
      fresh = token === "{";
    } else if (token === "}" || token === "]") {
      flows.pop();
      fresh = false;
    } else if (token === ",") {
      fresh = flows.length > 0;
    } else if (token === ":") {
      level.pending = last;
      level.keys.add(last);
      fresh = false;
    } else if (token.trim() !== "") {
      last = token.replace(/^["']|["']$/g, "");
      fresh = false;
    }
  }
  look(line.length);
  return found;
}
