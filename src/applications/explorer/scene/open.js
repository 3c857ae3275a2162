// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Files of the reader become the scene. A YAML file is one, and what is opened with it stands beside it; a file that
 * the present scene names takes that place; a drawing, or points, alone begin a scene that names it.
 */

import { pointsOfCsv, profileOfCsv } from "./csv_points.js";
import { snap, stepExponent } from "./decimal.js";
import { say } from "../words/language.js";

const FILE_MAX = 64_000_000; // bytes: a scene of a million vertices has 20 MB
const POINTS = /\.(csv|txt)$/i;
const DRAWINGS = /\.(dxf|svg|wkt|geojson|json)$/i;

/** @param {File[]} chosen @param {import("./store.js").SceneStore} store */
export async function readFiles(chosen, store) {
  const large = chosen.find((file) => file.size > FILE_MAX);
  if (large !== undefined) throw new Error(say("%s has more than %s MB: open it with the command line.", large.name, FILE_MAX / 1e6));
  const files = Object.fromEntries(await Promise.all(chosen.map(async (file) => [file.name, await content(file)])));
  const names = Object.keys(files);
  const scene = names.find((name) => /\.ya?ml$/i.test(name));
  if (scene !== undefined) {
    const { [scene]: text, ...beside } = files;
    if (typeof text !== "string") throw new Error(say("%s is not text in UTF-8.", scene));
    store.open({ name: scene, text, files: beside });
    return;
  }
  for (const name of names) openOne(name, files[name], store);
}

/** @param {File} file @returns {Promise<string|Uint8Array>} text where it is one */
async function content(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return bytes;
  }
}

function openOne(name, content, store) {
  if (store.text.includes(name)) {
    store.addFile(name, content);
    return;
  }
  const text = sceneOf(name, content);
  if (text === null) throw new Error(say("%s is not a scene, a drawing (DXF, SVG, WKT, GeoJSON) or points (CSV, or a text with two numbers a line); the scene does not name it either.", name));
  store.open({ name: name.replace(/\.\w+$/, "") + ".yaml", text, files: { [name]: content } });
}

/** @param {string} name of a file @param {string|Uint8Array} content @returns {string|null} a scene that names it; null: none can */
export function sceneOf(name, content) {
  if (DRAWINGS.test(name)) return sceneOfDrawing(name);
  const profile = typeof content === "string" ? profileOfCsv(content) : null;
  if (POINTS.test(name) && profile !== null) return sceneOfProfile(name, profile);
  const isPoints = /\.csv$/i.test(name) || (POINTS.test(name) && typeof content === "string" && pointsOfCsv(content) !== null);
  return isPoints ? sceneOfPoints(name) : null;
}

/** DXF says its unit itself, and the core asks for it where it does not. */
function sceneOfDrawing(name) {
  const unit = /\.dxf$/i.test(name) ? "" : ", unit: m";
  const comment = unit === "" ? "" : "      # the file says no unit: is it metres?";
  return "topple: 1\ndrawing: {file: " + quoted(name) + unit + "}" + comment + rest("block: {unit_weight_kn_m3: 26}");
}

function sceneOfPoints(name) {
  return "topple: 1\nlength_unit: m      # the file says no unit: is it metres?" + rest("block: {outline: " + quoted(name) + ", unit_weight_kn_m3: 26}");
}

/** Points from one side to the other are ground: a block is set down on its middle, to be drawn as the reader's is. */
function sceneOfProfile(name, { from, to, top }) {
  const width = (to - from) / 4;
  const exponent = stepExponent(width, 0.02);
  const at = (value) => snap(value, exponent);
  const [left, right] = [-0.5, 0.5].map((side) => at((from + to) / 2 + side * width));
  const [low, high] = [0.2, 1.7].map((rise) => at(top + rise * width));
  const block = "block:      # begun as a square stone over the profile: draw your own\n  outline: [[" + left + ", " + low + "], [" + right + ", " + low + "], [" +
    right + ", " + high + "], [" + left + ", " + high + "]]\n  unit_weight_kn_m3: 26";
  return "topple: 1\nlength_unit: m      # the file says no unit: is it metres?\n" + "base: {profile: " + quoted(name) + ", place: rest}" + rest(block);
}

/** Tilted a little: level ground drives nothing, and every factor of safety would be without bound. */
function rest(block) {
  return "\n" + block + "\nfriction_angle_deg: 30      # assumed; replace it by a measured value\ntilt: {towards: both, angle_deg: 10}      # assumed, too\n";
}

/** A name as a scalar of YAML that can hold any. */
function quoted(name) {
  return "'" + name.replace(/'/g, "''") + "'";
}
