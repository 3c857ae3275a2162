// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/**
 * Many blocks that a scene lists: each is dragged as a whole, by the numbers of its `at`, or by its vertices; vertices of
 * several blocks in one place go together. Sizes of slabs have handles while the pointer or the focus is on the block.
 * What is dragged aligns with the corners of the others, so that contacts, which are exact, are met.
 */

import { Alignment } from "./alignment.js";
import { listHandles, ringsOf, slabHandles } from "./block_handles.js";
import { edit, vertexHandle, whyFixed } from "./handle.js";
import { ringOf } from "./rings.js";
import { between, numeral, say } from "../words/language.js";

const APART_DOTS = 18; // of two vertices with handles,
const HAND_DOTS = 50; // but so near to the hand
const ROOM_DOTS = 10; // from the middle of a block, that the handles of its sizes need
const WITHIN = 0.4; // of the lesser of its width and height

/**
 * @typedef {object} Listed
 * @property {(string|number)[]} path @property {string} name @property {boolean} ground
 * @property {{x: object, y: object}} at the quantities by which it is shifted
 * @property {import("./view.js").Placement} placement of its own coordinates
 */

/** @param {import("./handle.js").Context} context @returns {Listed[]} those of the scene's list; none: it lists no blocks */
export function listedBlocks(context) {
  return Array.from({ length: context.many ? (context.scene.count(["blocks"]) ?? 0) : 0 }, (_, i) => {
    const path = ["blocks", i];
    const [x, y] = [0, 1].map((axis) => context.number([...path, "at", axis]));
    const name = context.scene.scalar([...path, "name"]) ?? String(i + 1);
    return { path, name, ground: context.scene.scalar([...path, "ground"]) === "true", at: { x, y }, placement: context.block.shifted(x.value ?? 0, y.value ?? 0) };
  });
}

/**
 * @param {import("./handle.js").Context} context @param {import("./view.js").View} view
 * @param {{hand: import("./handle.js").Point|null, kept: Set<string>}} near as `handlesOf` takes it
 * @returns {import("./nearest.js").Candidate[]} whole blocks, and vertices that can be told apart
 */
export function listedCandidates(context, view, near) {
  const blocks = listedBlocks(context);
  if (blocks.length === 0) return [];
  const corners = cornersOf(context, blocks);
  const alignment = new Alignment(corners, view.dotsPerMetre * context.metres);
  const together = togetherOf(corners);
  return [
    ...blocks.filter(({ ground }) => !ground).flatMap((block) => wholeCandidate(context, block, alignment)),
    ...apart(blocks.flatMap((block) => vertices(context, block, together, alignment)), view, near),
  ];
}

/** Of vertices within some dots of each other one, but near to the hand. @param {import("./nearest.js").Candidate[]} vertices */
function apart(vertices, view, { hand, kept }) {
  const taken = new Set();
  return vertices.filter(({ key, at }) => {
    const { x, y } = view.toScreen(at.x, at.y);
    const place = Math.round(x / APART_DOTS) + " " + Math.round(y / APART_DOTS);
    const stays = kept.has(key) || !taken.has(place) || (hand !== null && Math.hypot(x - hand.x, y - hand.y) < HAND_DOTS);
    taken.add(place);
    return stays;
  });
}

/**
 * Behind the handle of each block that has the focus of keys, or the hand and room for them, those of its sizes.
 * @param {import("./handle.js").Context} context @param {import("./view.js").View} view @param {import("./handle.js").Handle[]} wholes
 * @param {{hand: import("./handle.js").Point|null, kept: Set<string>}} near as `handlesOf` takes it
 */
export function withSizes(context, view, wholes, { hand, kept, byKeys }) {
  const blocks = new Map(listedBlocks(context).map((block) => [block.path.join("."), block]));
  const at = hand === null ? null : view.toFrame(hand.x, hand.y);
  const isOf = (key) => (one) => (one + ".").startsWith(key + ".");
  const chosen = ({ key, reach }) => byKeys.some(isOf(key)) ||
    (reach * view.dotsPerMetre > ROOM_DOTS && ([...kept].some(isOf(key)) || (at !== null && holds(context, blocks.get(key), at))));
  return wholes.flatMap((handle) => [handle, ...(chosen(handle) ? sizes(context, blocks.get(handle.key)) : [])]);
}

function sizes(context, { path, placement, name }) {
  return slabHandles(context, path, placement).map((handle) => ({ ...handle, label: say("block %s", name) + ": " + handle.label }));
}

