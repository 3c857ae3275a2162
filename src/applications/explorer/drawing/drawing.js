// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The block on its base, to scale and tilted, drawn from the core's answer, with handles that change the scene. While
 * there is no answer for the present text, the last one stays, greyed, and the dragged shape is drawn over it.
 *
 * Events: "told" (.words says what a handle or a symbol is), "case" (another direction of tilt is drawn).
 */

import { pointer, select } from "d3-selection";
import { zoom, zoomIdentity } from "d3-zoom";
import { stepExponent } from "../scene/decimal.js";
import { Context } from "./handle.js";
import { withVertexAfter, withVertexAt, withoutVertex } from "./vertex_edits.js";
import { View } from "./view.js";
import { waterPath } from "./water.js";
import { drawShapes, isDrawable, reachOf, shapesOf } from "./shapes.js";
import { nearPath } from "./thin_path.js";
import { symbolsOf } from "./symbols.js";
import { drawSymbols } from "./symbols_layer.js";
import { symbolsOfMany } from "./symbols_of_many.js";
import { drawPhotograph } from "./photo_behind.js";
import { previewPath } from "./preview.js";
import { HandlesLayer } from "./handles_layer.js";
import { handlesOf } from "./handles.js";
import { drawArc, turnOf } from "./tilt_handle.js";
import { emptied, layersOf, putNote } from "./layers.js";
import { isElsewhere, roomOf } from "./room.js";
import { drawScale } from "./scale_bar.js";
import { say } from "../words/language.js";

const SNAP_DOTS = 3;
const ZOOM_MAX = 1e6;
const SWING_DECIMALS = 1; // of the tilt while the view swings

export class Drawing extends EventTarget {
  #fitted = -1; // which of the scenes that were opened the window was fitted to
  #box = null; // what it was fitted to, metres from the origin
  #steady = null; // the turn at which it was fitted; null: at all
  #way = null; // what it is fitted to while a film is shown
  #drawn = null; // of which answer the paths are
  #waits = null;
  #editing = false;
  #byHand = false; // the present text came from a handle
  #hand = null; // where the pointer is, dots
  #handWaits = false;
  #photograph = null;
  #crowded = false; // some handles come with the hand: there are too many, or those of a block's sizes
  #touched = []; // paths of the numbers that were dragged since the last answer; null: the text was changed otherwise

