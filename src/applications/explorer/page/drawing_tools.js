// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Buttons and keys of the drawing: fit, closer, farther, move, which of two tilts. */

import { say } from "../words/language.js";

const CLOSER = 1.3;
const MOVE = 0.1;

const KEYS = {
  "+": (drawing) => drawing.zoomBy(CLOSER),
  "=": (drawing) => drawing.zoomBy(CLOSER),
  "-": (drawing) => drawing.zoomBy(1 / CLOSER),
  0: (drawing) => drawing.fit(),
  ArrowLeft: (drawing) => drawing.zoomBy(1, MOVE, 0),
  ArrowRight: (drawing) => drawing.zoomBy(1, -MOVE, 0),
  ArrowUp: (drawing) => drawing.zoomBy(1, 0, MOVE),
  ArrowDown: (drawing) => drawing.zoomBy(1, 0, -MOVE),
};

/** @param {(id: string) => HTMLElement} element @param {import("../drawing/drawing.js").Drawing} drawing @param store */
export function drawingTools(element, drawing, store) {
  element("fit").addEventListener("click", () => drawing.fit());
  element("closer").addEventListener("click", () => drawing.zoomBy(CLOSER));
  element("farther").addEventListener("click", () => drawing.zoomBy(1 / CLOSER));
  const pane = element("drawing");
  pane.tabIndex = 0;
  pane.setAttribute("aria-label", say("Drawing: + and - zoom, arrow keys move, 0 fits; Tab leads to the handles"));
  pane.addEventListener("keydown", (event) => {
    const act = KEYS[event.key];
    if (act === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act(drawing);
  });
  drawing.addEventListener("told", () => (element("told").textContent = drawing.words));
  let openings = store.openings;
  store.addEventListener("text", () => {
    // what was told of another scene's handles goes with it
    if (store.openings !== openings) element("told").textContent = "";
    openings = store.openings;
  });
  casesChoice(element("cases"), drawing, store);
}

function casesChoice(fieldset, drawing, store) {
  let shown = "";
  store.addEventListener("text", () => {
    if (store.lastSolution !== null) return;
    shown = "";
    fieldset.hidden = true;
  });
  store.addEventListener("solution", () => {
    const sides = store.solution.cases.map((kase) => kase.towards);
    if (sides.join() === shown) return;
    shown = sides.join();
    drawing.showCase(0);
    fieldset.hidden = sides.length < 2;
    fieldset.replaceChildren(fieldset.querySelector("legend"), ...sides.map((side, index) => sideChoice(side, index, drawing)));
  });
}

function sideChoice(side, index, drawing) {
  const label = document.createElement("label");
  const radio = document.createElement("input");
  radio.type = "radio";
  radio.name = "case";
  radio.checked = index === 0;
  radio.addEventListener("change", () => drawing.showCase(index));
  label.append(radio, " " + say(side));
  return label;
}
