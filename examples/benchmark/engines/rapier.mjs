// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// The benchmark by Rapier 2D in WebAssembly, single precision: convex polygons on segments; the library's own
// iterations and tolerances, no sleep. npm install @dimforge/rapier2d-compat; node rapier.mjs

import RAPIER from '@dimforge/rapier2d-compat';

import { answer } from './scene.mjs';

const flat = (points) => new Float32Array(points.flatMap((p) => [p.x, p.y]));

await RAPIER.init({});
await answer((own, gravity) => {
  const world = new RAPIER.World(gravity);
  world.timestep = own.step;
  const average = RAPIER.CoefficientCombineRule.Average;
  for (let k = 0; k + 1 < own.rock.length; k++) {
    world.createCollider(RAPIER.ColliderDesc.segment(own.rock[k], own.rock[k + 1]).setFriction(own.friction)
      .setFrictionCombineRule(average));
  }
  const block = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setCanSleep(false));
  for (const piece of own.pieces) {
    const shape = RAPIER.ColliderDesc.convexPolyline(flat(piece)) ?? RAPIER.ColliderDesc.convexHull(flat(piece));
    if (shape) world.createCollider(shape.setDensity(1).setFriction(own.friction).setFrictionCombineRule(average), block);
  }
  world.step();
  const start = block.worldCom();
  let isFar = false;
  for (let k = 1; k < own.steps && !isFar; k++) {
    block.resetForces(true);
    block.resetTorques(true);
    const turn = block.rotation(), place = block.translation(), c = Math.cos(turn), s = Math.sin(turn);
    for (const [x, y, fx, fy] of own.loads) {
      const force = { x: (c * fx - s * fy) * block.mass(), y: (s * fx + c * fy) * block.mass() };
      block.addForceAtPoint(force, { x: place.x + c * x - s * y, y: place.y + s * x + c * y }, true);
    }
    world.step();
    const now = block.worldCom();
    isFar = Math.hypot(now.x - start.x, now.y - start.y) > own.far;
  }
  world.free();
  return isFar;
});
