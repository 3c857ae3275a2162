// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// Box2D lets bodies overlap by its slop of 5 mm and rounds polygons by 10 mm, made for bodies of
// metres: lengths and gravity are taken a hundred times as large, which leaves times as they are.

#include "box2d.h"

#include <box2d/box2d.h>
#include <cmath>

namespace {

constexpr float scale = 100, gravity = 9.80665F * scale;
constexpr int steps = 2000, velocity_iterations = 8, position_iterations = 3;

b2Vec2 point(const double *xy) {
  return {scale * static_cast<float>(xy[0]), scale * static_cast<float>(xy[1])};
}

// Edges of the ring, seen from both sides.
void add_base(b2World &world, const box2d_block &block) {
  b2BodyDef definition;
  b2Body *rock = world.CreateBody(&definition);
  for (int k = 0; k < block.base_count; k++) {
    b2EdgeShape edge;
    edge.SetTwoSided(point(block.base + 2 * k),
                     point(block.base + 2 * ((k + 1) % block.base_count)));
    b2FixtureDef fixture;
    fixture.shape = &edge;
    fixture.friction = static_cast<float>(block.friction);
    rock->CreateFixture(&fixture);
  }
}

// Columns between the points of its underside and its top, which are convex.
b2Body *add_block(b2World &world, const box2d_block &block) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.allowSleep = false;
  b2Body *body = world.CreateBody(&definition);
  const float top = scale * static_cast<float>(block.top);
  for (int k = 0; k + 1 < block.under_count; k++) {
    const b2Vec2 left = point(block.under + 2 * k), right = point(block.under + 2 * k + 2);
    const b2Vec2 corners[] = {left, right, {right.x, top}, {left.x, top}};
    b2PolygonShape column;
    column.Set(corners, 4);
    b2FixtureDef fixture;
    fixture.shape = &column;
    fixture.density = 1;
    fixture.friction = static_cast<float>(block.friction);
    body->CreateFixture(&fixture);
  }
  return body;
}

} // namespace

bool box2d_stands(const box2d_block *block, double tilt) {
  b2World world({-gravity * static_cast<float>(std::sin(tilt)),
                 -gravity * static_cast<float>(std::cos(tilt))});
  add_base(world, *block);
  const b2Body *body = add_block(world, *block);
  const b2Vec2 start = body->GetWorldCenter();
  const float far = 0.01F * scale * static_cast<float>(block->extent);
  for (int k = 0; k < steps; k++) {
    world.Step(1e-3F, velocity_iterations, position_iterations);
    if ((body->GetWorldCenter() - start).Length() > far) return false;
  }
  return true;
}
