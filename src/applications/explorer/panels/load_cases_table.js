// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** All load cases of a scene above the verdict of the one that is shown, in the order of the program's list. */

import { fosText } from "./certain.js";
import { element, table } from "./element.js";
import { sentence } from "./words.js";
import { say } from "../words/language.js";

/** @param {any} solution with its load cases @param {import("./terms.js").Terms} terms @returns {Element[]} none where it has none */
export function loadCasesTable({ loadCases }, terms) {
  if (!loadCases || loadCases.cases.length === 0) return [];
  const rows = loadCases.cases.map(({ name, mechanism, towards, fos, required, met }) => ({
    marked: name === loadCases.shown,
    cells: [name, sentence(say(mechanism)), say(towards), fos === null ? "—" : fosText(fos), requirement(required, met)],
  }));
  return [
    element("h3", {}, say("Load cases")),
    table(say("Load cases"), [say("case"), say("Verdict"), say("towards"), terms.word("FoS"), say("required")], rows),
    element("p", { class: "told" }, say("All else on this page is of the load case “%s”.", loadCases.shown)),
  ];
}

/** What is required, where the list says how much, and whether it is met. */
function requirement(required, met) {
  return [required === null ? "" : fosText(required), met === null ? "" : say(met)].filter((part) => part !== "").join(", ") || "—";
}
