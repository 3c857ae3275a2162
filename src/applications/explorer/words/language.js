// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The language of the page: English phrases, and what stands for them in the reader's language, by the program's table
 * (src/core/terms/phrases.csv) and the page's own beside this file. The page holds both as JSON in its element #phrases.
 * Of what the program itself says sheets are translated by it, and its most common messages here (refusals.js); explanations
 * and the report as text are English, as on the command line.
 */

const KEPT = "topple.language";
const ENGLISH = "en";
const ARGUMENT = /%(?:(\d+)\$)?s/g;

/** @typedef {{codes: string[], decimals: Record<string, string>, phrases: Record<string, Record<string, string>>, refusals?: Record<string, [string, string][]>}} Table */

/**
 * @param {string} wanted of the reader, or "": as the browser has it
 * @param {readonly string[]} languages of the browser, the favourite first
 * @param {string[]} codes that there are
 * @returns {string}
 */
export function chosenLanguage(wanted, languages, codes) {
  const found = [wanted, ...languages.map((each) => each.toLowerCase().split("-")[0])].find((code) => codes.includes(code));
  return found ?? ENGLISH;
}

/**
 * The sign before decimals: as the reader's region has it where the browser tells one for this language (es-MX has a point,
 * es-ES a comma), else as the language has it.
 * @param {string} language @param {readonly string[]} languages @param {Record<string, string>} decimals of each language
 */
export function decimalSign(language, languages, decimals) {
  const own = languages.find((each) => each.toLowerCase().split("-")[0] === language && each.includes("-"));
  return own === undefined ? decimals[language] ?? "." : new Intl.NumberFormat(own).format(1.5).includes(",") ? "," : ".";
}

/** @param {string} phrase with %s or %1$s @param {any[]} given @returns {any[]} texts, and what was given, in order */
export function filled(phrase, given) {
  const found = [];
  let at = 0;
  let next = 0;
  for (const match of phrase.matchAll(ARGUMENT)) {
    found.push(phrase.slice(at, match.index), given[match[1] === undefined ? next++ : Number(match[1]) - 1]);
    at = match.index + match[0].length;
  }
  return [...found, phrase.slice(at)].filter((part) => part !== "");
}

/** @returns {Storage|null} */
function storage() {
  try {
    return globalThis.localStorage ?? null;
  } catch {
    return null; // refused by the reader's settings: the browser's own language is taken
  }
}

const held = globalThis.document?.getElementById("phrases")?.textContent;
/** @type {Table} */
const TABLE = held ? JSON.parse(held) : { codes: [ENGLISH], decimals: { [ENGLISH]: "." }, phrases: {} };
const BROWSERS = held ? navigator.languages : [];

/** What was chosen from the menu; "": as the browser has it. */
export const chosen = storage()?.getItem(KEPT) ?? "";
export const language = chosenLanguage(chosen, BROWSERS, TABLE.codes);
const SIGN = held ? decimalSign(language, BROWSERS, TABLE.decimals) : ".";
const OWN = TABLE.phrases[language] ?? {};
/** Messages of the program, and what stands for each. @type {[string, string][]} */
export const refusals = TABLE.refusals?.[language] ?? [];

/** Whether "%s" stands in it or not, a phrase without translation stays English. @param {string} phrase @param {...any} given @returns {string} */
export function say(phrase, ...given) {
  const own = Object.hasOwn(OWN, phrase) ? OWN[phrase] : phrase;
  return given.length === 0 ? own : filled(own, given).join("");
}

/** As `say`, where elements of the page are among what is given. @returns {any[]} children of an element */
export function parts(phrase, ...given) {
  return filled(Object.hasOwn(OWN, phrase) ? OWN[phrase] : phrase, given);
}

/** What stands between two numbers: beside a decimal comma another one would be taken for it. */
export const between = SIGN === "." ? ", " : "; ";

/** A number's text with the reader's sign before decimals. @param {string} text */
export function numeral(text) {
  return SIGN === "." ? text : text.replace(/(\d)\.(?=\d)/g, "$1" + SIGN);
}

/** Texts and titles of the page as it was written, in the reader's language. @param {ParentNode} root */
export function translate(root) {
  if (language === ENGLISH) return;
  document.documentElement.lang = language;
  const texts = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  for (let node = texts.nextNode(); node !== null; node = texts.nextNode()) {
    const plain = node.data.trim();
    if (plain !== "" && !node.parentElement.closest("script, style")) node.data = node.data.replace(plain, () => say(plain));
  }
  for (const name of ["title", "aria-label"]) {
    for (const each of root.querySelectorAll("[" + name + "]")) each.setAttribute(name, say(each.getAttribute(name)));
  }
}

/** The languages by their own names. @type {Record<string, string>} */
const NAMES = { en: "English", es: "Español", de: "Deutsch" };

/** The menu of languages; the page begins anew in the one that is chosen, with the scene that it keeps. @param {HTMLSelectElement} select */
export function languageMenu(select) {
  select.append(...TABLE.codes.map((code) => new Option(NAMES[code] ?? code, code)));
  select.value = chosen;
  if (storage() === null) select.closest("label").hidden = true;
  select.addEventListener("change", () => {
    if (select.value === "") storage().removeItem(KEPT);
    else storage().setItem(KEPT, select.value);
    location.reload();
  });
}
