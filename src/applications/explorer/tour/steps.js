// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The seven steps of the tour: which scene, what to look at, what to try, and what is found: sentences of the present
 * answer, so that they follow what the reader does.
 */

import { degreesText, fosText } from "../panels/certain.js";
import { againstText } from "../panels/words.js";
import { say } from "../words/language.js";

/**
 * @typedef {object} Step
 * @property {string} title
 * @property {string} example the scene that it begins with
 * @property {string} tab what to look at
 * @property {string[]} says
 * @property {{label: string, example?: string, numbers?: {path: (string|number)[], text: string}[]}[]} tries
 * @property {(solution: any) => string|null} finds
 * @property {{path: (string|number)[], text: string}[]} [begins] numbers that it begins with, other than the example's
 * @property {string} [across] the number that runs across on the map
 * @property {boolean} [table] Table 3 stands below it
 */

const tilt = (text) => ({ path: ["tilt", "angle_deg"], text });
const friction = (text) => ({ path: ["friction_angle_deg"], text });
const beyond = (text) => ({ path: ["base", "beyond", "left"], text });

/** @type {Step[]} */
export const STEPS = [
  {
    title: say("A slab"),
    example: "slab_left.yaml",
    tab: "curves",
    says: [
      say("A block topples about its toe when its weight passes it. This slab is half as wide as high, so that happens at arctan ½ = 26.565°; below that, the factor of safety is the stabilising over the overturning moment, tan 26.565° / tan α."),
      say("Drag the handle of the tilt, or try these."),
    ],
    tries: [
      { label: say("Tilt it by 20°"), numbers: [tilt("20")] },
      { label: say("by 26°"), numbers: [tilt("26")] },
      { label: say("by 27°"), numbers: [tilt("27")] },
    ],
    finds: (solution) => {
      const { tilt_angle_deg: at, mechanism, governing_fos: governing } = solution.cases[0];
      if (!at) return say("It topples at %s.", degreesText(solution.cases[0].toppling?.critical_angle_deg));
      if (!governing.fos) return say("At %s it %s.", degreesText(at), say(mechanism));
      return say("At %s it %s with a factor of safety of %s against %s.", degreesText(at), say(mechanism), fosText(governing.fos), againstText(governing.mechanism));
    },
  },
  {
    title: say("Teeth"),
    example: "block_a_peak.yaml",
    tab: "pivots",
    says: [
      say("Now the base is rough: block A of the paper by Alejano and others stands on three teeth. It cannot turn about every vertex: about some, another tooth is in the way. Pivots that are free and those that are blocked stand in the table."),
      say("Tilted one way its toe is a peak of the underside, the other way a valley; the height of its centroid over that decides."),
    ],
    tries: [
      { label: say("Towards its peak"), example: "block_a_peak.yaml" },
      { label: say("Towards its valley"), example: "block_a_valley.yaml" },
    ],
    finds: (solution) => {
      const { pivots, toppling } = solution.cases[0];
      if (!toppling) return null;
      const free = pivots.filter(({ admissible }) => admissible).length;
      return say("By moments it topples about its %s at %s; pivots that are free: %s of %s.", say(pivots[toppling.pivot].kind),
        degreesText(toppling.critical_angle_deg), free, pivots.length);
    },
  },
  {
    title: say("Table 3"),
    example: "block_a_valley.yaml",
    tab: "pivots",
    table: true,
    says: [
      say("The paper's Table 3 has such angles for seven blocks. Each row below is solved here and now, from the example of its name: the angle by moments agrees with the printed one."),
      say("But moments do not ask whether friction can hold the toe. Contact forces do, and some blocks move earlier: the marked rows."),
    ],
    tries: [],
    finds: () => null,
  },
  {
    title: say("Block E's puzzle"),
    example: "block_e_valley.yaml",
    tab: "forces",
    says: [
      say("Block E towards its valley: the formula says 35.2°, and the paper saw it slide long before. Why?"),
      say("At 35.2° all of its weight would rest on the toe. The facet there falls away down-dip, and friction on it is exhausted at φ − 9.5°. So the next facet has to carry a share; the two forces below are the last that can hold it, each at the edge of its friction cone."),
    ],
    tries: [{ label: say("Tilt it by 28.7°"), numbers: [tilt("28.7")] }, { label: say("by 28.8°"), numbers: [tilt("28.8")] }],
    finds: (solution) => {
      const { limit, toppling, toe } = solution.cases[0];
      if (!limit?.critical_angle_deg || !toppling) return null;
      return say("Moments alone give %s, but the toe can bear all the weight up to %s only: it begins to move at %s and %s.",
        degreesText(toppling.critical_angle_deg), degreesText(toe.limit_angle_deg), degreesText(limit.critical_angle_deg), say(limit.mechanism));
    },
  },
  {
    title: say("A base that goes on"),
    example: "block_e_valley.yaml",
    tab: "forces",
    says: [
      say("The base of step 4 ends at the toe. If it goes on, the block's toe lies in a notch of the rock: the flank of the next tooth stands against it and holds it. Let the base go on by the width of a tooth."),
      say("In the scene that is base: beyond: left. The result depends on where the base ends, so a scene has to state it."),
    ],
    tries: [
      { label: say("Let the base go on by 30 mm"), numbers: [beyond("30")] },
      { label: say("End it at the toe"), numbers: [beyond("0")] },
    ],
    finds: (solution) => {
      const { limit, contact } = solution.cases[0];
      if (!limit?.critical_angle_deg || !contact) return null;
      const base = say(limit.base_beyond_toe ? "extends past the toe" : "ends at the toe");
      return say("On a base that %s block E is held up to %s, then it %s.", base, degreesText(limit.critical_angle_deg), say(limit.mechanism));
    },
  },
  {
    title: say("History"),
    example: "block_a_peak.yaml",
    tab: "map",
    across: "friction_angle_deg",
    begins: [tilt("20")],
    says: [
      say("That some forces would hold a block does not mean that they are there. With high friction, block A is certain to stand up to one tilt and to move beyond another; between them it depends on loading history."),
      say("The map shows where: drag the point through it."),
    ],
    tries: [
      { label: say("Friction of 30°"), numbers: [friction("30")] },
      { label: say("of 60°, tilted by 28°"), numbers: [friction("60"), tilt("28")] },
    ],
    finds: (solution) => {
      const { onset, limit, mechanism, tilt_angle_deg: at } = solution.cases[0];
      if (onset?.kind !== "angle" || !limit?.critical_angle_deg) return null;
      const there = at ? " " + say("At %s it %s.", degreesText(at), say(mechanism)) : "";
      if (!onset.below_limit) return say("Both are %s: loading history has no influence.", degreesText(onset.critical_angle_deg)) + there;
      return say("Certain to stand up to %s, certain to move beyond %s.", degreesText(onset.critical_angle_deg), degreesText(limit.critical_angle_deg)) + there;
    },
  },
  {
    title: say("An irregular base"),
    example: "partial_contact.yaml",
    tab: "pivots",
    says: [
      say("No formula is needed: any outline on any profile is solved the same way. Here teeth rest on a base that is worn between them, and touch it on three facets of five."),
      say("Drag a vertex of the base or of the block, or write your own points into the text."),
    ],
    tries: [
      { label: say("A worn base"), example: "partial_contact.yaml" },
      { label: say("A boulder on rough ground"), example: "boulder_on_rough_ground.yaml" },
      { label: say("A block set down on uneven ground"), example: "resting_block.yaml" },
    ],
    finds: (solution) => {
      const { contact, first, towards } = solution.cases[0];
      const points = contact.points === 0 ? "" : contact.points === 1 ? say("one point") : say("%s points", contact.points);
      const facets = contact.facets === 0 ? "" : contact.facets === 1 ? say("one facet") : say("%s facets", contact.facets);
      const touches = [facets, points].filter((each) => each !== "").join(" " + say("and") + " ");
      const does = first.critical_angle_deg ? say("%s at %s", say(first.mechanism), degreesText(first.critical_angle_deg)) : say(first.mechanism);
      return say("It touches in %s; %s it %s.", touches, say("tilted towards the " + towards), does);
    },
  },
];
