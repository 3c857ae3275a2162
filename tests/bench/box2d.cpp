// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// Box2D lets bodies overlap by its slop of 5 mm and rounds polygons by 10 mm, made for bodies of
// metres: lengths and gravity are taken a hundred times as large, which leaves times as they are.

#include "box2d.h"

#include <algorithm>
#include <box2d/box2d.h>
#include <cmath>
#include <vector>

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

// Large beside the slop and the rounding of the engine, which add up along a row of columns.
constexpr double highest = 100;

struct drawing {
  double unit; // of its lengths in a metre
  float friction;
};

b2Vec2 place(const drawing &own, double x, double y) {
  return {static_cast<float>(own.unit * x), static_cast<float>(own.unit * y)};
}

void add_edge(b2Body *rock, const drawing &own, b2Vec2 from, b2Vec2 to) {
  b2EdgeShape edge;
  edge.SetTwoSided(from, to);
  b2FixtureDef fixture;
  fixture.shape = &edge;
  fixture.friction = own.friction;
  rock->CreateFixture(&fixture);
}

void add_steps(b2World &world, const drawing &own, const box2d_columns &columns) {
  b2BodyDef definition;
  b2Body *rock = world.CreateBody(&definition);
  for (int k = -1; k <= columns.count; k++) {
    const double y = columns.step * (k < 0 ? 0 : k);
    const double left = columns.width * k, right = left + columns.width;
    add_edge(rock, own, place(own, left, y), place(own, right, y));
    if (k >= 0) add_edge(rock, own, place(own, right, y), place(own, right, y + columns.step));
  }
}

b2Body *add_column(b2World &world, const drawing &own, const box2d_columns &columns, int k) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.allowSleep = false;
  b2Body *body = world.CreateBody(&definition);
  const double left = columns.width * k, low = columns.step * k;
  const double right = left + columns.width, high = low + columns.heights[k];
  const b2Vec2 corners[] = {place(own, left, low), place(own, right, low), place(own, right, high),
                            place(own, left, high)};
  b2PolygonShape box;
  box.Set(corners, 4);
  b2FixtureDef fixture;
  fixture.shape = &box;
  fixture.density = 1;
  fixture.friction = own.friction;
  body->CreateFixture(&fixture);
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

// Times are those of the slope itself: gravity shrinks with its lengths.
bool box2d_columns_stand(const box2d_columns *columns, double tangent) {
  const double tallest = *std::max_element(columns->heights, columns->heights + columns->count);
  const drawing own = {highest / tallest, static_cast<float>(tangent)};
  const double g = 9.80665 * own.unit;
  b2World world({static_cast<float>(-g * std::sin(columns->dip)),
                 static_cast<float>(-g * std::cos(columns->dip))});
  add_steps(world, own, *columns);
  std::vector<b2Body *> bodies;
  std::vector<b2Vec2> starts;
  for (int k = 0; k < columns->count; k++) {
    bodies.push_back(add_column(world, own, *columns, k));
    starts.push_back(bodies.back()->GetWorldCenter());
  }
  for (int k = 0; k < steps; k++) {
    world.Step(1e-3F, velocity_iterations, position_iterations);
    for (size_t b = 0; b < bodies.size(); b++) {
      const float moved = (bodies[b]->GetWorldCenter() - starts[b]).Length();
      if (moved > static_cast<float>(0.01 * highest)) return false;
    }
  }
  return true;
}