  /** @param {HTMLElement} element @param {import("../scene/store.js").SceneStore} store */
  constructor(element, store) {
    super();
    this.store = store;
    this.view = new View();
    this.caseIndex = 0;
    this.words = "";
    /** How far down the badge stands over it, dots: asked when a scene is fitted, not while it is dragged. @type {() => number} */
    this.above = () => 0;
    this.origin = { x: 0, y: 0 };
    this.context = null;
    this.svg = select(element).append("svg").attr("class", "drawing").attr("role", "group").attr("aria-label", say("Drawing of the block on its base"));
    this.layers = layersOf(this.svg);
    this.frame = this.layers.frame;
    this.zooming = zoom().scaleExtent([0.05, ZOOM_MAX]).filter((event) => this.#zooms(event)).on("zoom", (event) => this.#zoomed(event.transform));
    this.svg.call(this.zooming).on("dblclick.zoom", null);
    this.handles = new HandlesLayer(this.layers.handles, this.view, {
      change: (key, handle) => this.#change(key, handle),
      edit: (handle, edits) => this.#edit(handle, edits),
      ended: () => {
        store.endGesture();
        this.#later();
      },
      exponent: () => this.exponent,
      told: (words) => this.#tell(words),
      focused: () => this.#follow(),
    });
    this.svg.on("dblclick", (event) => this.#addAt(pointer(event, this.svg.node())));
    this.svg.on("pointermove", (event) => this.#follow(pointer(event, this.svg.node())));
    store.addEventListener("text", () => {
      this.#byHand = this.#editing;
      if (!this.#editing && !this.context?.many) this.#touched = null;
      this.#later();
    });
    store.addEventListener("solution", () => {
      this.#touched = [];
      this.#later();
    });
    for (const event of ["problem", "late"]) store.addEventListener(event, () => this.#later());
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
    this.#later(); // where the badge, beside which it is fitted, has the words of this answer
    this.dispatchEvent(new Event("case"));
  }

  /** Draw the scene as if it were tilted further; nothing of the scene changes. @param {number} degrees */
  swingBy(degrees) {
    this.view.swing = (degrees * Math.PI) / 180;
    this.draw();
  }

  /** All of the block into the window. */
  fit() {
    this.#fitted = -1;
    this.svg.call(this.zooming.transform, zoomIdentity);
    this.draw();
  }

  /** While a film is shown the window takes in the block's whole way. @param {number[]|null} [way] */
  refit(way = this.#way) {
    this.#way = way;
    if (this.#box !== null) this.view.fit(way ?? this.#box, this.#steady);
  }

  /** @param {number} factor @param {number} [dx] @param {number} [dy] a share of the window to move by */
  zoomBy(factor, dx = 0, dy = 0) {
    if (factor !== 1) this.svg.call(this.zooming.scaleBy, factor);
    if (dx !== 0 || dy !== 0) this.svg.call(this.zooming.translateBy, (dx * this.view.width) / this.view.zoom.k, (dy * this.view.height) / this.view.zoom.k);
  }

  /** What lies behind the block; null: nothing. @param {object|null} photograph as `drawPhotograph` takes it */
  setPhotograph(photograph) {
    this.#photograph = photograph;
    this.svg.classed("over-photo", photograph !== null);
    this.#later();
  }

  /** Several changes within a frame are drawn once, and with the hand, where it moves in that frame. */
  #later() {
    this.#waits ??= requestAnimationFrame(() => {
      this.#waits = null;
      if (!this.handles.moves) this.draw();
    });
  }

  draw() {
    cancelAnimationFrame(this.#waits);
    this.#waits = null;
    if (this.svg.classed("filming")) {
      this.frame.attr("transform", "matrix(" + this.view.matrix.join(" ") + ")");
      return;
    }
    const { store } = this;
    const answer = store.lastSolution;
    const kase = this.case;
    const stale = store.solution === null;
    const isOutdated = stale && (store.problem !== null || store.late);
    this.svg.classed("stale", isOutdated);
    this.context = null;
    drawPhotograph(this.layers.photo, null, null);
    if (answer === null) this.#leaveOut(""); // nothing of a scene that was there before
    if (answer?.kind === "solid") this.#leaveOut(say("This solid is not drawn here; its report stands beside this"));
    if (answer?.outlines === undefined || kase === null) return;
    const { outlines } = answer;
    if (!isDrawable(outlines)) {
      this.#leaveOut(say("No browser can draw a block of this size; its numbers stand beside this"));
      return;
    }
    this.#fitOnce(outlines);
    this.context = new Context(store.parsed, kase, outlines, this.origin);
    this.view.turn = turnOf(this.context, store.solution !== null, this.sign) + this.sign * this.view.swing;
    this.#drawShapes(outlines);
    this.#drawPreview(stale);
    drawPhotograph(this.layers.photo, this.context, this.#photograph);
    this.#place();
  }

  /** Nothing of the scene, and why. */
  #leaveOut(why) {
    this.#drawn = null;
    this.#fitted = -1;
    drawShapes(this.layers, []);
    emptied(this.layers);
    this.handles.set([]);
    putNote(this.layers.note, this.view, why);
  }

  /** A scene that was opened is fitted once, and one that was typed where it is of another size; dragged, it stays. */
  #fitOnce(outlines) {
    const opened = this.#fitted !== this.store.openings;
    if (this.store.solution === null || (!opened && (this.#byHand || !isElsewhere(this.view, this.#box, outlines, this.origin)))) return;
    this.#fitted = this.store.openings;
    this.origin = { x: outlines.origin_x_m, y: outlines.origin_y_m };
    this.#box = roomOf(outlines, this.case);
    // many blocks are seldom tilted by much, and need the room
    this.#steady = outlines.blocks === undefined ? null : (this.sign * this.case.tilt_angle_deg.value * Math.PI) / 180;
    this.view.resize(this.view.width, this.view.height, this.above());
    this.view.fit(this.#box, this.#steady);
    this.#drawn = null;
    if (this.view.zoom !== zoomIdentity) this.svg.call(this.zooming.transform, zoomIdentity);
  }

  /** 1: the tilt turns counter-clockwise on the screen. */
  get sign() {
    return this.case?.towards === "right" ? -1 : 1;
  }

  #drawShapes(outlines) {
    const { moving } = this.layers;
    const [dx, dy] = [outlines.origin_x_m - this.origin.x, outlines.origin_y_m - this.origin.y];
    const shift = "translate(" + dx + " " + dy + ")";
    const drawn = [outlines, this.case, shift, Math.round(4 * Math.log2(this.view.dotsPerMetre))];
    if (this.#drawn?.every((one, i) => one === drawn[i])) return;
    this.#drawn = drawn;
    for (const group of [this.layers.still, this.layers.front, select(moving.node().parentNode)]) group.attr("transform", shift);
    drawShapes(this.layers, shapesOf(this.store.lastSolution, this.case, 1 / this.view.dotsPerMetre));
  }

  #drawPreview(stale) {
    const { outlines } = this.store.lastSolution;
    const path = stale ? previewPath(this.context, 1 / this.view.dotsPerMetre, this.#touched) : "";
    this.layers.water.attr("d", this.context.many ? "" : waterPath(this.context, outlines, this.view.turn));
    this.layers.preview.attr("d", nearPath(path, reachOf(outlines))).classed("wrong", this.store.problem !== null);
  }

  /** What depends on the window alone: called while one zooms, too. */
  #place() {
    const { view, layers } = this;
    this.frame.attr("transform", "matrix(" + view.matrix.join(" ") + ")");
    const answer = this.store.lastSolution;
    if (answer?.outlines === undefined || this.context === null) return;
    const stale = this.store.solution === null;
    const symbols = this.context.many ? symbolsOfMany : symbolsOf;
    drawSymbols(layers.symbols, stale && (this.store.problem !== null || this.store.late) ? [] : symbols(answer, this.case, view, this.origin));
    drawArc(layers.arc, view, this.sign, view.swing === 0 ? undefined : SWING_DECIMALS);
    drawScale(layers.scale, view, this.sign, this.context);
    this.#placeHandles();
  }

  /** Of many vertices those near the hand have handles, which it brings along. */
  #placeHandles() {
    if (this.context === null) return;
    const { kept, byKeys, only } = this.handles;
    const { handles, hidden } = handlesOf(this.context, this.view, this.sign, { hand: this.#hand, kept, byKeys, only });
    this.handles.set(handles);
    if (hidden === null) return;
    this.#crowded = hidden > 0 || this.context.many;
    putNote(this.layers.note, this.view, hidden > 0 ? say("%s more vertices: their handles come with the pointer, or closer", hidden) : "");
  }

  /** Handles that come with the hand, or with the focus. @param {[number, number]} [at] where the hand is now, dots */
  #follow(at = null) {
    if (at !== null) this.#hand = { x: at[0], y: at[1] };
    if (!this.#crowded || this.#handWaits || this.handles.dragged !== null) return;
    this.#handWaits = true;
    requestAnimationFrame(() => {
      this.#handWaits = false;
      this.#placeHandles();
    });
  }

  #edit(handle, edits) {
    this.#editing = true;
    this.#touched?.push(...edits.map(({ path }) => path));
    this.store.setNumbers(edits, { mergeWith: "drag " + handle.key });
    this.#editing = false;
    // the next key press or report of the hand counts from what is drawn now
    this.draw();
  }

  /** A vertex where an edge was struck twice. */
  #addAt([x, y]) {
    if (this.context !== null && !this.svg.classed("filming")) this.#put(withVertexAt(this.context, this.view, { x, y }, this.exponent));
  }

  /** By keys: the vertex that has the focus goes, or one comes behind it. @returns {boolean} whether the key means that */
  #change(key, handle) {
    if (this.context === null || !["Delete", "Backspace", "Insert", "Enter"].includes(key)) return false;
    if (key === "Enter" && handle.kind !== "vertex") return false; // keyboards without Insert have Enter, which means nothing else at a vertex
    this.#put(["Delete", "Backspace"].includes(key) ? withoutVertex(this.context, handle.key) : withVertexAfter(this.context, handle.key, this.exponent));
    return true;
  }

  /** @param {string|null} text */
  #put(text) {
    if (text === null) this.#tell(say("No vertex can come or go here: only those of an outline or a profile that stands in the text"));
    else this.store.setText(text);
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
    this.view.resize(width, height, this.above());
    this.svg.attr("viewBox", "0 0 " + width + " " + height);
    this.refit();
    this.#later();
  }
}
