// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Elements of the page. Text always goes in as text: nothing that a scene says is ever read as markup. */

import { say } from "../words/language.js";

const SVG = "http://www.w3.org/2000/svg";
const MATHML = "http://www.w3.org/1998/Math/MathML";

/** @typedef {Node|string|number|null|undefined|Child[]} Child */

/**
 * @param {string} tag
 * @param {Record<string, any>} [attributes] a function stands for a listener, as onclick; true for an attribute alone
 * @param {...Child} children
 */
export function element(tag, attributes = {}, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

/** @param {string} tag @param {Record<string, any>} [attributes] @param {...Child} children */
export function svgElement(tag, attributes = {}, ...children) {
  return filled(document.createElementNS(SVG, tag), attributes, children);
}

/** @param {string} tag @param {Record<string, any>} [attributes] @param {...Child} children */
export function mathElement(tag, attributes = {}, ...children) {
  return filled(document.createElementNS(MATHML, tag), attributes, children);
}

/** What stands in a node goes, and these come. @param {Element} node @param {...Child} children */
export function refill(node, ...children) {
  node.replaceChildren();
  append(node, children);
}

/** A Greek α with its index, as in α_s. @param {string} index */
export function alpha(index) {
  return ["α", element("sub", {}, index)];
}

function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) node.setAttribute(name, name === "aria-label" ? say(String(value)) : String(value));
  }
  append(node, children);
  return node;
}

function append(node, children) {
  for (const child of children) {
    if (Array.isArray(child)) append(node, child);
    else if (child !== null && child !== undefined) node.append(child instanceof Node ? child : String(child));
  }
}

/**
 * A table with its caption for those who cannot see where it stands.
 * @param {string} caption
 * @param {Child[]} heads
 * @param {{cells: Child[], marked?: boolean}[]} rows
 */
export function table(caption, heads, rows) {
  return element(
    "div",
    { class: "wide", tabindex: 0, role: "region", "aria-label": caption },
    element(
      "table",
      {},
      element("caption", { class: "unseen" }, caption),
      element("thead", {}, element("tr", {}, heads.map((head) => (head === "" ? element("td", {}) : element("th", { scope: "col" }, head))))),
      element(
        "tbody",
        {},
        rows.map(({ cells, marked }) =>
          element("tr", marked ? { class: "governs" } : {}, cells.map((cell) => element("td", {}, cell))),
        ),
      ),
    ),
  );
}
