// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The tilt test as the core simulates it (`topple tilt`), as a film: where the block is at each moment, and what each
 * contact does. Between two moments of the answer the block is drawn on the straight way from one to the other; beyond
 * the last one nothing is shown.
 *
 * The course of a film is the time of the test. The path of equilibria (`engine: path`) knows no time: its course is the
 * tilt, up to the collapse. Poses that no block can have, as solutions near a collapse may give them, end the film before
 * they are reached, whatever the engine.
 */

import { resultPoint } from "./result_point.js";

const RISE = 2.5; // seconds of the film in which the table rises to where the block begins to move
const RISE_OF_PATH = 8; // and in which a path goes on to its collapse, with all its events
const AFTER = 0.6; // seconds shown after the last event
const SHORTEST = 1e-3; // seconds: of a block that falls on level ground
const SHAKEN = "shaking";
/** How far from its place a block is shown, in its diagonals and degrees: one that falls may roll far, contacts give way by little. */
const FAR = { time: { moved: 1000, turned: 360_000 }, tilt: { moved: 0.1, turned: 5 } };

/** What a contact does after an event. */
const STATES = { opens: "open", closes: "closed", slips: "slips", sticks: "closed", accumulates: "closed" };

export class Film {
  /**
   * @param {any} kase of `topple tilt --json` @param {boolean} shaken the base shakes: nothing of it is hastened
   * @param {number} [size] the block's diagonal, metres
   */
  constructor(kase, shaken = false, size = Infinity) {
    const all = kase.moments;
    /** What the film runs over: "time" in seconds, or "tilt" in degrees. @type {"time"|"tilt"} */
    this.course = all[all.length - 1].time_s > all[0].time_s ? "time" : "tilt";
    const key = this.course === "time" ? "time_s" : "angle_deg";
    this.courseOf = (one) => one[key];
    this.moments = sane(all, this.courseOf, { moved: FAR[this.course].moved * size, turned: FAR[this.course].turned });
    this.facets = kase.facets ?? [];
    const last = this.courseOf(this.moments[this.moments.length - 1]);
    const after = this.course === "time" ? AFTER : 0;
    const end = kase.events.length > 0 ? this.courseOf(kase.events[kase.events.length - 1]) + after : last;
    /** When the film ends, in its course: of a path of equilibria with its collapse, the last event. */
    this.end = this.course === "tilt" ? end : Math.min(last, shaken ? last : end);
    this.events = kase.events.filter((event) => this.courseOf(event) <= this.end);
    const begins = this.events.length > 0 && this.course === "time" ? this.courseOf(this.events[0]) : this.end;
    /** Up to then the table rises, hastened: nothing moves on it, or by as little as contacts give way. */
    this.begins = shaken ? 0 : Math.min(begins, this.end);
    this.kind = shaken ? SHAKEN : "tilt";
  }

