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

static void add_rock(b2World &world, const scene &own) {
  b2BodyDef fixed;
  b2Body *rock = world.CreateBody(&fixed);
  for (const auto &line : own.rock)
    for (size_t k = 0; k + 1 < line.size(); k++) {
      b2EdgeShape edge;
      edge.SetTwoSided(at(line[k]), at(line[k + 1]));
      rock->CreateFixture(&edge, 0)->SetFriction(static_cast<float>(own.friction));
    }
}

static b2Body *add_block(b2World &world, const std::vector<scene::points> &pieces,
                         double friction) {
  b2BodyDef free;
  free.type = b2_dynamicBody;
  free.allowSleep = false;
  b2Body *block = world.CreateBody(&free);
  for (const auto &piece : pieces) {
    std::vector<b2Vec2> corners;
    for (const auto &p : piece) corners.push_back(at(p));
    b2PolygonShape polygon;
    polygon.Set(corners.data(), static_cast<int>(corners.size()));
    block->CreateFixture(&polygon, 1)->SetFriction(static_cast<float>(friction));
  }
  return block;
}

static bool moves(const scene &own, const double gravity[2]) {
  b2World world(at({gravity[0], gravity[1]}));
  add_rock(world, own);
  std::vector<b2Body *> blocks;
  std::vector<b2Vec2> starts;
  for (const auto &pieces : own.blocks) {
    blocks.push_back(add_block(world, pieces, own.friction));
    starts.push_back(blocks.back()->GetWorldCenter());
  }
  for (int k = 0; k < own.steps; k++) {
    b2Body *first = blocks.front();
    for (const auto &load : own.loads)
      first->ApplyForce(first->GetMass() * first->GetWorldVector(at({load[2], load[3]})),
                        first->GetWorldPoint(at({load[0], load[1]})), true);
    world.SetGravity(at(own.gravity_at(k, gravity)));
    world.Step(static_cast<float>(own.step), 8, 3);
    for (size_t b = 0; b < blocks.size(); b++)
      if ((blocks[b]->GetWorldCenter() - starts[b]).Length() > static_cast<float>(own.far))
        return true;
  }
  return false;
}

int main() {
  scene own;
  double gravity[2];
  while (next_question(own, gravity)) std::cout << moves(own, gravity) << std::endl;
}
