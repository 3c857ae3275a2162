// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Handles of the block: vertices of its outlines, or the sizes it is made from. */

import { lengthHandle, vertexHandle } from "./handle.js";
import { pointsOf } from "./points.js";
import { say } from "../words/language.js";

/** @param {import("./handle.js").Context} context @param {Set<string>|null} only as `listHandles` takes it @returns {import("./nearest.js").Candidate[]} vertices */
export function blockVertices(context, only) {
  const isOutline = context.block !== null && (context.scene.keys(["block"]) ?? []).includes("outline");
  return isOutline ? outlineHandles(context, only) : [];
}

/** @param {import("./handle.js").Context} context @returns {import("./handle.js").Handle[]} of the sizes that a block is made from */
export function blockHandles(context) {
  if (context.block === null) return [];
  const kinds = context.scene.keys(["block"]) ?? [];
  if (kinds.includes("slab")) return slabHandles(context);
  if (kinds.includes("teeth")) return teethHandles(context);
  if (kinds.includes("ellipse")) return ellipseHandles(context);
  return [];
}

/** The rings of points of an outline with its holes and parts: where each stands, and its name. @param {(string|number)[]} [of] the block @returns {[(string|number)[], string][]} */
export function ringsOf(context, of = ["block"]) {
  const rings = [[[...of, "outline"], say("the outline")]];
  for (let i = 0; i < (context.scene.count([...of, "holes"]) ?? 0); i++) rings.push([[...of, "holes", i], say("hole %s", i + 1)]);
  for (let i = 0; i < (context.scene.count([...of, "parts"]) ?? 0); i++) {
    rings.push([[...of, "parts", i, "outline"], say("part %s", i + 1)]);
  }
  return rings;
}

function outlineHandles(context, only) {
  const places = namedVertices(context.scene);
  return ringsOf(context).flatMap(([path, name]) => listHandles(context, context.block, path, name, { only, made: (own, label) => vertexHandle(context, context.block, own, label, places) }));
}

/** Where a scene names vertices of the outline by their coordinates. @returns {(string|number)[][]} */
function namedVertices(scene) {
  const each = (list, ...keys) => {
    const count = scene.count(list) ?? 0;
    return Array.from({ length: count }, (_, i) => keys.map((key) => [...list, i, ...key])).flat();
  };
  return [
    ...each(["block", "arcs"], ["from"]), ...each(["block", "rounded", "corners"], ["at"]), ...each(["base", "between"], []),
    ...each(["loads", "surcharges"], ["from"], ["to"]), ...each(["loads", "pressures"], ["from"], ["to"]),
  ];
}

/**
 * @param {import("./view.js").Placement} placement @param {(string|number)[]} path of a list of points
 * @param {{only?: Set<string>|null, made?: (path: (string|number)[], label: string) => import("./handle.js").Handle|null}} [how]
 *   only: keys of those that are wanted; null: all
 * @returns {import("./nearest.js").Candidate[]}
 */
export function listHandles(context, placement, path, name, { only = null, made = (own, label) => vertexHandle(context, placement, own, label) } = {}) {
  const list = path.join(".") + ".";
  const points = pointsOf(context, path);
  const candidate = (i) => ({
    key: list + i,
    at: placement.toFrame(points[i].x, points[i].y),
    made: () => made([...path, i], say("vertex %s of %s", i + 1, name)),
  });
  const wanted = only === null ? points.keys() : [...only].filter((key) => key.startsWith(list)).map((key) => Number(key.slice(list.length)));
  return [...wanted].filter((i) => (points[i] ?? null) !== null).map(candidate);
}

/** A size of a block that is made from numbers; at and value in the scene's own coordinates. */
function sizeHandle(context, { key, path, name, moves, at, value, placement = context.block }) {
  return lengthHandle(context, {
    key, name, of: context.number(path), kind: "size", moves, least: 1, at: placement.toFrame(at.x, at.y),
    value: (hand) => value(placement.toScene(hand.x, hand.y)),
  });
}

