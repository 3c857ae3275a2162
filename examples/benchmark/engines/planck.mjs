// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// The benchmark by planck 1, double precision: convex polygons of at most eight corners on edges; 8 iterations of velocities
// and 3 of positions, no sleep, slop and radii of the library. npm install planck; node planck.mjs

import { Edge, Polygon, Vec2, World } from 'planck';

import { answer } from './scene.mjs';

await answer((own, gravity) => {
  const world = new World({ gravity, allowSleep: false });
  const rock = world.createBody();
  for (let k = 0; k + 1 < own.rock.length; k++) rock.createFixture(new Edge(own.rock[k], own.rock[k + 1]), { friction: own.friction });
  const block = world.createDynamicBody();
  for (const piece of own.pieces) block.createFixture(new Polygon(piece), { density: 1, friction: own.friction });
  const start = Vec2.clone(block.getWorldCenter());
  for (let k = 0; k < own.steps; k++) {
    for (const [x, y, fx, fy] of own.loads) {
      const force = block.getWorldVector(Vec2(fx * block.getMass(), fy * block.getMass()));
      block.applyForce(force, block.getWorldPoint(Vec2(x, y)), true);
    }
    world.step(own.step, 8, 3);
    if (Vec2.distance(block.getWorldCenter(), start) > own.far) return true;
  }
  return false;
});
