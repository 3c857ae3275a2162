// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * A mechanism map on the page: the plane as a canvas, over it the certified borders, axes, and the present scene as a
 * point that can be dragged or moved by the arrow keys.
 */

import { element, refill, svgElement } from "./element.js";
import { shortNumber } from "./chart.js";
import { say } from "../words/language.js";

const SIDE = 1000;
const ROOM = { left: 150, bottom: 130, top: 20, right: 40 };
const TICKS = 5;

/**
 * @typedef {{name: string, from: number, to: number}} Axis
 * @typedef {{series: string, of: string, points: {x: {value: number}, y: {value: number}}[]}} Series
 */

export class MapFigure {
  /**
   * @param {HTMLElement} place
   * @param {object} told
   * @param {(x: number, y: number) => void} told.moved the scene is to be there
   * @param {() => void} told.left the point was let go
   * @param {(x: number, y: number) => void} told.pointed the pointer is there
   */
  constructor(place, { moved, left, pointed }) {
    Object.assign(this, { moved, left, pointed });
    this.canvas = element("canvas", {});
    this.lines = svgElement("g", { class: "borders", "clip-path": "url(#map-frame)" });
    const clip = svgElement("clipPath", { id: "map-frame" }, svgElement("rect", { width: SIDE, height: SIDE }));
    this.axes = svgElement("g", { class: "axes" });
    this.point = svgElement(
      "g",
      { class: "scene-point", tabindex: 0, role: "button", "aria-label": "The scene on the map: drag it, or use the arrow keys" },
      svgElement("circle", { r: 22, class: "touch" }),
      svgElement("circle", { r: 13 }),
      svgElement("path", { d: "M-24 0H24M0 -24V24" }),
    );
    this.drawing = svgElement(
      "svg",
      { viewBox: [-ROOM.left, -ROOM.top, SIDE + ROOM.left + ROOM.right, SIDE + ROOM.top + ROOM.bottom].join(" ") },
      clip, this.axes, this.lines, this.point,
    );
    const part = (length, whole) => (100 * length) / whole + "%";
    const [width, height] = [SIDE + ROOM.left + ROOM.right, SIDE + ROOM.top + ROOM.bottom];
    this.canvas.style.cssText =
      "left:" + part(ROOM.left, width) + ";top:" + part(ROOM.top, height) + ";width:" + part(SIDE, width) + ";height:" + part(SIDE, height);
    place.replaceChildren(element("div", { class: "map" }, this.canvas, this.drawing));
    this.#listen();
  }

  /** @param {Axis} x @param {Axis} y */
  setAxes(x, y) {
    this.x = x;
    this.y = y;
    refill(
      this.axes,
      svgElement("rect", { class: "frame", width: SIDE, height: SIDE }),
      ticks(x).map(({ at, text }) => svgElement("text", { x: at * SIDE, y: SIDE + 45, "text-anchor": "middle" }, text)),
      ticks(y).map(({ at, text }) => svgElement("text", { x: -16, y: SIDE - at * SIDE + 11, "text-anchor": "end" }, text)),
      svgElement("text", { x: SIDE / 2, y: SIDE + 105, "text-anchor": "middle" }, x.name),
      svgElement("text", { transform: "translate(-115 " + SIDE / 2 + ") rotate(-90)", "text-anchor": "middle" }, y.name),
    );
  }

  /** Nothing of the plane and of its borders is left. */
  clear() {
    this.canvas.width = 0;
    this.setBorders([]);
  }

  /** @param {import("./map_grid.js").MapGrid} grid @param {(kind: number) => [number, number, number]} colour */
  setPlane(grid, colour) {
    this.canvas.width = grid.columns;
    this.canvas.height = grid.rows;
    const context = this.canvas.getContext("2d");
    const image = context.createImageData(grid.columns, grid.rows);
    for (let row = 0; row < grid.rows; row++) {
      for (let column = 0; column < grid.columns; column++) {
        const at = 4 * ((grid.rows - 1 - row) * grid.columns + column);
        image.data.set([...colour(grid.kinds[row * grid.columns + column]), 255], at);
      }
    }
    context.putImageData(image, 0, 0);
  }

  /** @param {Series[]} series of `chart map` */
  setBorders(series) {
    refill(
      this.lines,
      series.map(({ series: name, of, points }) => {
        const data = points.map(({ x, y }, index) => (index === 0 ? "M" : "L") + this.#acrossX(x.value).toFixed(2) + " " + this.#upY(y.value).toFixed(2));
        const contour = /^-?\d/.test(of);
        return svgElement(
          "g",
          {},
          svgElement("path", { class: "line " + name.replaceAll(" ", "-") + (contour ? " contour" : ""), d: data.join("") }),
          contour ? this.#contourText(points, of) : null,
          svgElement("title", {}, say(name) + (of ? ": " + say(of) + (contour ? "°" : "") : "")),
        );
      }),
    );
  }

  /** @param {number|null} x @param {number|null} y null: the scene has no such number */
  setPoint(x, y) {
    this.at = x === null || y === null ? null : { x, y };
    this.point.style.display = this.at === null ? "none" : "";
    if (this.at === null) return;
    this.point.setAttribute("transform", "translate(" + this.#acrossX(x) + " " + this.#upY(y) + ")");
  }

  #contourText(points, of) {
    const { x, y } = points[Math.floor(points.length / 2)];
    return svgElement("text", { class: "contour", x: this.#acrossX(x.value), y: this.#upY(y.value) - 6 }, of + "°");
  }

  #listen() {
    const place = (event) => {
      const box = this.canvas.getBoundingClientRect();
      const x = clamped((event.clientX - box.left) / box.width);
      const y = clamped(1 - (event.clientY - box.top) / box.height);
      return [this.x.from + x * (this.x.to - this.x.from), this.y.from + y * (this.y.to - this.y.from)];
    };
    const move = (event) => this.moved(...place(event));
    this.drawing.addEventListener("pointermove", (event) => this.x && this.pointed(...place(event)));
    this.drawing.addEventListener("pointerdown", (event) => {
      if (!this.point.contains(event.target)) return;
      event.preventDefault();
      this.point.focus();
      this.drawing.setPointerCapture(event.pointerId);
      this.drawing.addEventListener("pointermove", move);
    });
    const release = () => {
      this.drawing.removeEventListener("pointermove", move);
      this.left();
    };
    this.drawing.addEventListener("pointerup", release);
    this.drawing.addEventListener("pointercancel", release);
    this.drawing.addEventListener("dblclick", move);
    this.point.addEventListener("keydown", (event) => {
      const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (steps === undefined || this.at === null) return;
      event.preventDefault();
      const part = event.shiftKey ? 0.1 : 0.01;
      this.moved(
        this.at.x + steps[0] * part * (this.x.to - this.x.from), this.at.y + steps[1] * part * (this.y.to - this.y.from),
      );
    });
  }

  #acrossX(value) {
    return ((value - this.x.from) / (this.x.to - this.x.from)) * SIDE;
  }

  #upY(value) {
    return SIDE - ((value - this.y.from) / (this.y.to - this.y.from)) * SIDE;
  }
}

function ticks({ from, to }) {
  return Array.from({ length: TICKS + 1 }, (_, index) => ({
    at: index / TICKS, text: shortNumber(Number((from + ((to - from) * index) / TICKS).toPrecision(4))),
  }));
}

const clamped = (part) => Math.max(0, Math.min(1, part));
