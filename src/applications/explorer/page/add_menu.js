// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The menu that gives a scene water, an anchor, an earthquake, cohesion, or corners of its own, to be dragged then. */

import { ringOf } from "../drawing/rings.js";
import { ADDITIONS } from "../scene/additions.js";
import { say } from "../words/language.js";

/** @param {HTMLSelectElement} select @param {import("../drawing/drawing.js").Drawing} drawing @param store @param messages */
export function addMenu(select, drawing, store, messages) {
  const options = Object.entries(ADDITIONS).map(([name, { label }]) => new Option(say(label), name));
  select.append(...options);
  select.addEventListener("change", () => {
    const addition = ADDITIONS[select.value];
    select.value = "";
    try {
      store.setText(addition.text(store.parsed, sizesOf(drawing)));
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      messages.say(say(addition.label) + ": " + error.message);
    }
  });
  const update = () => {
    const known = drawing.context !== null && !drawing.context.many && drawing.context.block !== null && store.parsed.unread === null;
    const sizes = known ? sizesOf(drawing) : null;
    for (const option of options) option.disabled = !known || ADDITIONS[option.value].has(store.parsed, sizes);
  };
  for (const event of ["pointerdown", "focus"]) select.addEventListener(event, update);
}

/** @returns {import("../scene/additions.js").Sizes} */
function sizesOf({ context }) {
  const { block } = context.kase;
  const [, bottom, , top] = context.outlines.box_m;
  const at = context.result(block.centroid_x_m, block.centroid_y_m);
  return {
    height: (top - bottom) / context.metres,
    centroid: context.block.toScene(at.x, at.y),
    weightKn: block.weight_n ? block.weight_n.value / 1000 : null,
    ring: ringOf(context),
  };
}
