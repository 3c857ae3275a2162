// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The block on its base, to scale and tilted, drawn from the core's answer, with handles that change the scene. While
 * there is no answer for the present text, the last one stays, greyed, and the dragged shape is drawn over it.
 *
 * Events: "told" (.words says what a handle or a symbol is).
 */

import { select } from "d3-selection";
import { zoom, zoomIdentity } from "d3-zoom";
import { stepExponent } from "../scene/decimal.js";
import { Context } from "./handle.js";
import { View } from "./view.js";
import { waterPath } from "./water.js";
import { drawShapes, isDrawable, reachOf, shapesOf } from "./shapes.js";
import { nearPath } from "./thin_path.js";
import { symbolsOf } from "./symbols.js";
import { previewPath } from "./preview.js";
import { HandlesLayer } from "./handles_layer.js";
import { handlesOf } from "./handles.js";
import { tiltArc } from "./tilt_handle.js";
import { Motion, motionOf } from "./motion.js";
import { resultPoint } from "./result_point.js";

const SNAP_DOTS = 3;
const OTHER_SIZE = 2.5;
const CENTRE_NEAR = 0.6; // of the block's size
const ZOOM_MAX = 1e6;

export class Drawing extends EventTarget {
  #fitted = -1; // which of the scenes that were opened the window was fitted to
  #box = null; // what it was fitted to, metres from the origin
  #drawn = null; // of which answer the paths are
  #waits = null;
  #editing = false;
  #byHand = false; // the present text came from a handle

