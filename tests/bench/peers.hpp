// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The Topple authors

// The polygons that the libraries are compared on, and what each of them answers.

#ifndef TP_PEERS_HPP
#define TP_PEERS_HPP

#include <flint/fmpz.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace peers {

constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

// NONE is what a library does not compute.
struct Answer {
  double area, x, y;
};

// The same coordinates as doubles and as integers.
struct Polygon {
  std::vector<double> u, v;
  std::vector<fmpz> x, y;

  Polygon() = default;
  Polygon(const Polygon &) = delete;
  Polygon &operator=(const Polygon &) = delete;

  ~Polygon() {
    for (fmpz &value : x) fmpz_clear(&value);
    for (fmpz &value : y) fmpz_clear(&value);
  }

  void add(long across, long up) {
    if (!u.empty() && u.back() == double(across) && v.back() == double(up)) return;
    u.push_back(double(across));
    v.push_back(double(up));
  }
};

// About `wanted` vertices: floor and roof rise and fall by a unit at random, the walls have unit
// edges.
inline void make_rough_square(Polygon &p, long wanted, long offset) {
  std::mt19937 random(2026);
  const long width = std::max(1L, wanted / 4), height = std::max(3L, width / 2);
  for (long k = 0; k < width; k++) {
    const long rise = k == 0 || k + 1 == width ? 0 : long(random() % 2);
    p.add(offset + k, offset + rise);
    p.add(offset + k + 1, offset + rise);
  }
  for (long k = 1; k < height; k++) p.add(offset + width, offset + k);
  for (long k = width; k > 0; k--) {
    const long fall = k == 1 || k == width ? 0 : long(random() % 2);
    p.add(offset + k, offset + height - fall);
    p.add(offset + k - 1, offset + height - fall);
  }
  for (long k = height - 1; k > 0; k--) p.add(offset, offset + k);
  p.x.assign(p.u.size(), 0);
  p.y.assign(p.u.size(), 0);
  for (size_t k = 0; k < p.u.size(); k++) {
    fmpz_set_d(&p.x[k], p.u[k]);
    fmpz_set_d(&p.y[k], p.v[k]);
  }
}

using Method = std::function<Answer()>;

struct Named {
  std::string name;
  Method run;
};

} // namespace peers

#endif
