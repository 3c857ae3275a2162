// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/* The benchmark by Chipmunk 7, double precision: convex polygons on segments without radius that
 * know their neighbours; 30 iterations, a slop of 0.01 of an engine's unit, no sleep. c++ -O2
 * chipmunk.cpp -lchipmunk -o chipmunk */

#include "scene.hpp"

#include <algorithm>
#include <chipmunk/chipmunk.h>
#include <cmath>

static cpVect at(const std::array<double, 2> &p) {
  return cpv(p[0], p[1]);
}

static void free_shape(cpSpace *space, void *shape, void *) {
  cpSpaceRemoveShape(space, static_cast<cpShape *>(shape));
  cpShapeFree(static_cast<cpShape *>(shape));
}

static void mark_shape(cpShape *shape, void *space) {
  cpSpaceAddPostStepCallback(static_cast<cpSpace *>(space), free_shape, shape, nullptr);
}

static cpBody *add_block(cpSpace *space, const std::vector<scene::points> &pieces,
                         double friction) {
  double mass = 0;
  cpVect centre = cpvzero;
  std::vector<std::vector<cpVect>> rings;
  for (const auto &piece : pieces) {
    rings.emplace_back();
    for (const auto &p : piece) rings.back().push_back(at(p));
    const int count = static_cast<int>(piece.size());
    const double area = cpAreaForPoly(count, rings.back().data(), 0);
    mass += area;
    centre = cpvadd(centre, cpvmult(cpCentroidForPoly(count, rings.back().data()), area));
  }
  centre = cpvmult(centre, 1 / mass);
  double inertia = 0;
  for (const auto &ring : rings) {
    const int count = static_cast<int>(ring.size());
    inertia += cpMomentForPoly(cpAreaForPoly(count, ring.data(), 0), count, ring.data(),
                               cpvneg(centre), 0);
  }
  cpBody *block = cpSpaceAddBody(space, cpBodyNew(mass, inertia));
  cpBodySetPosition(block, centre);
  for (const auto &ring : rings) {
    cpShape *shape = cpPolyShapeNew(block, static_cast<int>(ring.size()), ring.data(),
                                    cpTransformTranslate(cpvneg(centre)), 0);
    cpShapeSetFriction(shape, friction);
    cpSpaceAddShape(space, shape);
  }
  return block;
}

static void add_rock(cpSpace *space, const scene::points &line, double friction) {
  for (size_t k = 0; k + 1 < line.size(); k++) {
    cpShape *edge = cpSegmentShapeNew(cpSpaceGetStaticBody(space), at(line[k]), at(line[k + 1]), 0);
    const size_t before = k > 0 ? k - 1 : 0, after = std::min(k + 2, line.size() - 1);
    cpSegmentShapeSetNeighbors(edge, at(line[before]), at(line[after]));
    cpShapeSetFriction(edge, friction);
    cpSpaceAddShape(space, edge);
  }
}

static bool moves(const scene &own, const double gravity[2]) {
  cpSpace *space = cpSpaceNew();
  cpSpaceSetGravity(space, cpv(gravity[0], gravity[1]));
  cpSpaceSetIterations(space, 30);
  cpSpaceSetCollisionSlop(space, 0.01);
  const double friction = std::sqrt(own.friction); // the product of both counts
  for (const auto &line : own.rock) add_rock(space, line, friction);
  std::vector<cpBody *> blocks;
  std::vector<cpVect> starts;
  for (const auto &pieces : own.blocks) {
    blocks.push_back(add_block(space, pieces, friction));
    starts.push_back(cpBodyGetPosition(blocks.back()));
  }
  bool is_far = false;
  for (int k = 0; k < own.steps && !is_far; k++) {
    for (const auto &load : own.loads)
      cpBodyApplyForceAtLocalPoint(blocks[0],
                                   cpvmult(cpv(load[2], load[3]), cpBodyGetMass(blocks[0])),
                                   cpvsub(cpv(load[0], load[1]), starts[0]));
    const auto now = own.gravity_at(k, gravity);
    cpSpaceSetGravity(space, cpv(now[0], now[1]));
    cpSpaceStep(space, own.step);
    for (size_t b = 0; b < blocks.size(); b++)
      is_far = is_far || cpvdist(cpBodyGetPosition(blocks[b]), starts[b]) > own.far;
  }
  cpSpaceEachShape(
      space, [](cpShape *shape, void *all) { mark_shape(shape, all); }, space);
  for (cpBody *block : blocks) {
    cpSpaceRemoveBody(space, block);
    cpBodyFree(block);
  }
  cpSpaceFree(space);
  return is_far;
}

int main() {
  scene own;
  double gravity[2];
  while (next_question(own, gravity)) std::cout << moves(own, gravity) << std::endl;
}
