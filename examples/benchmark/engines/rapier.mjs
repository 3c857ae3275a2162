// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// The benchmark by Rapier 2D in WebAssembly, single precision: convex polygons on segments; the library's own
// iterations and tolerances, no sleep. npm install @dimforge/rapier2d-compat; node rapier.mjs

import RAPIER from '@dimforge/rapier2d-compat';

import { answer, gravityAt } from './scene.mjs';

const flat = (points) => new Float32Array(points.flatMap((p) => [p.x, p.y]));

await RAPIER.init({});
await answer((own, gravity) => {
  const world = new RAPIER.World(gravity);
  world.timestep = own.step;
  const average = RAPIER.CoefficientCombineRule.Average;
  for (const line of own.rock) {
    for (let k = 0; k + 1 < line.length; k++) {
      world.createCollider(RAPIER.ColliderDesc.segment(line[k], line[k + 1]).setFriction(own.friction).setFrictionCombineRule(average));
    }
  }
  const blocks = own.blocks.map((pieces) => {
    const block = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setCanSleep(false));
    for (const piece of pieces) {
      const shape = RAPIER.ColliderDesc.convexPolyline(flat(piece)) ?? RAPIER.ColliderDesc.convexHull(flat(piece));
      if (shape) world.createCollider(shape.setDensity(1).setFriction(own.friction).setFrictionCombineRule(average), block);
    }
    return block;
  });
  world.step();
  const starts = blocks.map((block) => block.worldCom()), [first] = blocks;
  let isFar = false;
  for (let k = 1; k < own.steps && !isFar; k++) {
    first.resetForces(true);
    first.resetTorques(true);
    const turn = first.rotation(), place = first.translation(), c = Math.cos(turn), s = Math.sin(turn);
    for (const [x, y, fx, fy] of own.loads) {
      const force = { x: (c * fx - s * fy) * first.mass(), y: (s * fx + c * fy) * first.mass() };
      first.addForceAtPoint(force, { x: place.x + c * x - s * y, y: place.y + s * x + c * y }, true);
    }
    world.gravity = gravityAt(own, k, gravity);
    world.step();
    isFar = blocks.some((block, b) => Math.hypot(block.worldCom().x - starts[b].x, block.worldCom().y - starts[b].y) > own.far);
  }
  world.free();
  return isFar;
});
