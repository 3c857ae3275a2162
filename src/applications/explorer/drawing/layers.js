// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The groups of the drawing, from the back to the front. What lies in the frame is in metres, which the view turns and
 * scales; the others are in dots of the screen.
 * @param svg a d3 selection @returns {Record<string, object>} d3 selections, by name
 */
export function layersOf(svg) {
  const frame = svg.append("g").attr("class", "frame");
  const layers = {
    frame,
    photo: frame.append("image").attr("class", "photo-behind").attr("preserveAspectRatio", "none").attr("display", "none"),
    still: frame.append("g"),
    water: frame.append("path").attr("class", "shape water"),
    moving: frame.append("g").append("g").attr("class", "moving"),
    front: frame.append("g").attr("class", "contact"),
    touch: frame.append("g"),
    preview: frame.append("path").attr("class", "shape preview"),
    arc: svg.append("g").attr("class", "arc"),
    scale: svg.append("g").attr("class", "scale").attr("aria-hidden", "true"),
    symbols: svg.append("g").attr("class", "symbols"),
    handles: svg.append("g").attr("class", "handles"),
    note: svg.append("text").attr("class", "note"),
  };
  for (const name of ["arc", "scale"]) {
    layers[name].append("path");
    layers[name].append("text");
  }
  return layers;
}

const NOTE_LETTER = 8; // dots of a letter, at most of most
const NOTE_LINE = 18;

/** At the upper edge: beside the badge, or below it. @param note a d3 selection @param {import("./view.js").View} view @param {string} words */
export function putNote(note, view, words) {
  note.attr("y", view.top > 0 ? view.top + 38 : 20).selectAll("tspan").data(broken(words, Math.floor((view.width - 20) / NOTE_LETTER))).join("tspan")
    .attr("x", view.width - 10).attr("dy", (line, at) => (at === 0 ? 0 : NOTE_LINE)).text((line) => line);
}

/** Lines of so many letters at most, but for a longer word. @param {string} words @param {number} letters @returns {string[]} */
export function broken(words, letters) {
  return words.split(" ").filter((word) => word !== "").reduce((lines, word) => {
    const longer = lines.length === 0 ? word : lines[lines.length - 1] + " " + word;
    return lines.length > 0 && longer.length <= letters ? [...lines.slice(0, -1), longer] : [...lines, word];
  }, []);
}

/** What no shape is, taken away. @param {Record<string, object>} layers */
export function emptied(layers) {
  for (const path of [layers.water, layers.preview, layers.arc.select("path"), layers.scale.select("path")]) path.attr("d", "");
  for (const name of ["arc", "scale"]) layers[name].select("text").text("");
  layers.symbols.selectAll("g").remove();
}
