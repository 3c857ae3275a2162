// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** The menu of units: the same block in another unit of length, what its numbers were meant in, and units of reports. */

import { inUnit, UNITS } from "../scene/length_units.js";
import { say } from "../words/language.js";

/** Of reports, as the scene's key result_units takes them. */
const RESULTS = {
  length: Object.keys(UNITS),
  force: ["N", "kN", "MN", "kgf", "tf", "lbf", "kip"],
  moment: ["N m", "kN m", "MN m", "tf m", "lbf ft", "kip ft"],
  stress: ["Pa", "kPa", "MPa", "kgf/cm2", "psi", "psf", "ksf"],
};

const LABELS = { length: "Lengths in reports", force: "Forces in reports", moment: "Moments in reports", stress: "Stresses in reports" };

/** @param {HTMLSelectElement} select @param {import("../scene/store.js").SceneStore} store @param messages @param {(path: string) => boolean} isLength */
export function unitsMenu(select, store, messages, isLength) {
  const lengths = Object.keys(UNITS);
  const present = (path) => store.parsed.scalar(path);
  const put = (path, unit) => store.setNumber(path, unit);
  const groups = [
    { label: "The same block in", units: lengths, has: () => present(["length_unit"]), act: (unit) => store.setText(inUnit(store.parsed, unit, isLength)) },
    { label: "Its numbers are meant in", units: lengths, has: () => present(["length_unit"]), act: (unit) => put(["length_unit"], unit) },
    ...Object.entries(RESULTS).map(([of, units]) => ({
      label: LABELS[of], units,
      has: () => present(["result_units", of]), act: (unit) => put(["result_units", of], unit),
    })),
  ];
  const options = groups.flatMap((group, at) => {
    const box = document.createElement("optgroup");
    box.label = say(group.label);
    const made = group.units.map((unit) => ({ option: new Option(unit, at + " " + unit), group, unit }));
    box.append(...made.map(({ option }) => option));
    select.append(box);
    return made;
  });
  select.addEventListener("change", () => {
    const chosen = options.find(({ option }) => option.value === select.value);
    select.value = "";
    try {
      chosen.group.act(chosen.unit);
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      messages.say(say("The unit stays: %s", error.message));
    }
  });
  const update = () => {
    const known = store.parsed.unread === null && store.parsed.has([]);
    for (const { option, group, unit } of options) option.disabled = !known || group.has() === unit;
  };
  for (const event of ["pointerdown", "focus", "keydown"]) select.addEventListener(event, update);
}
