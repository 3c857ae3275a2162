// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Title and name of the scene, whether the core is at work, and what of it cannot be dragged. */

import { fixedShapes } from "../drawing/fixed_shapes.js";
import { pointsButtons } from "./points_into_scene.js";

const LATE_MS = 250;

/** @param {(id: string) => HTMLElement} element @param {import("../scene/store.js").SceneStore} store @param messages */
export function sceneWords(element, store, messages) {
  let timer = null;
  const words = () => {
    element("scene-title").textContent = store.parsed.scalar(["title"]) ?? "A scene without a title";
    element("scene-name").textContent = store.name;
    element("fixed").replaceChildren(...fixedShapes(store.parsed).map((said) => {
      const item = document.createElement("li");
      item.textContent = said + ".";
      return item;
    }), ...pointsButtons(store, messages).map((button) => {
      const item = document.createElement("li");
      item.append(button);
      return item;
    }));
  };
  const state = (name) => (document.body.dataset.answer = name);
  store.addEventListener("text", words);
  store.addEventListener("text", () => state("awaited"));
  store.addEventListener("solution", () => state("there"));
  store.addEventListener("problem", () => state("none"));
  store.addEventListener("solution", () => performance.mark("first answer"), { once: true });
  store.addEventListener("busy", () => {
    clearTimeout(timer);
    if (store.busy) timer = setTimeout(() => (element("busy").textContent = "solving…"), LATE_MS);
    else element("busy").textContent = "";
  });
}
