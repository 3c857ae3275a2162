// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Which load case of a scene is drawn and judged: a menu below the verdict, with what each case lacks. */

import { caseNames } from "../scene/load_cases.js";
import { say } from "../words/language.js";

/** @param {HTMLElement} label @param {HTMLSelectElement} select within it @param {import("../scene/store.js").SceneStore} store */
export function loadCaseChoice(label, select, store) {
  const list = (names, loadCases) => {
    const metOf = (name) => loadCases?.cases.find((each) => each.name === name)?.met ?? null;
    select.replaceChildren(...names.map((name) => new Option(["not met", "undecided"].includes(metOf(name)) ? name + ": " + say(metOf(name)) : name, name)));
    select.value = loadCases?.shown ?? "";
    label.hidden = names.length === 0;
  };
  store.addEventListener("solution", () => list(caseNames(store.parsed), store.solution.loadCases));
  store.addEventListener("text", () => {
    // while a case that was chosen is solved, the menu stays as it is
    const names = caseNames(store.parsed);
    if (store.lastSolution === null && names.join("\n") !== [...select.options].map(({ value }) => value).join("\n")) list(names, null);
  });
  select.addEventListener("change", () => store.chooseCase(select.value));
}