/** @param {(string|number)[]} [block] one of many @param {import("./view.js").Placement} [placement] its own */
export function slabHandles(context, block = ["block"], placement = context.block) {
  const path = (key) => [...block, "slab", key];
  const key = (of) => (context.many ? path(of).join(".") : undefined);
  const [width, height] = ["width", "height"].map((key) => context.number(path(key)).value);
  if (width === null || height === null) return [];
  return [
    sizeHandle(context, { key: key("width"), placement, path: path("width"), name: "width of the slab", moves: "x", at: { x: width, y: height / 2 }, value: (hand) => hand.x }),
    sizeHandle(context, { key: key("height"), placement, path: path("height"), name: "height of the slab", moves: "y", at: { x: width / 2, y: height }, value: (hand) => hand.y }),
  ];
}

/** An ellipse of width w and height h cut off where it is f wide: its centre is at h/2 sqrt(1 - f²/w²) over the flat. */
function ellipseHandles(context) {
  const [width, height, flat] = ["width", "height", "flat"].map((key) => context.number(["block", "ellipse", key]).value);
  if (width === null || height === null || flat === null) return [];
  const rise = Math.sqrt(Math.max(0, 1 - (flat / width) ** 2));
  const size = (key, moves, at, value) =>
    sizeHandle(context, { path: ["block", "ellipse", key], name: key + " of the ellipse", moves, at, value });
  return [
    size("width", "x", { x: width / 2, y: (height / 2) * rise }, (hand) => 2 * hand.x),
    size("height", "y", { x: 0, y: (height / 2) * (1 + rise) }, (hand) => (2 * hand.y) / (1 + rise)),
    size("flat", "x", { x: flat / 2, y: 0 }, (hand) => 2 * hand.x),
  ];
}

/**
 * A toothed block as the paper numbers it (N, a, b, c) or by its general parameters (block width N a, mean height
 * b + c/2, amplitude c, wavelength 2a). Its top lies at b + c over its valleys.
 * @returns {{count: number, a: number, b: number, c: number, valley: boolean, general: boolean}|null}
 */
export function teethOf(context, block = ["block"]) {
  const of = (key) => context.number([...block, "teeth", key]);
  const valley = context.scene.scalar([...block, "teeth", "left_end"]) !== "peak";
  const general = context.scene.scalar([...block, "teeth", "wavelength"]) !== null;
  const [a, b, c] = general
    ? [of("wavelength").value / 2, of("mean_height").value - of("amplitude").value / 2, of("amplitude").value]
    : [of("width").value, of("height").value, of("depth").value];
  const count = general ? Math.round(of("block_width").value / a) : of("count").value;
  const known = [count, a, b, c].every((value) => typeof value === "number" && Number.isFinite(value));
  return known && count >= 1 && count <= 1000 ? { count, a, b, c, valley, general } : null;
}

function teethHandles(context) {
  const teeth = teethOf(context);
  if (teeth === null) return [];
  const { count, a, b, c, valley, general } = teeth;
  const peak = valley ? a : 0;
  const size = (key, name, moves, at, value) => sizeHandle(context, { path: ["block", "teeth", key], name, moves, at, value });
  const top = { x: (count * a) / 2, y: b + c };
  if (general) {
    return [
      size("mean_height", "mean height of the block", "y", top, (hand) => hand.y - c / 2),
      size("amplitude", "amplitude of the teeth", "y", { x: peak, y: c }, (hand) => hand.y),
    ];
  }
  return [
    size("width", "width of the teeth", "x", { x: count * a, y: (b + c) / 2 }, (hand) => hand.x / count),
    size("height", "height of the block", "y", top, (hand) => hand.y - c),
    size("depth", "depth of the teeth", "y", { x: peak, y: c }, (hand) => hand.y),
  ];
}
