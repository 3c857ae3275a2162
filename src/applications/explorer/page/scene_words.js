// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Whether there is an answer, and whether the core is at work. */

import { say } from "../words/language.js";

const LATE_MS = 250;

/** @param {(id: string) => HTMLElement} element @param {import("../scene/store.js").SceneStore} store */
export function sceneWords(element, store) {
  let timer = null;
  const state = (name) => (document.body.dataset.answer = name);
  store.addEventListener("text", () => state("awaited"));
  store.addEventListener("solution", () => state("there"));
  store.addEventListener("problem", () => state("none"));
  store.addEventListener("solution", () => performance.mark("first answer"), { once: true });
  store.addEventListener("busy", () => {
    clearTimeout(timer);
    if (store.busy) timer = setTimeout(() => (element("busy").textContent = say("solving…")), LATE_MS);
    else element("busy").textContent = "";
  });
}
