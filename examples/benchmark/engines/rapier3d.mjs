// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// Convex solids of the benchmark by Rapier 3D in WebAssembly, single precision: a hull on a large box, the library's own
// iterations and tolerances, no sleep. npm install @dimforge/rapier3d-compat; node rapier3d.mjs

import { createInterface } from 'node:readline';

import RAPIER from '@dimforge/rapier3d-compat';

function moves(own, gravity) {
  const world = new RAPIER.World(gravity);
  world.timestep = own.step;
  const average = RAPIER.CoefficientCombineRule.Average;
  const lowest = Math.min(...own.points.filter((_, k) => k % 3 === 2));
  const floor = RAPIER.ColliderDesc.cuboid(1000, 1000, 100).setTranslation(0, 0, lowest - 100);
  world.createCollider(floor.setFriction(own.friction).setFrictionCombineRule(average));
  const block = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setCanSleep(false));
  const hull = RAPIER.ColliderDesc.convexHull(new Float32Array(own.points));
  world.createCollider(hull.setDensity(1).setFriction(own.friction).setFrictionCombineRule(average), block);
  world.step();
  const start = block.worldCom();
  let isFar = false;
  for (let k = 1; k < own.steps && !isFar; k++) {
    world.step();
    const now = block.worldCom();
    isFar = Math.hypot(now.x - start.x, now.y - start.y, now.z - start.z) > own.far;
  }
  world.free();
  return isFar;
}

await RAPIER.init({});
let own = {};
for await (const line of createInterface({ input: process.stdin })) {
  const [word, ...rest] = line.split(' ');
  const numbers = rest.map(Number);
  if (word === 'case') own = {};
  if (word === 'friction') own.friction = numbers[0];
  if (word === 'time') [own.step, own.steps, own.far] = numbers;
  if (word === 'points') own.points = numbers.slice(1);
  if (word === 'go') console.log(moves(own, { x: numbers[0], y: numbers[1], z: numbers[2] }) ? 1 : 0);
}
