// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Handles on the screen: each can be dragged by mouse, pen and finger, and moved by the arrow keys. */

import { drag } from "d3-drag";
import { say } from "../words/language.js";

const RADIUS = 7;
const REACH = 2.4 * RADIUS;
const APART = 24; // dots
const CLOSE = 3 * RADIUS; // of a neighbour: both are drawn smaller

const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class HandlesLayer {
  #waiting = null;
  #keyed = null; // the handle that keys have moved last
  #grip = null; // the handle that is dragged, how far from its place it is drawn, and where that was

  /**
   * @param group a d3 selection @param {import("./view.js").View} view
   * @param {{change: (key: string, handle: object) => boolean, edit: (handle: object, edits: object[]) => void, ended: () => void, focused: () => void, exponent: () => number,
   *   told: (text: string) => void}} hand
   */
  constructor(group, view, hand) {
    this.group = group;
    this.view = view;
    this.hand = hand;
    this.handles = [];
    /** The key of the handle that is dragged. @type {string|null} */
    this.dragged = null;
    addEventListener("pagehide", () => this.#apply()); // what the hand did last is kept with the scene
  }

  /** Keys of handles that stay, however many others are nearer: one that is dragged, one that has the focus. */
  get kept() {
    const focused = this.group.node().contains(document.activeElement) ? document.activeElement.dataset.handle : null;
    return new Set([this.dragged, focused].filter((key) => key !== null));
  }

  /** Keys of those that there are while one is dragged: which of many are chosen does not change under the hand. @returns {Set<string>|null} null: none is dragged */
  get only() {
    return this.dragged === null ? null : new Set(this.handles.map(({ key }) => key));
  }

  /** Whether the hand has moved one since the last frame: what it does is drawn in the next. */
  get moves() {
    return this.#waiting !== null;
  }

  /** Of the handle that has the focus by keys, if one has: they led to it, or moved it since the hand left it. @returns {string[]} */
  get byKeys() {
    return [...this.group.node().querySelectorAll(".handle:focus")].filter((handle) => handle.matches(":focus-visible") || handle.dataset.handle === this.#keyed)
      .map((handle) => handle.dataset.handle);
  }

  /** @param {import("./handle.js").Handle[]} handles */
  set(handles) {
    this.handles = handles;
    this.place();
  }

  /** Put them where they are now; those outside of the window are not drawn. */
  place() {
    const { width, height } = this.view;
    const still = this.dragged; // the words of the others come up to date when the hand lets go
    const dotsOf = (metres) => String(Math.max(REACH, metres * this.view.dotsPerMetre));
    const seen = apart(this.handles.map((handle) => ({ handle, ...(handle.dots ?? this.view.toScreen(handle.at.x, handle.at.y)) }))
      .filter(({ handle, x, y }) => handle.key === this.dragged || (x > -20 && y > -20 && x < width + 20 && y < height + 20)),
    this.view.direction(0, -1), this.#grip);
    this.group.selectAll("g.handle").data(seen, (one) => one.handle.key)
      .join((enter) => this.#made(enter))
      .each(function ({ handle, x, y, away, close }) {
        // of a hundred handles one is dragged: the others' places and words stay, and are not laid out again
        const place = "translate(" + (x + away.x) + " " + (y + away.y) + ")";
        if (this.place !== place) {
          this.place = place;
          this.setAttribute("transform", place);
          this.querySelector(".lead").setAttribute("d", away.x === 0 && away.y === 0 ? "" : "M0 0L" + -away.x + " " + -away.y);
        }
        if (handle.reach !== undefined) this.querySelector(".reach").setAttribute("r", dotsOf(handle.reach));
        if (this.close !== close) this.classList.toggle("close", (this.close = close));
        if (still !== null && still !== handle.key && this.words !== undefined) return;
        const words = handle.fixed ?? handle.label;
        if (this.words === words) return;
        this.words = words;
        this.setAttribute("class", "handle " + handle.kind + (handle.fixed === null ? "" : " fixed") + (close ? " close" : ""));
        this.setAttribute("aria-label", handle.fixed ?? handle.label + ". " + say("Arrow keys move it.") + (handle.kind === "vertex" ? " " + say("Enter puts a vertex behind it, Delete takes it away.") : ""));
        this.querySelector("title").textContent = words;
      });
  }

  #made(enter) {
    const made = enter.append("g").attr("tabindex", 0).attr("role", "button").attr("aria-roledescription", "handle")
      .attr("data-handle", ({ handle }) => handle.key)
      .on("keydown", (event, { handle }) => this.#key(event, handle))
      .on("focus", (event, { handle }) => {
        this.hand.told(handle.fixed ?? handle.label);
        this.hand.focused();
      })
      .on("pointerenter", (event, { handle }) => this.hand.told(handle.fixed ?? handle.label))
      .call(this.#dragging());
    made.append("title");
    made.append("path").attr("class", "lead");
    made.append("circle").attr("class", "reach").attr("r", REACH);
    made.append("circle").attr("class", "knob").attr("r", RADIUS);
    return made;
  }

  #dragging() {
    return drag()
      .container((event) => this.group.node().ownerSVGElement)
      .clickDistance(3)
      .subject((event, { x, y }) => ({ x, y }))
      .on("start", (event, { handle, away }) => {
        this.#grip = { key: handle.key, away, from: handle.at };
        this.dragged = handle.fixed === null ? handle.key : null;
        this.#keyed = null;
        if (handle.fixed !== null) this.hand.told(handle.fixed);
      })
      .on("drag", (event) => this.#dragTo({ x: event.x, y: event.y, keepsAxis: event.sourceEvent.shiftKey }))
      .on("end", () => {
        this.#apply();
        this.dragged = this.#grip = null;
        this.hand.ended();
      });
  }

  /** The scene is changed once a frame, however often the hand reports. */
  #dragTo(dots) {
    if (this.dragged === null) return;
    if (this.#waiting === null) requestAnimationFrame(() => this.#apply());
    this.#waiting = dots;
  }

  #apply() {
    const dots = this.#waiting;
    this.#waiting = null;
    const handle = this.handles.find((one) => one.key === this.dragged);
    if (dots === null || handle === undefined) return;
    const place = handle.dots === undefined ? this.view.toFrame(dots.x, dots.y) : dots;
    const hand = dots.keepsAxis && handle.at !== undefined ? alongAxis(this.#grip.from, place) : place;
    this.hand.edit(handle, handle.drag(hand, this.hand.exponent()));
    this.hand.told((this.handles.find((one) => one.key === handle.key) ?? handle).label);
  }

  #key(event, handle) {
    const way = KEYS[event.key];
    if (way === undefined && this.hand.change(event.key, handle)) {
      event.preventDefault();
      event.stopPropagation();
    }
    if (way === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.#keyed = handle.key;
    if (handle.fixed !== null) {
      this.hand.told(handle.fixed);
      return;
    }
    const many = event.shiftKey ? 10 : 1;
    const edits = handle.step(way[0] * many, way[1] * many, this.hand.exponent());
    if (edits.length > 0) this.hand.edit(handle, edits);
    const after = this.handles.find((one) => one.key === handle.key);
    if (after !== undefined) this.hand.told(after.label);
  }
}

/** With Shift a point keeps one of its coordinates: that in which the hand has moved less. */
function alongAxis(from, hand) {
  return Math.abs(hand.x - from.x) > Math.abs(hand.y - from.y) ? { x: hand.x, y: from.y } : { x: from.x, y: hand.y };
}

/**
 * Handles of the base lie where those of the block do, as these touch it: they are drawn below, with a line to their place.
 * One that is dragged stays as it was taken. Vertices that crowd are small, so that one sees what they lie on.
 */
function apart(seen, down, grip) {
  const vertices = seen.filter(({ handle }) => handle.kind === "vertex");
  const others = seen.filter(({ handle }) => handle.kind !== "base");
  return seen.map((one) => {
    const covered = one.handle.kind === "base" && others.some(({ x, y }) => Math.hypot(x - one.x, y - one.y) < 2 * RADIUS);
    const away = grip?.key === one.handle.key ? grip.away : covered ? { x: APART * down.x, y: APART * down.y } : { x: 0, y: 0 };
    const crowds = one.handle.kind === "vertex" && vertices.some((other) => other !== one && (other.x - one.x) ** 2 + (other.y - one.y) ** 2 < CLOSE ** 2);
    return { ...one, away, close: crowds };
  });
}
