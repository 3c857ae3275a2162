// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/** Scenes to begin one's own with: each is a shape to be dragged, with numbers that are assumed and say so. */

const ASSUMED = "friction_angle_deg: 30      # assumed; replace it by a measured value\ntilt: {towards: left, angle_deg: 10}\n";

function begun(name, title, unit, block, base = "base: {mated: true, beyond: {left: 1, right: 1}}") {
  return { name, title, text: "topple: 1\ntitle: " + title + "\nlength_unit: " + unit + "\n" + block + base + "\n" + ASSUMED, files: {} };
}

const ROCK = "  unit_weight_kn_m3: 26      # assumed\n";

export const TEMPLATES = [
  begun("my_slab.yaml", "A slab of my own", "m", "block:\n  slab: {width: 1, height: 2}\n" + ROCK),
  begun("my_block.yaml", "A block of my own", "m", "block:\n  outline: [[0, 0], [2, 0], [2.3, 1.4], [1.6, 2.6], [0.2, 2.4], [-0.2, 1.1]]\n" + ROCK),
  begun("my_teeth.yaml", "A toothed block of my own", "mm", "block:\n  teeth: {count: 4, width: 25, height: 140, depth: 6, left_end: valley}\n" + ROCK,
    "base: {mated: true, beyond: {left: 0, right: 0}}"),
  begun("my_boulder.yaml", "A boulder of my own", "m", "block:\n  ellipse: {width: 3, height: 2.4, flat: 1}\n" + ROCK),
  begun("my_ground.yaml", "A block on ground of my own", "m",
    "block:\n  outline: [[1.2, 1.1], [2.8, 1.1], [3, 2], [2.4, 3], [1.5, 2.9], [1, 2]]\n" + ROCK,
    "base:\n  profile: [[-1, 0.2], [0, 0.4], [1, 0.2], [2, 0.5], [3, 0.3], [4, 0.5], [5, 0.1]]\n  place: rest"),
];
