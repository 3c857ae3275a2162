// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The report of a scene in the language of the page: in English the text that the command line prints; in others, which that text
 * is not translated to, the calculation sheet, which is.
 */

import { element } from "./element.js";
import { language, say } from "../words/language.js";

const REPORT_MAX_MS = 60_000;
const BROKEN = 60; // characters at which a sentence may go on in the next line
const SHEET = ".report.html";

/** What asks for a sheet in that of the page, where the scene names none. @param {import("../scene/store.js").SceneStore} store @returns {string[]} */
export function languageWords(store) {
  return language === "en" || store.parsed.scalar(["report", "language"]) !== null ? [] : ["--language", language];
}

/**
 * @param {import("./panel.js").Panel} panel whose scene it is @param {{run: Function}} core
 * @returns {Promise<Element>}
 */
export async function reportOf(panel, core) {
  const { store } = panel;
  const asked = language === "en" ? [] : ["--quiet", "--report", SHEET, ...languageWords(store)];
  const answer = await core.run(["solve", ...asked, store.argument], panel.files(), { latest: "report", timeoutMs: REPORT_MAX_MS, collect: [SHEET] });
  const sheet = answer.files[SHEET];
  return sheet === undefined ? textOf(answer.out + answer.err) : sheetOf(sheet);
}

/** Lines as they stand, but for paragraphs of sentences, which are as wide as the page. @param {string} text */
export function textOf(text) {
  const parts = text.split(/(?<=\n)(?=\n)/).map((part) => (isProse(part) ? element("span", { class: "prose" }, part) : part));
  return element("pre", { class: "wide", tabindex: 0, "aria-label": "Report" }, parts);
}

/** Several lines, as long as words let them be, neither indented nor in columns. */
function isProse(part) {
  const lines = part.replace(/^\n|\n$/g, "").split("\n");
  return lines.length > 1 && lines.every((line) => /^\S/.test(line) && !line.includes("  ")) && lines.slice(0, -1).every(({ length }) => length >= BROKEN);
}

/** As a page of its own, in which no script runs. */
function sheetOf(bytes) {
  const address = URL.createObjectURL(new Blob([bytes], { type: "text/html" }));
  return element("iframe", { class: "sheet-of-scene", sandbox: "", title: say("Report"), src: address, onload: () => URL.revokeObjectURL(address) });
}
