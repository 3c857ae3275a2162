// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A text as a code that a camera reads (QR), black on white whatever the page's colours are. */

import { encode } from "uqr";
import { svgElement } from "../panels/element.js";

const BORDER = 4; // dots around it, as readers need them

/** @param {string} text @returns {SVGElement|null} null: it is longer than such a code holds */
export function codeOf(text, label) {
  const dots = dotsOf(text);
  if (dots === null) return null;
  const path = dots.flatMap((row, y) => row.map((dark, x) => (dark ? "M" + x + " " + y + "h1v1h-1z" : ""))).join("");
  return svgElement("svg", { class: "code", viewBox: "0 0 " + dots.length + " " + dots.length, role: "img", "aria-label": label },
    svgElement("rect", { width: dots.length, height: dots.length, fill: "#fff" }), svgElement("path", { d: path, fill: "#000", "shape-rendering": "crispEdges" }));
}

/** @param {string} text @returns {boolean[][]|null} */
export function dotsOf(text) {
  try {
    return encode(text, { ecc: "L", border: BORDER }).data;
  } catch (error) {
    if (error instanceof RangeError || /too long/i.test(error.message)) return null;
    throw error;
  }
}