  /** How long the table rises, in seconds of the film. */
  get #rise() {
    return this.begins <= 0 ? 0 : this.course === "tilt" ? RISE_OF_PATH : RISE;
  }

  /** @param {number} slow how many times slower than it is the fall is shown @returns {number} seconds */
  length(slow) {
    return Math.max(SHORTEST, this.#rise + slow * (this.end - this.begins));
  }

  /** @param {number} shown seconds of the film @param {number} slow @returns {number} in its course */
  timeAt(shown, slow) {
    const rise = this.#rise;
    if (shown < rise) return (this.begins * Math.max(0, shown)) / rise;
    return Math.min(this.end, this.begins + (shown - rise) / slow);
  }

  /** @param {number} time in its course @param {number} slow @returns {number} seconds of the film */
  shownAt(time, slow) {
    return time < this.begins ? (this.#rise * time) / this.begins : this.#rise + slow * (time - this.begins);
  }

  /** @param {number} time in its course @returns {{time: number, tilt: number, x: number, y: number, turned: number}} metres, degrees */
  poseAt(time) {
    const { moments, courseOf } = this;
    let [low, high] = [0, moments.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (courseOf(moments[middle]) <= time) low = middle;
      else high = middle;
    }
    const [from, to] = [moments[low], moments[high]];
    const length = courseOf(to) - courseOf(from);
    const share = length > 0 ? Math.min(1, Math.max(0, (time - courseOf(from)) / length)) : 1;
    const between = (key) => from[key] + share * (to[key] - from[key]);
    // the collapse of a path may lie beyond its last moment: the table goes on to it
    const tilt = this.course === "tilt" ? Math.min(this.end, Math.max(courseOf(moments[0]), time)) : between("angle_deg");
    return { time, tilt, x: between("moved_x_m"), y: between("moved_y_m"), turned: between("turned_deg") };
  }

  /** @param {number} time in its course @returns {{facet: object, state: "closed"|"slips"|"open"}[]} of the facets that touched, or do */
  contactsAt(time) {
    const states = new Map((this.moments[0].reactions ?? []).map(({ facet }) => [facet, "closed"]));
    for (const event of this.events) {
      if (this.courseOf(event) > time) break;
      if (event.facet > 0 && STATES[event.what] !== undefined) states.set(event.facet, STATES[event.what]);
    }
    return this.facets.filter(({ facet }) => states.has(facet)).map((facet) => ({ facet, state: states.get(facet.facet) }));
  }

  /** The event that was the last one at a time. @returns {object|null} */
  eventAt(time) {
    let found = null;
    for (const event of this.events) if (this.courseOf(event) <= time) found = event;
    return found;
  }
}

/**
 * The moments up to the first one that no block can be at: a number is none, it lies too far off, it has turned too often, or the
 * course goes back. The first moment is kept whatever it is.
 */
function sane(moments, courseOf, far) {
  const isSane = (moment, i) => Number.isFinite(courseOf(moment)) && Number.isFinite(moment.angle_deg) && Math.hypot(moment.moved_x_m, moment.moved_y_m) <= far.moved &&
    Math.abs(moment.turned_deg) <= far.turned && (i === 0 || courseOf(moment) >= courseOf(moments[i - 1]));
  const wrong = moments.findIndex((moment, i) => !isSane(moment, i));
  return moments.slice(0, wrong < 0 ? moments.length : Math.max(1, wrong));
}

/** @param {any} kase of the answer that is drawn @param {object} outlines @param pose @returns {string} the block's transform in its frame */
export function transformOf(kase, outlines, pose) {
  const { x, y } = resultPoint(outlines, kase.block.centroid_x_m, kase.block.centroid_y_m);
  const [dx, dy] = moved(outlines, pose);
  return "translate(" + (x + dx) + " " + (y + dy) + ") rotate(" + pose.turned + ") translate(" + -x + " " + -y + ")";
}

/** What is to be seen of a film: the block on its whole way, in the frame of the outlines. @returns {number[]} x0, y0, x1, y1 */
export function wayOf(film, kase, outlines) {
  const [x0, y0, x1, y1] = outlines.box_m;
  const half = Math.hypot(x1 - x0, y1 - y0) / 2;
  const centre = resultPoint(outlines, kase.block.centroid_x_m, kase.block.centroid_y_m);
  const way = film.moments.filter((moment) => film.courseOf(moment) <= film.end).map((moment) => moved(outlines, { x: moment.moved_x_m, y: moment.moved_y_m }));
  const most = 3 * half; // one that rolls far leaves the window
  const near = (value) => Math.max(-most, Math.min(most, value));
  const [across, up] = [0, 1].map((axis) => way.map((each) => near(each[axis])));
  return [
    Math.min(x0, centre.x + Math.min(...across) - half), Math.min(y0, centre.y + Math.min(...up) - half),
    Math.max(x1, centre.x + Math.max(...across) + half), Math.max(y1, centre.y + Math.max(...up)),
  ];
}

function moved(outlines, { x, y }) {
  const { cosine, sine } = outlines.placed.results;
  return [cosine * x - sine * y, sine * x + cosine * y];
}

/** The contacts as paths in the frame of the outlines. */
export function contactPaths(outlines, contacts) {
  return contacts.map(({ facet, state }) => {
    const from = resultPoint(outlines, { value: facet.x0_m }, { value: facet.y0_m });
    const to = resultPoint(outlines, { value: facet.x1_m }, { value: facet.y1_m });
    return { state, path: "M" + from.x + " " + from.y + "L" + to.x + " " + to.y };
  });
}
