// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Who comes for the first time sees what a hand can do here: the drawing swings with its tilt handle. It is a film of the
 * view alone: the scene, the address and what the browser keeps are not touched, and it stays within the tilts at which the
 * block is certain to stand, so that the verdict beside it stays true. Any input ends it where it began. Not where less
 * motion was asked for, and never again in this browser once anything was touched.
 */

import { say } from "../words/language.js";

const TOUCHED = "topple.touched";
const SWING = 12; // degrees to either side, at most
const LEAST = 2; // a smaller swing shows nothing
const SHARE = 0.9; // of the way to the tilt at which a motion can begin
const PERIOD_MS = 7000;
const SWINGS = 2;
const TOUCHES = ["pointerdown", "keydown", "wheel", "change", "input", "hashchange"];

/**
 * How far the drawing may swing: not below level, nor up to where the block may move.
 * @param {any} kase of the answer @returns {{down: number, up: number}|null} degrees; null: no film
 */
export function swingOf({ mechanism, tilt_angle_deg: tilt, onset }) {
  if (mechanism !== "stands" || !tilt) return null;
  const most = onset?.kind === "angle" ? SHARE * (onset.critical_angle_deg.value - onset.critical_angle_deg.error - tilt.value) : onset?.kind === "never" ? SWING : 0;
  const swing = { down: Math.min(SWING, tilt.value), up: Math.min(SWING, most) };
  return swing.down >= LEAST && swing.up >= LEAST ? swing : null;
}

/** @param {{down: number, up: number}} swing @param {number} ms since it began @returns {number|null} degrees from the tilt of the scene; null: it has ended */
export function swingAt({ down, up }, ms) {
  const swings = Math.max(0, ms) / PERIOD_MS;
  if (swings >= SWINGS) return null;
  const sine = Math.sin(2 * Math.PI * swings);
  return (sine > 0 ? up : down) * sine;
}

/** @param {import("../drawing/drawing.js").Drawing} drawing @param {import("../scene/store.js").SceneStore} store @param {(words: string) => void} tell */
export function firstGesture(drawing, store, tell) {
  if (wasTouched() || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const swing = drawing.case === null ? null : swingOf(drawing.case);
  if (swing === null) return;
  const begin = performance.now();
  let frame = 0;
  const step = (now) => {
    const degrees = swingAt(swing, now - begin);
    if (degrees === null) {
      end();
      return;
    }
    drawing.swingBy(degrees);
    frame = requestAnimationFrame(step);
  };
  const end = () => {
    cancelAnimationFrame(frame);
    for (const event of TOUCHES) removeEventListener(event, touched, true);
    store.removeEventListener("text", end);
    document.body.classList.remove("inviting");
    tell("");
    drawing.swingBy(0);
  };
  const touched = () => {
    end();
    remember();
  };
  for (const event of TOUCHES) addEventListener(event, touched, true);
  store.addEventListener("text", end);
  document.body.classList.add("inviting");
  tell(say("Take the blue handle, or any vertex, and drag"));
  frame = requestAnimationFrame(step);
}

function wasTouched() {
  try {
    return localStorage.getItem(TOUCHED) !== null;
  } catch {
    return false;
  }
}

function remember() {
  try {
    localStorage.setItem(TOUCHED, "1");
  } catch {
    // a browser that keeps nothing shows it each time
  }
}
