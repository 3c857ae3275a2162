// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The tilt test as the core simulates it (`topple tilt`), as a film: where the block is at each moment, and what each
 * contact does. Between two moments of the answer the block is drawn on the straight way from one to the other; beyond
 * the last one nothing is shown.
 */

import { resultPoint } from "./result_point.js";

const RISE = 2.5; // seconds of the film in which the table rises to where the block begins to move
const AFTER = 0.6; // seconds shown after the last event
const SHAKEN = "shaking";

/** What a contact does after an event. */
const STATES = { opens: "open", closes: "closed", slips: "slips", sticks: "closed", accumulates: "closed" };

export class Film {
  /** @param {any} kase of `topple tilt --json` @param {boolean} shaken the base shakes: nothing of it is hastened */
  constructor(kase, shaken = false) {
    this.moments = kase.moments;
    this.facets = kase.facets ?? [];
    const last = this.moments[this.moments.length - 1].time_s;
    const end = kase.events.length > 0 ? kase.events[kase.events.length - 1].time_s + AFTER : last;
    /** When the film ends, in the test's own seconds. */
    this.end = Math.min(last, shaken ? last : end);
    this.events = kase.events.filter(({ time_s: time }) => time <= this.end);
    const begins = this.events[0]?.time_s ?? this.end;
    /** Up to then the table rises, hastened: nothing moves on it. */
    this.begins = shaken ? 0 : Math.min(begins, this.end);
    this.kind = shaken ? SHAKEN : "tilt";
  }

  /** @param {number} slow how many times slower than it is the fall is shown @returns {number} seconds */
  length(slow) {
    return (this.begins > 0 ? RISE : 0) + slow * (this.end - this.begins);
  }

  /** @param {number} shown seconds of the film @param {number} slow @returns {number} seconds of the test */
  timeAt(shown, slow) {
    const rise = this.begins > 0 ? RISE : 0;
    if (shown < rise) return (this.begins * Math.max(0, shown)) / rise;
    return Math.min(this.end, this.begins + (shown - rise) / slow);
  }

  /** @param {number} time of the test @param {number} slow @returns {number} seconds of the film */
  shownAt(time, slow) {
    const rise = this.begins > 0 ? RISE : 0;
    return time < this.begins ? (rise * time) / this.begins : rise + slow * (time - this.begins);
  }

  /** @param {number} time @returns {{time: number, tilt: number, x: number, y: number, turned: number}} metres, degrees */
  poseAt(time) {
    const { moments } = this;
    let [low, high] = [0, moments.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (moments[middle].time_s <= time) low = middle;
      else high = middle;
    }
    const [from, to] = [moments[low], moments[high]];
    const share = to.time_s > from.time_s ? Math.min(1, Math.max(0, (time - from.time_s) / (to.time_s - from.time_s))) : 1;
    const between = (key) => from[key] + share * (to[key] - from[key]);
    return { time, tilt: between("angle_deg"), x: between("moved_x_m"), y: between("moved_y_m"), turned: between("turned_deg") };
  }

  /** @param {number} time @returns {{facet: object, state: "closed"|"slips"|"open"}[]} of the facets that touched, or do */
  contactsAt(time) {
    const states = new Map((this.moments[0].reactions ?? []).map(({ facet }) => [facet, "closed"]));
    for (const { what, facet, time_s: when } of this.events) {
      if (when > time) break;
      if (facet > 0 && STATES[what] !== undefined) states.set(facet, STATES[what]);
    }
    return this.facets.filter(({ facet }) => states.has(facet)).map((facet) => ({ facet, state: states.get(facet.facet) }));
  }

  /** The event that was the last one at a time. @returns {object|null} */
  eventAt(time) {
    let found = null;
    for (const event of this.events) if (event.time_s <= time) found = event;
    return found;
  }
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
  const way = film.moments.filter(({ time_s: time }) => time <= film.end).map((moment) => moved(outlines, { x: moment.moved_x_m, y: moment.moved_y_m }));
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
