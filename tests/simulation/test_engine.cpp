// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// The static limit against a rigid-body engine that knows nothing of it: Box2D.
//
// A toothed block stands on its counterpart; gravity turns, slowly, up to a tilt and stays there.
// The largest tilt at which the block stays where it was, by halving, must be the limit within 0.05
// degrees. That is: 0.01 of halving; corners rounded by 1 cm on blocks of about 100 m (0.006 of
// lever arms); and what half a minute does not show: 0.03 degrees beyond the limit the block is
// short of 0.05 % of its weight, and goes 2 m in that time. With an argument, times as well.

#include <topple.h>

#include <box2d/box2d.h>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <unistd.h>
#include <vector>

namespace {

constexpr float GRAVITY = 10.0F, STEP = 1.0F / 60.0F, FRICTION_DEG = 30.0F;
constexpr int VELOCITY_ITERATIONS = 200, POSITION_ITERATIONS = 20;
constexpr double TOLERANCE_DEG = 0.05;

// A block of the paper in mm, tilted towards the left; one mm is a metre in the engine.
struct Block {
  const char *name;
  int count;
  float a, b, c;
  bool valley; // its left end
  bool goes_on;
};

const Block blocks[] = {
    {"A peak", 3, 15, 94, 5, false, false},   {"A valley", 3, 15, 94, 5, true, false},
    {"E peak", 3, 30, 120, 5, false, false},  {"E valley", 3, 30, 120, 5, true, false},
    {"E valley+", 3, 30, 120, 5, true, true}, {"F", 2, 30, 118, 5, true, false},
    {"F+", 2, 30, 118, 5, true, true},        {"G", 2, 30, 123, 5, false, false},
};

float radians(double degrees) {
  return static_cast<float>(degrees * M_PI / 180);
}

float height_of(const Block &block, int joint) {
  return (joint % 2 == 0) == block.valley ? 0 : block.c;
}

void add_polygon(b2Body *body, const std::vector<b2Vec2> &points) {
  b2PolygonShape shape;
  shape.Set(points.data(), static_cast<int>(points.size()));
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 1;
  fixture.friction = std::tan(radians(FRICTION_DEG));
  body->CreateFixture(&fixture);
}

// Does the block stay at this tilt?
bool stays(const Block &block, double degrees) {
  b2World world(b2Vec2(0, -GRAVITY));
  world.SetAllowSleeping(false);
  world.SetContinuousPhysics(false);
  b2BodyDef definition;
  b2Body *base = world.CreateBody(&definition);
  definition.type = b2_dynamicBody;
  b2Body *body = world.CreateBody(&definition);
  const float top = block.b + block.c;
  for (int k = block.goes_on ? -1 : 0; k < block.count; k++) {
    const float x0 = static_cast<float>(k) * block.a, x1 = x0 + block.a;
    const float y0 = height_of(block, k + 2), y1 = height_of(block, k + 3);
    add_polygon(base, {{x0, -50}, {x1, -50}, {x1, y1}, {x0, y0}});
    if (k >= 0) add_polygon(body, {{x0, y0}, {x1, y1}, {x1, top}, {x0, top}});
  }
  const float ramp = 20, hold = 30;
  b2Vec2 start = body->GetWorldCenter();
  for (float time = 0; time < ramp + hold; time += STEP) {
    const float tilt = radians(degrees) * std::fmin(time / ramp, 1);
    world.SetGravity(b2Vec2(-GRAVITY * std::sin(tilt), -GRAVITY * std::cos(tilt)));
    world.Step(STEP, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
    if (time < 1) start = body->GetWorldCenter(); // settled on its skin
    if ((body->GetWorldCenter() - start).Length() > 0.02F * top) return false;
  }
  return true;
}

double let_go(const Block &block) {
  double low = 5, high = 60;
  while (high - low > 0.02) {
    const double middle = (low + high) / 2;
    (stays(block, middle) ? low : high) = middle;
  }
  return (low + high) / 2;
}

// The limit by Topple; not a number where something fails.
double limit(const Block &block) {
  char path[] = "/tmp/topple-engine-XXXXXX";
  const int handle = mkstemp(path);
  FILE *file = handle < 0 ? nullptr : fdopen(handle, "w");
  if (file == nullptr) return NAN;
  std::fprintf(file,
               "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: %d, width: %g, height: %g, "
               "depth: %g, left_end: %s}\nbase: {mated: true, beyond: {left: %g, right: 0}}\n"
               "friction_angle_deg: %g\ntilt: {towards: left}\n",
               block.count, block.a, block.b, block.c, block.valley ? "valley" : "peak",
               block.goes_on ? block.a : 0.0F, FRICTION_DEG);
  std::fclose(file);
  tp_scene *scene = nullptr;
  tp_solution *solution = nullptr;
  tp_message message = {};
  const tp_solve_options options = tp_solve_options_default();
  double found = NAN;
  if (tp_scene_read(&scene, path, &message) == TP_OK &&
      tp_solve(&solution, scene, &options, &message) == TP_OK) {
    found = solution->cases[0].limit.critical_angle_deg.value;
  } else {
    std::fprintf(stderr, "%s\n", message.text);
  }
  unlink(path);
  tp_solution_free(solution);
  tp_scene_free(scene);
  return found;
}

} // namespace

int main(int argc, char **) {
  int passed = 0, failed = 0;
  std::printf("block        limit   Box2D    apart%s\n", argc > 1 ? "   Box2D s" : "");
  for (const Block &block : blocks) {
    const auto began = std::chrono::steady_clock::now();
    const double own = limit(block), other = let_go(block);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - began;
    const bool agrees = std::fabs(own - other) <= TOLERANCE_DEG;
    std::printf("%-10s %7.3f %7.3f  %7.3f", block.name, own, other, other - own);
    if (argc > 1) std::printf("   %7.2f", taken.count());
    std::printf("%s\n", agrees ? "" : "   FAILED");
    (agrees ? passed : failed)++;
  }
  std::printf("%d passed, %d failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
