// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// The benchmark by planck 1, double precision: convex polygons of at most eight corners on edges; 8 iterations of velocities
// and 3 of positions, no sleep, slop and radii of the library. npm install planck; node planck.mjs

import { Edge, Polygon, Vec2, World } from 'planck';

import { answer, gravityAt } from './scene.mjs';

await answer((own, gravity) => {
  const world = new World({ gravity, allowSleep: false });
  const rock = world.createBody();
  for (const line of own.rock) {
    for (let k = 0; k + 1 < line.length; k++) rock.createFixture(new Edge(line[k], line[k + 1]), { friction: own.friction });
  }
  const blocks = own.blocks.map((pieces) => {
    const block = world.createDynamicBody();
    for (const piece of pieces) block.createFixture(new Polygon(piece), { density: 1, friction: own.friction });
    return block;
  });
  const starts = blocks.map((block) => Vec2.clone(block.getWorldCenter()));
  for (let k = 0; k < own.steps; k++) {
    const first = blocks[0];
    for (const [x, y, fx, fy] of own.loads) {
      const force = first.getWorldVector(Vec2(fx * first.getMass(), fy * first.getMass()));
      first.applyForce(force, first.getWorldPoint(Vec2(x, y)), true);
    }
    world.setGravity(gravityAt(own, k, gravity));
    world.step(own.step, 8, 3);
    if (blocks.some((block, b) => Vec2.distance(block.getWorldCenter(), starts[b]) > own.far)) return true;
  }
  return false;
});