/** Corners of all blocks, where they lie in the scene; key: of the handle of a vertex. */
function cornersOf(context, blocks) {
  return blocks.flatMap(({ path, at }, block) => {
    const key = context.scene.has([...path, "outline"]) ? (i) => [...path, "outline", i].join(".") : () => null;
    return (ringOf(context, path) ?? []).map((point, i) => ({ x: point.x + (at.x.value ?? 0), y: point.y + (at.y.value ?? 0), block, key: key(i) }));
  });
}

/** Vertices that lie in one place. @returns {(key: string) => string[]} the keys of all of them, by that of one */
function togetherOf(corners) {
  const vertices = corners.filter(({ key }) => key !== null);
  const places = new Map();
  const of = new Map();
  for (const { x, y, key } of vertices) {
    const place = x + " " + y;
    if (!places.has(place)) places.set(place, []);
    places.get(place).push(key);
    of.set(key, places.get(place));
  }
  return (key) => of.get(key) ?? [key];
}

function wholeCandidate(context, block, alignment) {
  const ring = ringOf(context, block.path);
  if (ring === null) return [];
  const own = { x: middle(ring.map(({ x }) => x)), y: middle(ring.map(({ y }) => y)) };
  const at = block.placement.toFrame(own.x, own.y);
  return [{ key: block.path.join("."), at, made: () => wholeHandle(context, block, { ring, own, at }, alignment) }];
}

const middle = (values) => (Math.min(...values) + Math.max(...values)) / 2;

/** A circle that lies within the block takes the hand. */
function wholeHandle(context, block, { ring, own, at }, alignment) {
  const { x, y } = block.at;
  const named = say("block %s", block.name);
  const stands = context.scene.has([...block.path, "at"]);
  const put = (across, up, exponent) => {
    if (stands) return [...(x.fixed === null ? [edit(x, across, exponent)] : []), ...(y.fixed === null ? [edit(y, up, exponent)] : [])];
    return [{ path: [...block.path, "at"], text: "[" + edit(x, across, exponent).text + ", " + edit(y, up, exponent).text + "]" }];
  };
  const spread = (values) => Math.max(...values) - Math.min(...values);
  return {
    key: block.path.join("."), kind: "whole", moves: "xy", fixed: stands ? whyFixed(named, x, y) : null,
    label: say("%s, shifted by %s", named, numeral((x.value ?? 0) + "") + between + numeral((y.value ?? 0) + "") + " " + context.unit),
    at, reach: WITHIN * context.metres * Math.min(spread(ring.map((point) => point.x)), spread(ring.map((point) => point.y))),
    drag: (hand, exponent) => {
      const to = context.block.toScene(hand.x, hand.y);
      const shift = alignment.shift(ring, { x: to.x - own.x, y: to.y - own.y }, (corner) => corner.block !== block.path[1], exponent);
      return put(shift.x, shift.y, shift.exponent);
    },
    step: (dx, dy, exponent) => put((x.value ?? 0) + dx * 10 ** exponent, (y.value ?? 0) + dy * 10 ** exponent, exponent),
  };
}

/** Vertices of holes and parts go alone, as no other block has them. */
function vertices(context, block, together, alignment) {
  return ringsOf(context, block.path).flatMap(([path, name]) => listHandles(context, block.placement, path, say("%s of block %s", name, block.name), {
    made: (own, label) => alignedVertex(context, block, vertexHandle(context, block.placement, own, label, others(own, together)), together, alignment),
  }));
}

/** @returns {(string|number)[][]} where the other vertices stand that lie in the place of one */
function others(own, together) {
  const key = own.join(".");
  return together(key).filter((other) => other !== key).map((other) => other.split(".").map((step) => (/^\d+$/.test(step) ? Number(step) : step)));
}

function alignedVertex(context, block, handle, together, alignment) {
  if (handle === null) return null;
  const along = new Set(together(handle.key));
  const shift = { x: block.at.x.value ?? 0, y: block.at.y.value ?? 0 };
  return {
    ...handle,
    drag: (hand, exponent) => {
      const to = alignment.shift([shift], block.placement.toScene(hand.x, hand.y), (corner) => corner.block !== block.path[1] && !along.has(corner.key), exponent);
      return handle.drag(block.placement.toFrame(to.x, to.y), to.exponent);
    },
  };
}

/** Whether a place of the frame lies in a block. */
function holds(context, block, hand) {
  const ring = ringOf(context, block.path);
  if (ring === null || block.ground) return false;
  const { x, y } = block.placement.toScene(hand.x, hand.y);
  return ring.reduce((inside, p, i) => {
    const q = ring[(i + 1) % ring.length];
    return (p.y > y) !== (q.y > y) && x < p.x + ((y - p.y) * (q.x - p.x)) / (q.y - p.y) ? !inside : inside;
  }, false);
}
