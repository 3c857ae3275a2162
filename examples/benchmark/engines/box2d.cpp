// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/* The benchmark by Box2D 2.4, single precision: convex polygons of at most eight corners on
 * two-sided edges; 8 iterations of velocities and 3 of positions, no sleep. c++ -O2 box2d.cpp
 * -lbox2d -o box2d */

#include "scene.hpp"

#include <box2d/box2d.h>

static b2Vec2 at(const std::array<double, 2> &p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1])};
}

static bool moves(const scene &own, const double gravity[2]) {
  b2World world(at({gravity[0], gravity[1]}));
  b2BodyDef fixed, free;
  b2Body *rock = world.CreateBody(&fixed);
  for (size_t k = 0; k + 1 < own.rock.size(); k++) {
    b2EdgeShape edge;
    edge.SetTwoSided(at(own.rock[k]), at(own.rock[k + 1]));
    rock->CreateFixture(&edge, 0)->SetFriction(static_cast<float>(own.friction));
  }
  free.type = b2_dynamicBody;
  free.allowSleep = false;
  b2Body *block = world.CreateBody(&free);
  for (const auto &piece : own.pieces) {
    std::vector<b2Vec2> corners;
    for (const auto &p : piece) corners.push_back(at(p));
    b2PolygonShape polygon;
    polygon.Set(corners.data(), static_cast<int>(corners.size()));
    block->CreateFixture(&polygon, 1)->SetFriction(static_cast<float>(own.friction));
  }
  const b2Vec2 start = block->GetWorldCenter();
  for (int k = 0; k < own.steps; k++) {
    for (const auto &load : own.loads)
      block->ApplyForce(block->GetMass() * block->GetWorldVector(at({load[2], load[3]})),
                        block->GetWorldPoint(at({load[0], load[1]})), true);
    world.Step(static_cast<float>(own.step), 8, 3);
    if ((block->GetWorldCenter() - start).Length() > static_cast<float>(own.far)) return true;
  }
  return false;
}

int main() {
  scene own;
  double gravity[2];
  while (next_question(own, gravity)) std::cout << moves(own, gravity) << std::endl;
}
