// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A photograph over the drawing, to be clicked: moved by dragging and brought closer by the wheel; each click puts a point, which
 * can be dragged, moved by arrow keys and deleted. With keys alone a cross is moved, and Enter puts a point there.
 */

import { drag } from "d3-drag";
import { pointer, select } from "d3-selection";
import { zoom, zoomIdentity } from "d3-zoom";
import { say } from "../words/language.js";

const RADIUS = 6;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const CROSS_STEP = 10; // dots; with Shift 1
const CLOSER = { "+": 1.25, "=": 1.25, "-": 0.8 };
const MARGIN = 0.04;
const EXACT = 100; // of a pixel: what a scene writes of a click

const rounded = (value, most) => Math.round(EXACT * Math.max(0, Math.min(most, value))) / EXACT;

export class PhotoView {
  #cross = null; // where the cross of the keys is, in the picture
  #scale = 1;
  #offset = { x: 0, y: 0 };
  #zoom = zoomIdentity;

  /** @param {HTMLElement} place @param {{put: (point: object) => void, gone: (list: string, at: number) => void, ended: () => void}} told */
  constructor(place, told) {
    this.told = told;
    this.place = place;
    this.svg = select(place).append("svg").attr("class", "photo").attr("role", "application").attr("tabindex", 0)
      .attr("aria-label", say("Photograph: arrow keys move the cross, Enter puts a point, + and - zoom, 0 fits, Tab leads to the points"));
    this.frame = this.svg.append("g");
    this.image = this.frame.append("image").attr("preserveAspectRatio", "none");
    this.lines = this.frame.append("path").attr("class", "outline-line");
    this.bars = this.frame.append("path").attr("class", "bar-line");
    this.crossLines = this.frame.append("path").attr("class", "cross");
    this.points = this.frame.append("g");
    this.zooming = zoom().scaleExtent([0.2, 60]).clickDistance(4)
      .filter((event) => !event.button && event.target.closest(".photo-point") === null).on("zoom", ({ transform }) => this.#zoomed(transform));
    this.svg.call(this.zooming).on("dblclick.zoom", null).on("click", (event) => this.#clicked(event)).on("keydown", (event) => this.#key(event));
    new ResizeObserver(() => this.fit()).observe(place);
  }

  /** @param {{href: string, width: number, height: number}} picture */
  show(picture) {
    this.picture = picture;
    this.image.attr("href", picture.href).attr("width", picture.width).attr("height", picture.height);
    this.#cross = null;
    this.svg.call(this.zooming.transform, zoomIdentity);
    this.fit();
  }

  /** @param {Record<string, {x: number, y: number}[]>} lists of points, by their names */
  draw(lists) {
    this.lists = lists;
    const path = (points, end = "") => (points.length < 2 ? "" : "M" + points.map(({ x, y }) => x + " " + y).join("L") + end);
    this.lines.attr("d", path(lists.outline, lists.outline.length > 2 ? "Z" : ""));
    this.bars.attr("d", path(lists.scale) + path(lists.plumb));
    const all = Object.entries(lists).flatMap(([list, points]) => points.map((point, at) => ({ list, point, at })));
    this.points.selectAll("circle").data(all, ({ list, at }) => list + at).join((enter) => this.#made(enter))
      .attr("aria-label", ({ list, at }) => say(LABELS[list], at + 1)).attr("cx", ({ point }) => point.x).attr("cy", ({ point }) => point.y);
    this.#sizes();
  }

  fit() {
    const { width, height } = this.place.getBoundingClientRect();
    if (this.picture === undefined || width === 0) return;
    this.#scale = Math.min(width / this.picture.width, height / this.picture.height) * (1 - MARGIN);
    this.#offset = { x: (width - this.#scale * this.picture.width) / 2, y: (height - this.#scale * this.picture.height) / 2 };
    this.svg.attr("viewBox", "0 0 " + width + " " + height);
    this.#zoomed(this.#zoom);
  }

  #zoomed(transform) {
    this.#zoom = transform;
    const { k, x, y } = transform;
    this.frame.attr("transform", "translate(" + (x + k * this.#offset.x) + " " + (y + k * this.#offset.y) + ") scale(" + k * this.#scale + ")");
    this.#sizes();
  }

  get #dot() {
    return 1 / (this.#scale * this.#zoom.k);
  }

  /** Lines and points are as large on the screen at every distance. */
  #sizes() {
    this.points.selectAll("circle").attr("r", RADIUS * this.#dot);
    this.#showCross();
  }

  #made(enter) {
    return enter.append("circle").attr("class", ({ list }) => "photo-point " + list).attr("tabindex", 0).attr("role", "button")
      .on("click", (event, { list, at }) => (event.stopPropagation(), list === "outline" && at === 0 && this.told.ended()))
      .on("keydown", (event, { list, at, point }) => this.#pointKey(event, list, at, point))
      .call(drag().container(() => this.frame.node()).subject((event, { point }) => point).on("drag", (event, { point }) => this.#to(point, event)));
  }

  #to(point, { x, y }) {
    point.x = rounded(x, this.picture.width);
    point.y = rounded(y, this.picture.height);
    this.draw(this.lists);
  }

  #clicked(event) {
    const [x, y] = pointer(event, this.frame.node());
    if (x >= 0 && y >= 0 && x <= this.picture.width && y <= this.picture.height) this.told.put({ x: rounded(x, this.picture.width), y: rounded(y, this.picture.height) });
  }

  #key(event) {
    if (event.target !== this.svg.node()) return;
    const way = ARROWS[event.key];
    if (way !== undefined) {
      const step = (event.shiftKey ? 1 : CROSS_STEP) * this.#dot;
      const at = this.#cross ?? { x: this.picture.width / 2, y: this.picture.height / 2 };
      this.#cross = { x: Math.max(0, Math.min(this.picture.width, at.x + step * way[0])), y: Math.max(0, Math.min(this.picture.height, at.y + step * way[1])) };
      this.#showCross();
      this.#follow();
    } else if (event.key in CLOSER) this.svg.call(this.zooming.scaleBy, CLOSER[event.key], this.#seen() ?? undefined);
    else if (event.key === "0") this.svg.call(this.zooming.transform, zoomIdentity);
    else if (event.key === "Enter" && this.#cross !== null) this.told.put({ x: rounded(this.#cross.x, this.picture.width), y: rounded(this.#cross.y, this.picture.height) });
    else return;
    event.preventDefault();
  }

  /** Where the cross is on the screen. @returns {[number, number]|null} */
  #seen() {
    return this.#cross === null ? null : this.#zoom.apply([this.#offset.x + this.#scale * this.#cross.x, this.#offset.y + this.#scale * this.#cross.y]);
  }

  /** A cross that leaves the window takes the photograph with it. */
  #follow() {
    const { width, height } = this.place.getBoundingClientRect();
    const [x, y] = this.#seen();
    if (x < 0 || y < 0 || x > width || y > height) this.svg.call(this.zooming.translateTo, ...this.#zoom.invert([x, y]));
  }

  #pointKey(event, list, at, point) {
    const way = ARROWS[event.key];
    event.stopPropagation();
    if (way !== undefined) {
      const step = (event.shiftKey ? CROSS_STEP : 1) * this.#dot;
      this.#to(point, { x: point.x + step * way[0], y: point.y + step * way[1] });
    } else if (event.key === "Delete" || event.key === "Backspace") this.told.gone(list, at);
    else if (event.key === "Enter" && list === "outline") this.told.ended();
    else return;
    event.preventDefault();
  }

  #showCross() {
    const reach = 14 * this.#dot;
    this.crossLines.attr("d", this.#cross === null ? "" : "M" + (this.#cross.x - reach) + " " + this.#cross.y + "h" + 2 * reach + "M" + this.#cross.x + " " + (this.#cross.y - reach) + "v" + 2 * reach);
  }
}

const LABELS = { scale: "scale, point %s", plumb: "plumb line, point %s", outline: "outline, point %s", between: "end %s of the contact" };
