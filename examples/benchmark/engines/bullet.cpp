// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/* Convex solids of the benchmark by Bullet 3, single precision: a hull with its margin of 0.04
 * units on a plane, the inertia that Bullet takes for it, ten iterations, no sleep. What
 * run_solids.py says: `case`, `friction`, `time`, `points` about the centroid, `go gx gy gz`. c++
 * -O2 bullet.cpp $(pkg-config --cflags --libs bullet) -o bullet */

#include <btBulletDynamicsCommon.h>

#include <iostream>
#include <string>
#include <vector>

struct solid {
  double friction = 0, step = 0, far = 0;
  int steps = 0;
  std::vector<btVector3> points;
};

static bool moves(const solid &own, const btVector3 &gravity) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(gravity);
  btScalar lowest = own.points.front().z();
  btConvexHullShape hull;
  for (const btVector3 &p : own.points) {
    hull.addPoint(p, false);
    lowest = btMin(lowest, p.z());
  }
  hull.recalcLocalAabb();
  btStaticPlaneShape plane(btVector3(0, 0, 1), lowest - hull.getMargin());
  btDefaultMotionState still, state;
  btRigidBody floor(btRigidBody::btRigidBodyConstructionInfo(0, &still, &plane));
  floor.setFriction(1); // the product of both counts
  btVector3 inertia;
  hull.calculateLocalInertia(1, inertia);
  btRigidBody block(btRigidBody::btRigidBodyConstructionInfo(1, &state, &hull, inertia));
  block.setFriction(static_cast<btScalar>(own.friction));
  block.setActivationState(DISABLE_DEACTIVATION);
  world.addRigidBody(&floor);
  world.addRigidBody(&block);
  bool is_far = false;
  for (int k = 0; k < own.steps && !is_far; k++) {
    world.stepSimulation(static_cast<btScalar>(own.step), 0);
    is_far = block.getCenterOfMassPosition().length() > static_cast<btScalar>(own.far);
  }
  world.removeRigidBody(&block);
  world.removeRigidBody(&floor);
  return is_far;
}

static btVector3 read_vector() {
  btScalar x = 0, y = 0, z = 0;
  std::cin >> x >> y >> z;
  return {x, y, z};
}

int main() {
  solid own;
  std::string word;
  while (std::cin >> word) {
    if (word == "case") own = {};
    if (word == "friction") std::cin >> own.friction;
    if (word == "time") std::cin >> own.step >> own.steps >> own.far;
    if (word == "points") {
      size_t count = 0;
      std::cin >> count;
      for (size_t k = 0; k < count; k++) own.points.push_back(read_vector());
    }
    if (word == "go") std::cout << moves(own, read_vector()) << std::endl;
  }
}
