// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Table 3 of Alejano et al., each row solved by the core from the example of its name. */

import { examples } from "../examples/examples.js";
import { element, table } from "../panels/element.js";
import { degreesText } from "../panels/certain.js";
import { numeral, say } from "../words/language.js";
import { refusalOf } from "../scene/complaint.js";

const SOLVE_MAX_MS = 15_000;

/** Block, axis, the critical angle α_ana that is printed, the example and its direction. */
export const ROWS = [
  ["A", "peak", 26.2, "block_a_peak.yaml", "left"],
  ["A", "valley", 23.9, "block_a_valley.yaml", "left"],
  ["B", "peak", 17.6, "block_b_peak.yaml", "left"],
  ["B", "valley", 16.4, "block_b_valley.yaml", "left"],
  ["C", "valley", 25.4, "block_c.yaml", "left"],
  ["C", "valley", 25.4, "block_c.yaml", "right"],
  ["D", "peak", 18.5, "block_d.yaml", "left"],
  ["D", "peak", 18.5, "block_d.yaml", "right"],
  ["E", "valley", 35.2, "block_e_valley.yaml", "left"],
  ["E", "peak", 37.5, "block_e_peak.yaml", "left"],
  ["F", "valley", 25.6, "block_f.yaml", "left"],
  ["F", "valley", 25.6, "block_f.yaml", "right"],
  ["G", "peak", 26.5, "block_g.yaml", "left"],
  ["G", "peak", 26.5, "block_g.yaml", "right"],
];

/**
 * @param {{run: Function}} core
 * @param {(name: string) => void} open an example
 * @returns {Promise<HTMLElement>}
 */
export async function tableThree(core, open) {
  const solved = new Map();
  const rows = [];
  for (const [block, axis, printed, name, towards] of ROWS) {
    if (!solved.has(name)) solved.set(name, await solve(core, name));
    const theCase = solved.get(name).cases.find((each) => each.towards === towards);
    const { toppling, limit, first } = theCase;
    const earlier = limit.critical_angle_deg.value + limit.critical_angle_deg.error < toppling.critical_angle_deg.value - toppling.critical_angle_deg.error;
    rows.push({
      marked: earlier,
      cells: [
        element("button", { type: "button", onclick: () => open(name), title: say("Open %s", name) }, block),
        say(axis) + ", " + say(towards), numeral(printed.toFixed(1)) + "°", degreesText(toppling.critical_angle_deg),
        degreesText(limit.critical_angle_deg), say(first.mechanism),
      ],
    });
  }
  return table(say("Table 3"), ["block", "towards", "printed", "by moments", "by contact forces", "it"].map((head) => say(head)), rows);
}

async function solve(core, name) {
  const { text, files } = examples.find((example) => example.name === name);
  const answer = await core.run(["solve", "--json", name], { ...files, [name]: text }, { timeoutMs: SOLVE_MAX_MS });
  if (answer.out === "") throw refusalOf(answer);
  return JSON.parse(answer.out);
}
