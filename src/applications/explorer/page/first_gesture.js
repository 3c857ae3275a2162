// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Who comes for the first time sees what a hand can do here: the table swings by itself, and what the block does follows,
 * until anything is touched. Not where less motion was asked for, and never again in this browser.
 */

import { decimalValue, snap } from "../scene/decimal.js";
import { say } from "../words/language.js";

const TOUCHED = "topple.touched";
const SWING = 12; // degrees to either side
const PERIOD_MS = 7000;
const SWINGS = 2;
const PATH = ["tilt", "angle_deg"];

/** @param {import("../scene/store.js").SceneStore} store @param {(words: string) => void} tell */
export function firstGesture(store, tell) {
  if (wasTouched() || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const middle = decimalValue(store.parsed.scalar(PATH) ?? "");
  if (middle === null) return;
  const begin = performance.now();
  let frame = 0;
  const put = (degrees) => store.setNumber(PATH, snap(degrees, -1), { mergeWith: "first gesture" });
  const step = (now) => {
    const swings = Math.max(0, now - begin) / PERIOD_MS;
    put(middle + (swings < SWINGS ? SWING * Math.sin(2 * Math.PI * swings) : 0));
    if (swings < SWINGS) frame = requestAnimationFrame(step);
    else stop();
  };
  const stop = () => {
    cancelAnimationFrame(frame);
    store.endGesture();
    document.body.classList.remove("inviting");
    for (const event of TOUCHES) removeEventListener(event, stop, true);
    remember();
    tell("");
  };
  for (const event of TOUCHES) addEventListener(event, stop, true);
  document.body.classList.add("inviting");
  tell(say("Take the blue handle, or any vertex, and drag"));
  frame = requestAnimationFrame(step);
}

const TOUCHES = ["pointerdown", "keydown", "wheel", "change"];

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
