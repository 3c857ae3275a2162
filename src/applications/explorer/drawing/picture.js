// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Of many blocks the core's own figure is the drawing: as a picture, which is moved and brought closer like any other. */

const BADGE = 100; // dots at the upper edge, for the verdict

export class Picture {
  #of = null; // whose bytes it shows
  #address = null;

  /** @param svg a d3 selection, at whose back it lies */
  constructor(svg) {
    this.image = svg.insert("image", ":first-child").attr("class", "picture").attr("role", "img").attr("display", "none");
  }

  /** @param {Uint8Array|null} bytes of an SVG; null: none @param {import("./view.js").View} view @param {string} words what it shows */
  put(bytes, view, words) {
    if (bytes !== this.#of) {
      URL.revokeObjectURL(this.#address);
      this.#of = bytes;
      this.#address = bytes === null ? null : URL.createObjectURL(new Blob([bytes], { type: "image/svg+xml" }));
      this.image.attr("href", this.#address).attr("display", bytes === null ? "none" : null);
    }
    if (bytes === null) return;
    const { k, x, y } = view.zoom;
    this.image.attr("aria-label", words).attr("y", BADGE).attr("width", view.width).attr("height", Math.max(0, view.height - BADGE))
      .attr("transform", "translate(" + x + " " + y + ") scale(" + k + ")");
  }
}