  /** @param {HTMLElement} element @param {import("../scene/store.js").SceneStore} store */
  constructor(element, store) {
    super();
    this.store = store;
    this.view = new View();
    this.caseIndex = 0;
    this.words = "";
    this.origin = { x: 0, y: 0 };
    this.context = null;
    this.svg = select(element).append("svg").attr("class", "drawing").attr("role", "group").attr("aria-label", "Drawing of the block on its base");
    this.#layers();
    this.zooming = zoom().scaleExtent([0.05, ZOOM_MAX]).filter((event) => this.#zooms(event)).on("zoom", (event) => this.#zoomed(event.transform));
    this.svg.call(this.zooming).on("dblclick.zoom", null);
    this.handles = new HandlesLayer(this.layers.handles, this.view, {
      edit: (handle, edits) => this.#edit(handle, edits),
      ended: () => store.endGesture(),
      exponent: () => this.exponent,
      told: (words) => this.#tell(words),
    });
    this.motion = new Motion(() => this.#motion(), (transform) => this.layers.moving.attr("transform", transform));
    store.addEventListener("text", () => {
      this.#byHand = this.#editing;
      this.#later();
    });
    store.addEventListener("solution", () => this.#later());
    store.addEventListener("problem", () => this.#later());
    new ResizeObserver(() => this.#resized(element)).observe(element);
  }

  /** The step of dragged numbers, as an exponent of ten in the scene's unit. */
  get exponent() {
    const unit = this.context?.metres ?? 1;
    return stepExponent(1 / (this.view.dotsPerMetre * unit), SNAP_DOTS);
  }

  get case() {
    const cases = this.store.lastSolution?.cases ?? [];
    return cases[Math.min(this.caseIndex, cases.length - 1)] ?? null;
  }

  /** Which of the cases is drawn, where the scene tilts both ways. @param {number} index */
  showCase(index) {
    this.caseIndex = index;
    this.#draw();
  }

  /** All of the block into the window. */
  fit() {
    this.#fitted = -1;
    this.svg.call(this.zooming.transform, zoomIdentity);
    this.#draw();
  }

  /** @param {number} factor @param {number} [dx] @param {number} [dy] a share of the window to move by */
  zoomBy(factor, dx = 0, dy = 0) {
    if (factor !== 1) this.svg.call(this.zooming.scaleBy, factor);
    if (dx !== 0 || dy !== 0) this.svg.call(this.zooming.translateBy, (dx * this.view.width) / this.view.zoom.k, (dy * this.view.height) / this.view.zoom.k);
  }

  #layers() {
    const frame = this.svg.append("g").attr("class", "frame");
    this.frame = frame;
    this.layers = {
      still: frame.append("g"),
      water: frame.append("path").attr("class", "shape water"),
      moving: frame.append("g").append("g").attr("class", "moving"),
      front: frame.append("g"),
      preview: frame.append("path").attr("class", "shape preview"),
      arc: this.svg.append("g").attr("class", "arc"),
      symbols: this.svg.append("g").attr("class", "symbols"),
      handles: this.svg.append("g").attr("class", "handles"),
    };
    this.layers.arc.append("path");
    this.layers.arc.append("text");
    this.layers.note = this.svg.append("text").attr("class", "note").attr("x", 10).attr("y", 20);
  }

  /** Several changes within a frame are drawn once. */
  #later() {
    if (this.#waits !== null) return;
    this.#waits = requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    cancelAnimationFrame(this.#waits);
    this.#waits = null;
    const { store } = this;
    const answer = store.lastSolution;
    const kase = this.case;
    const stale = store.solution === null;
    this.svg.classed("stale", stale && store.problem !== null);
    this.context = null;
    if (answer?.outlines === undefined || kase === null) return;
    const { outlines } = answer;
    if (!isDrawable(outlines)) {
      this.#leaveOut();
      return;
    }
    this.#fitOnce(outlines);
    this.context = new Context(store.parsed, kase, outlines, this.origin);
    this.view.turn = this.#turn();
    this.#drawShapes(outlines);
    this.#drawPreview(stale);
    this.#place();
  }

  /** Nothing of the scene, and why. */
  #leaveOut() {
    const { layers } = this;
    this.#drawn = null;
    this.#fitted = -1;
    drawShapes(layers, []);
    for (const path of [layers.water, layers.preview]) path.attr("d", "");
    layers.symbols.selectAll("g").remove();
    this.handles.set([]);
    layers.note.text("No browser can draw a block of this size; its numbers stand beside this");
  }

  /** A scene that was opened is fitted once, and one that was typed where it is of another size; dragged, it stays. */
  #fitOnce(outlines) {
    const opened = this.#fitted !== this.store.openings;
    if (this.store.solution === null || (!opened && (this.#byHand || !this.#otherSize(outlines)))) return;
    this.#fitted = this.store.openings;
    this.origin = { x: outlines.origin_x_m, y: outlines.origin_y_m };
    this.#box = roomOf(outlines, this.case);
    this.view.fit(this.#box);
    this.#drawn = null;
    if (this.view.zoom !== zoomIdentity) this.svg.call(this.zooming.transform, zoomIdentity);
  }

  /** Than what was fitted: by far larger or smaller, by far elsewhere, or out of a window that no hand has moved. */
  #otherSize(outlines) {
    const [dx, dy] = [outlines.origin_x_m - this.origin.x, outlines.origin_y_m - this.origin.y];
    const box = roomOf(outlines);
    const size = Math.hypot(box[2] - box[0], box[3] - box[1]);
    const before = Math.hypot(this.#box[2] - this.#box[0], this.#box[3] - this.#box[1]);
    if (size > OTHER_SIZE * before || before > OTHER_SIZE * size || Math.hypot(dx, dy) > OTHER_SIZE * before) return true;
    const out = (x, y) => {
      const at = this.view.toScreen(x + dx, y + dy);
      return at.x < 0 || at.y < 0 || at.x > this.view.width || at.y > this.view.height;
    };
    const [x0, y0, x1, y1] = outlines.box_m;
    return this.view.zoom === zoomIdentity && [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].some(([x, y]) => out(x, y));
  }

  /** The tilt of the text, which is the newer one, over the dip at which the section lies; towards the side that is drawn. */
  #turn() {
    const { kase } = this.context;
    const own = this.context.number(["tilt", "angle_deg"]).value ?? 0;
    const dip = kase.frame?.inclined ? kase.frame.inclination_deg.value : 0;
    return (this.sign * Math.min(180, Math.max(0, own) + Math.abs(dip)) * Math.PI) / 180;
  }

  /** 1: the tilt turns counter-clockwise on the screen. */
  get sign() {
    return this.case?.towards === "right" ? -1 : 1;
  }

  #drawShapes(outlines) {
    const { moving } = this.layers;
    const [dx, dy] = [outlines.origin_x_m - this.origin.x, outlines.origin_y_m - this.origin.y];
    const shift = "translate(" + dx + " " + dy + ")";
    const drawn = [outlines, shift, Math.round(4 * Math.log2(this.view.dotsPerMetre))];
    if (this.#drawn?.every((one, i) => one === drawn[i])) return;
    this.#drawn = drawn;
    for (const group of [this.layers.still, this.layers.front, select(moving.node().parentNode)]) group.attr("transform", shift);
    drawShapes(this.layers, shapesOf(outlines, 1 / this.view.dotsPerMetre));
  }

  #drawPreview(stale) {
    const { outlines } = this.store.lastSolution;
    const path = (stale ? previewPath(this.context) : null) ?? "";
    this.layers.water.attr("d", waterPath(this.context, outlines, this.view.turn));
    this.layers.preview.attr("d", nearPath(path, reachOf(outlines))).classed("wrong", this.store.problem !== null);
  }

  /** What depends on the window alone: called while one zooms, too. */
  #place() {
    const { view, layers } = this;
    this.frame.attr("transform", "matrix(" + view.matrix.join(" ") + ")");
    const answer = this.store.lastSolution;
    if (answer?.outlines === undefined || this.context === null) return;
    const stale = this.store.solution === null;
    layers.symbols.selectAll("g").data(stale && this.store.problem !== null ? [] : symbolsOf(this.case, answer.outlines, view, this.origin))
      .join((enter) => {
        const made = enter.append("g");
        made.append("path");
        made.append("text");
        made.append("title");
        return made;
      })
      .attr("class", (symbol) => "symbol " + symbol.kind)
      .each(function (symbol) {
        const own = select(this);
        own.select("path").attr("d", symbol.d);
        own.select("text").attr("x", symbol.x ?? 0).attr("y", symbol.y ?? 0).text(symbol.text ?? "");
        own.select("title").text(symbol.title);
      });
    this.#drawArc();
    this.handles.set(handlesOf(this.context, view, this.sign));
    const { hidden } = this.handles;
    layers.note.text(hidden > 0 ? hidden + " more handles: come closer to see them" : "");
  }

  #drawArc() {
    const { x, y, radius } = tiltArc(this.view, this.sign);
    const angle = Math.abs(this.view.turn);
    const { sign } = this;
    const on = (r, a) => (x + sign * r * Math.cos(a)) + " " + (y - r * Math.sin(a));
    const path = "M" + on(radius, 0) + "L" + x + " " + y + "L" + on(radius, angle) +
      "M" + on(0.6 * radius, 0) + "A" + 0.6 * radius + " " + 0.6 * radius + " 0 0 " + (sign > 0 ? 0 : 1) + " " + on(0.6 * radius, angle);
    this.layers.arc.select("path").attr("d", path);
    this.layers.arc.select("text").attr("x", x + sign * 0.72 * radius * Math.cos(angle / 2)).attr("y", y - 0.72 * radius * Math.sin(angle / 2) + 4)
      .attr("text-anchor", sign > 0 ? "start" : "end").text(+((angle * 180) / Math.PI).toFixed(4) + "°");
  }

  #motion() {
    const { solution } = this.store;
    if (solution?.outlines === undefined || this.case === null) return null;
    const { outlines } = solution;
    return motionOf(this.case, outlines);
  }

  #edit(handle, edits) {
    this.#editing = true;
    this.store.setNumbers(edits, { mergeWith: "drag " + handle.key });
    this.#editing = false;
    // the next key press or report of the hand counts from what is drawn now
    this.#draw();
  }

