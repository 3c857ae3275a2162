// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

/* What run.py says to an engine: words and numbers on standard input, lengths in the engine's
 * units, until `go gx gy` asks whether the block moves under that gravity; the answer is a line, 1
 * or 0. Loads are forces over the mass of the block; `shake` is of the questions that follow. */

#pragma once

#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

struct scene {
  using points = std::vector<std::array<double, 2>>;
  double friction = 0, step = 0, far = 0;
  int steps = 0;
  std::vector<points> rock;                // lines
  std::vector<std::vector<points>> blocks; // each of convex pieces
  std::vector<std::array<double, 4>> loads;
  double peak = 0, frequency = 0; // of a whole sine by which the rock is accelerated

  /// In the frame of the rock, halfway through a step.
  std::array<double, 2> gravity_at(int k, const double gravity[2]) const {
    const double cycles = frequency * (k + 0.5) * step;
    return {gravity[0] - (cycles < 1 ? peak * std::sin(2 * std::acos(-1.0) * cycles) : 0),
            gravity[1]};
  }
};

inline scene::points read_points() {
  size_t count = 0;
  std::cin >> count;
  scene::points list(count);
  for (auto &p : list) std::cin >> p[0] >> p[1];
  return list;
}

/// Reads up to the next question; false at the end.
inline bool next_question(scene &own, double gravity[2]) {
  std::string word;
  while (std::cin >> word) {
    if (word == "case") own = {};
    if (word == "friction") std::cin >> own.friction;
    if (word == "time") std::cin >> own.step >> own.steps >> own.far;
    if (word == "rock") own.rock.push_back(read_points());
    if (word == "block") own.blocks.emplace_back();
    if (word == "piece") own.blocks.back().push_back(read_points());
    if (word == "load") {
      own.loads.emplace_back();
      for (double &v : own.loads.back()) std::cin >> v;
    }
    if (word == "shake") std::cin >> own.peak >> own.frequency;
    if (word == "go") return static_cast<bool>(std::cin >> gravity[0] >> gravity[1]);
  }
  return false;
}
