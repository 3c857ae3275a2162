// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The report of a scene in the language of the page: in English the text that the command line prints; in others, which that text
 * is not translated to, the calculation sheet, which is.
 */

import { element } from "./element.js";
import { language, say } from "../words/language.js";

const REPORT_MAX_MS = 60_000;
const BROKEN = { least: 76, most: 82 }; // characters of a line, with the word that it had no room for, and without
const SHEET = ".report.html";

/** What asks for a sheet in that of the page, where the scene names none. @param {import("../scene/store.js").SceneStore} store @returns {string[]} */
export function languageWords(store) {
  return language === "en" || store.parsed.scalar(["report", "language"]) !== null ? [] : ["--language", language];
}

/** Of one block the report lists all load cases, and is of the one that governs; of many blocks it is of one case. @returns {string[]} */
export function reportedCase(store) {
  return store.solution?.kind === "blocks" ? store.caseWords : [];
}

/**
 * @param {import("./panel.js").Panel} panel whose scene it is @param {{run: Function}} core
 * @returns {Promise<Element>}
 */
export async function reportOf(panel, core) {
  const { store } = panel;
  const asked = language === "en" ? [] : ["--quiet", "--report", SHEET, ...languageWords(store)];
  const answer = await core.run(["solve", ...asked, ...reportedCase(store), store.argument], panel.files(), { latest: "report", timeoutMs: REPORT_MAX_MS, collect: [SHEET] });
  const sheet = answer.files[SHEET];
  return sheet === undefined ? textOf(answer.out + answer.err) : sheetOf(sheet);
}

/** Lines as they stand, but for sentences that go on in the next line, which are as wide as their place. @param {string} text */
export function textOf(text) {
  const lines = text.split(/(?<=\n)/);
  const parts = [];
  for (let at = 0; at < lines.length; at++) {
    const from = at;
    while (at + 1 < lines.length && goesOn(lines[at], lines[at + 1])) at++;
    const part = lines.slice(from, at + 1).join("");
    parts.push(at === from ? part : element("span", { class: "prose", style: "padding-left: " + /^ */.exec(part)[0].length + "ch" }, part));
  }
  return element("pre", { class: "wide", tabindex: 0, "aria-label": "Report" }, parts);
}

/** Of a line that the next one's first word would have been too long for; neither is in columns. */
function goesOn(line, next) {
  const [[, indent, words], [, indentThere, wordsThere]] = [line, next].map((each) => /^( *)(.*)/.exec(each));
  const long = indent.length + words.length;
  return indent === indentThere && wordsThere !== "" && !(words + wordsThere).includes("  ") && long <= BROKEN.most && long + 1 + wordsThere.split(" ")[0].length > BROKEN.least;
}

/** As a page of its own, in which no script runs. */
function sheetOf(bytes) {
  const address = URL.createObjectURL(new Blob([bytes], { type: "text/html" }));
  const loaded = ({ target }) => {
    URL.revokeObjectURL(address);
    target.classList.remove("loading");
  };
  return element("iframe", { class: "sheet-of-scene loading", sandbox: "", title: say("Report"), src: address, onload: loaded });
}