  #tell(words) {
    this.words = words;
    this.dispatchEvent(new Event("told"));
  }

  #zooms(event) {
    return !event.ctrlKey && !event.button && event.target.closest?.(".handle") === null || event.type === "wheel";
  }

  #zoomed(transform) {
    this.view.zoom = transform;
    this.#later();
  }

  #resized(element) {
    const { width, height } = element.getBoundingClientRect();
    if (!(width > 0 && height > 0)) return;
    [this.view.width, this.view.height] = [width, height];
    this.svg.attr("viewBox", "0 0 " + width + " " + height);
    if (this.#box !== null) this.view.fit(this.#box);
    this.#later();
  }
}

/** The block, room below it for the rock and the reactions that it bears, and its centre of rotation where that is near. */
function roomOf(outlines, kase) {
  const [x0, y0, x1, y1] = outlines.box_m;
  const size = Math.max(y1 - y0, 0.4 * (x1 - x0));
  const room = [x0, y0 - 0.2 * size, x1, y1];
  const { centre_x_m: x, centre_y_m: y } = kase?.limit ?? {};
  if (x == null || y == null) return room;
  const at = resultPoint(outlines, x, y);
  const grown = [Math.min(room[0], at.x), Math.min(room[1], at.y), Math.max(room[2], at.x), Math.max(room[3], at.y)];
  const much = grown[2] - grown[0] > x1 - x0 + CENTRE_NEAR * size || grown[3] - grown[1] > y1 - y0 + CENTRE_NEAR * size;
  return much ? room : grown;
}
