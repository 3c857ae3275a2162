// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** A button for each shape that stands in a CSV file: its points go into the scene, where they can be dragged. */

import { SHAPES } from "../drawing/fixed_shapes.js";
import { pointsOfCsv } from "../scene/csv_points.js";
import { say } from "../words/language.js";

/** @param {import("../scene/store.js").SceneStore} store @param messages @returns {HTMLElement[]} */
export function pointsButtons(store, messages) {
  return SHAPES.flatMap(({ path, what }) => {
    const content = store.files[store.parsed.scalar(path) ?? ""];
    const points = typeof content === "string" ? pointsOfCsv(content) : null;
    if (points === null) return [];
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = say("%s: write its points into the scene", say(what));
    button.addEventListener("click", () => write(store, messages, path, points));
    return [button];
  });
}

/** Only where the block then is the same: else the scene stays as it was. */
function write(store, messages, path, points) {
  const before = JSON.stringify(drawnOf(store.solution));
  store.setNumber(path, points);
  const check = () => {
    store.removeEventListener("solution", check);
    store.removeEventListener("problem", check);
    if (store.solution !== null && JSON.stringify(drawnOf(store.solution)) === before) return;
    store.undo();
    messages.say(say("The points of the file mean something else in the scene; it is left as it was."));
  };
  store.addEventListener("solution", check);
  store.addEventListener("problem", check);
}

function drawnOf(solution) {
  const { origin_x_m, origin_y_m, block, base } = solution?.outlines ?? {};
  return [origin_x_m, origin_y_m, block, base];
}
