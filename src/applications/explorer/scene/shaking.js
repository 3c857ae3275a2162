// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * The shaking of a scene as it is drawn: accelerations over time, of half or whole sines, or of a record's file. The core
 * reads the file itself; this is drawn only where its greatest value is the one that the core tells.
 */

import { parameterValues, quantity } from "./quantity.js";
import { snap } from "./decimal.js";

const SINE_POINTS = 200;
const SINES = { half_sine: 0.5, full_sine: 1 };
const AGREES = 1e-5; // of the greatest value
const DIGITS = 6;

/** @typedef {{t: number[], g: number[]}} Series seconds, and accelerations in g */

/** @param {import("./scene_text.js").SceneText} scene @param {Record<string, string|Uint8Array>} files @param {"horizontal"|"vertical"} way @returns {Series|null} */
export function shakingOf(scene, files, way) {
  const number = (...path) => quantity(scene, ["shaking", way, ...path], parameterValues(scene)).value;
  for (const [form, periods] of Object.entries(SINES)) {
    const [peak, frequency] = [number(form, "peak_g"), number(form, "frequency_hz")];
    if (peak === null || frequency === null) continue;
    const t = Array.from({ length: SINE_POINTS + 1 }, (_, k) => (k / SINE_POINTS) * (periods / frequency));
    return { t, g: t.map((each) => peak * Math.sin(2 * Math.PI * frequency * each)) };
  }
  const file = scene.scalar(["shaking", way, "record"]) ?? scene.scalar(["shaking", way, "record", "file"]);
  const content = files[file ?? ""];
  const scale = scene.has(["shaking", way, "record", "scale"]) ? number("record", "scale") : 1;
  const read = typeof content === "string" && scale !== null ? recordOf(content) : null;
  return read === null ? null : { t: read.t, g: read.g.map((each) => scale * each) };
}

/** @param {Series} series @param {number} peak as the core tells it */
export function agreesWith({ g }, peak) {
  const greatest = g.reduce((most, each) => Math.max(most, Math.abs(each)), 0);
  return Math.abs(greatest - Math.abs(peak)) <= AGREES * Math.abs(peak);
}

/** PEER's format (DT= in its head, then values), or rows of a time and an acceleration. @param {string} text @returns {Series|null} */
export function recordOf(text) {
  const step = /DT\s*=\s*(\d*\.?\d+)/i.exec(text);
  const lines = text.split(/\r?\n/);
  if (step !== null) {
    const values = lines.slice(lines.findIndex((line) => /DT\s*=/i.test(line)) + 1).join(" ").trim().split(/\s+/).map(Number);
    return values.every(Number.isFinite) ? { t: values.map((_, k) => k * Number(step[1])), g: values } : null;
  }
  const rows = lines.map((line) => line.replace(/#.*/, "").trim().split(/[;,\s]+/).map(Number)).filter((row) => row.length === 2 && row.every(Number.isFinite));
  return rows.length < 2 ? null : { t: rows.map(([t]) => t), g: rows.map(([, g]) => g) };
}

/** The numbers of a scene whose shaking is so many times as strong. @returns {{path: (string|number)[], text: string}[]} @throws {RangeError} one is a formula */
export function timesStronger(scene, factor) {
  const parameters = parameterValues(scene);
  const edits = [];
  for (const way of scene.keys(["shaking"]) ?? []) {
    const form = scene.keys(["shaking", way])?.find((key) => key in SINES);
    const path = ["shaking", way, ...(form === undefined ? ["record", "scale"] : [form, "peak_g"])];
    const of = quantity(scene, path, parameters);
    if (of.fixed !== null) throw new RangeError(path.join(".") + " " + of.fixed);
    const value = (of.value ?? 1) * factor;
    edits.push({ path: of.path, text: snap(value, Math.floor(Math.log10(Math.abs(value))) + 1 - DIGITS) });
  }
  return edits;
}
