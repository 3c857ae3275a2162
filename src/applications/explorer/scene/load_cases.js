// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Load cases of a scene. The program draws one case at a time and lists all of them; the page asks for the list first, and
 * then for the case that is shown: the one that the reader chose, or the one that governs.
 *
 * @typedef {object} LoadCase
 * @property {string} name
 * @property {string} towards which side the scene tilts to in the direction that governs the case
 * @property {string} mechanism or the verdict of many blocks
 * @property {{value: number, error: number}|null} fos null: it is no number
 * @property {{value: number, error: number}|null} required null: nothing is required, or the list does not say how much
 * @property {"met"|"not met"|"undecided"|null} met null: nothing is required
 */

import { readTable } from "../panels/csv.js";

/** The severest first: requirement, then verdict; what is not listed comes last. */
const MET = ["not met", "undecided"];
const VERDICTS = ["collapses", "may move", "undecided"];

/** @param {import("./scene_text.js").SceneText} scene @returns {string[]} names of its load cases, in its order */
export function caseNames(scene) {
  const names = [];
  for (let i = 0; i < (scene.count(["cases"]) ?? 0); i++) names.push(scene.scalar(["cases", i, "name"]));
  return names.filter((name) => name !== null);
}

/** @param {"block"|"blocks"|"solid"} kind @returns {string[]} words of a command that lists the cases of such a scene */
export function listWords(kind) {
  return ["solve", kind === "blocks" ? "--csv" : "--json"];
}

/**
 * @param {"block"|"blocks"|"solid"} kind @param {string} printed by the command of `listWords` @param {string[]} names of the scene
 * @returns {{cases: LoadCase[], shown: string|null}} shown: the name of the severest; null: the list has no cases
 */
export function listedCases(kind, printed, names) {
  if (kind === "blocks") {
    const cases = casesOfTable(readTable(printed), names);
    return { cases, shown: severest(cases)?.name ?? null };
  }
  const { load_cases: listed = [], load_case: governing = null } = JSON.parse(printed);
  return { cases: listed.map(caseOfOne), shown: governing };
}

function caseOfOne({ name, towards, mechanism, fos = null, required_fos: required = null, meets_required: met = null }) {
  return { name, towards, mechanism, fos, required, met };
}

/** Of many blocks a row for each direction of each case, whose title ends with its name: of several the severest. */
function casesOfTable(rows, names) {
  return names.flatMap((name) => {
    const own = rows.filter(({ scene }) => scene.endsWith(", case " + name)).map((row) =>
      ({ name, towards: row.towards, mechanism: row.verdict, fos: factorOf(row), required: null, met: row.meets_required || null }));
    return own.length === 0 ? [] : [severest(own)];
  });
}

/** The lesser of two factors; none where one is undecided. */
function factorOf(row) {
  if ([row.fos_is, row.fos_driving_is].includes("undecided")) return null;
  const found = ["fos", "fos_driving"].filter((key) => row[key]).map((key) => ({ value: Number(row[key]), error: Number(row[key + "_error"] ?? 0) }));
  return found.sort((one, other) => one.value - other.value)[0] ?? null;
}

const place = (list, word) => (list.includes(word) ? list.indexOf(word) : list.length);

/** @param {LoadCase[]} cases @returns {LoadCase|undefined} */
function severest(cases) {
  const rank = ({ met, mechanism, fos }) => [place(MET, met), place(VERDICTS, mechanism), fos?.value ?? Infinity];
  return [...cases].sort((one, other) => {
    const [a, b] = [rank(one), rank(other)];
    const differs = a.findIndex((each, i) => each !== b[i]);
    return differs < 0 ? 0 : a[differs] - b[differs];
  })[0];
}
