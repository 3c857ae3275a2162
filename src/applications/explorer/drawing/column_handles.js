// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Columns that are made of numbers: their width, and the tops of the crest and of the last one, or of each where heights are listed. */

import { lengthHandle } from "./handle.js";
import { say } from "../words/language.js";

/** @param {import("./handle.js").Context} context @returns {import("./handle.js").Handle[]} */
export function columnHandles(context) {
  const of = (...path) => context.number(["columns", ...path]);
  const width = of("width");
  if (!context.many || width.value === null) return [];
  const step = of("step").value ?? 0;
  const size = (path, name, moves, at, value) => lengthHandle(context, {
    key: ["columns", ...path].join("."), name, of: of(...path), kind: "size", moves, least: 1, at: context.block.toFrame(at.x, at.y),
    value: (hand) => value(context.block.toScene(hand.x, hand.y)),
  });
  /** The top of a column counted from 0, in its middle. */
  const top = (k, height) => ({ x: (k + 0.5) * width.value, y: k * step + height });
  const count = context.scene.count(["columns", "heights"]);
  const [first, tops] = count === null ? madeTops(of, step) : [of("heights", 0).value, Array.from({ length: count }, (_, k) => ({
    path: ["heights", k], name: say("height of column %s", k + 1), column: k, height: of("heights", k).value, value: (height) => height,
  }))];
  return [
    size(["width"], "width of the columns", "x", { x: width.value, y: (first ?? 0) / 2 }, (hand) => hand.x),
    ...tops.filter(({ height }) => height !== null).map(({ path, name, column, height, value }) => size(path, name, "y", top(column, height), (hand) => value(hand.y - column * step))),
  ];
}

/** By rise and fall: the n-th column has a height of n (rise - step) up to the crest, and of fall + step less from column to column behind it. */
function madeTops(of, step) {
  const [rise, fall, below, above] = ["rise", "fall", "below_crest", "above_crest"].map((key) => of(key).value);
  if ([rise, fall, below, above].includes(null)) return [null, []];
  const crest = (below + 1) * (rise - step);
  return [rise - step, [
    { path: ["rise"], name: "rise of the tops towards the crest", column: below, height: crest, value: (height) => height / (below + 1) + step },
    ...(above > 0 ? [{ path: ["fall"], name: "fall of the tops behind the crest", column: below + above, height: crest - above * (fall + step), value: (height) => (crest - height) / above - step }] : []),
  ]];
}
