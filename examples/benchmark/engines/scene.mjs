// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// What run.py says to an engine, as scene.hpp reads it: answers each `go gx gy` by `moves(scene, gravity)`.

import { createInterface } from 'node:readline';

const pairs = (numbers) => Array.from({ length: numbers[0] }, (_, k) => ({ x: numbers[1 + 2 * k], y: numbers[2 + 2 * k] }));

/** In the frame of the rock that a whole sine accelerates, halfway through a step. */
export function gravityAt(own, k, gravity) {
  const cycles = (own.frequency ?? 0) * (k + 0.5) * own.step;
  return { x: gravity.x - (cycles < 1 ? (own.peak ?? 0) * Math.sin(2 * Math.PI * cycles) : 0), y: gravity.y };
}

export async function answer(moves) {
  let own = {};
  for await (const line of createInterface({ input: process.stdin })) {
    const [word, ...rest] = line.split(' ');
    const numbers = rest.map(Number);
    if (word === 'case') own = { rock: [], blocks: [], loads: [] };
    if (word === 'friction') own.friction = numbers[0];
    if (word === 'time') [own.step, own.steps, own.far] = numbers;
    if (word === 'rock') own.rock.push(pairs(numbers));
    if (word === 'block') own.blocks.push([]);
    if (word === 'piece') own.blocks.at(-1).push(pairs(numbers));
    if (word === 'load') own.loads.push(numbers);
    if (word === 'shake') [own.peak, own.frequency] = numbers;
    if (word === 'go') console.log(moves(own, { x: numbers[0], y: numbers[1] }) ? 1 : 0);
  }
}
