// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Symbols on the screen, each a path, a text and words for the pointer. */

import { select } from "d3-selection";

/** @param layer a d3 selection @param {import("./symbols.js").Symbol[]} symbols from the back to the front */
export function drawSymbols(layer, symbols) {
  layer.selectAll("g").data(symbols)
    .join((enter) => {
      const made = enter.append("g");
      made.append("path");
      made.append("text");
      made.append("title");
      return made;
    })
    .each(function ({ kind, d, x = 0, y = 0, text = "", title }) {
      // those that stay as they are, while something is dragged, are not laid out again
      const drawn = [kind, d, x, y, text, title].join();
      if (this.drawn === drawn) return;
      this.drawn = drawn;
      const own = select(this).attr("class", "symbol " + kind);
      own.select("path").attr("d", d);
      own.select("text").attr("x", x).attr("y", y).text(text);
      own.select("title").text(title);
    });
}
