/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Candidates of triangles that meet by intersecting bounding boxes (Zomorodian and Edelsbrunner),
 * each pair decided by exact orientations; the hull by quickhull: both of CGAL.
 *
 * Two triangles that share an edge lie in two half planes that end in it, and meet elsewhere where
 * these are one: where the other two corners lie in one plane with it and on the same side. Two
 * that share a corner meet elsewhere where the side of one opposite that corner meets the other, or
 * the other way round: a segment that both have in common begins in the corner and ends in such a
 * side. */

#include "geom/solid.h"

#include "geom/boxes.hpp"
#include "geom/rings.hpp"

#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace {

template <class Kernel> class Space;

/* Coordinates that are doubles. */
template <> class Space<tp::Small> {
public:
  using Point = tp::Small::Point_3;
  explicit Space(const tp_geom_points &points) : near_(points.near) {
  }
  Point operator()(size_t k) const {
    return Point(near_[3 * k], near_[3 * k + 1], near_[3 * k + 2]);
  }

private:
  const double *near_;
};

/* Larger ones, made once. */
template <> class Space<tp::Large> {
public:
  using Point = tp::Large::Point_3;
  explicit Space(const tp_geom_points &points) {
    points_.reserve(points.count);
    for (size_t k = 0; k < points.count; k++) {
      const fmpz *own = points.whole + 3 * k;
      if (points.weights == nullptr || fmpz_is_one(points.weights + k)) {
        points_.emplace_back(tp::exact_integer(own), tp::exact_integer(own + 1),
                             tp::exact_integer(own + 2));
        continue;
      }
      const auto weight = tp::exact_integer(points.weights + k);
      points_.emplace_back(tp::exact_integer(own) / weight, tp::exact_integer(own + 1) / weight,
                           tp::exact_integer(own + 2) / weight);
    }
  }
  const Point &operator()(size_t k) const {
    return points_[k];
  }

private:
  std::vector<Point> points_;
};

using TriangleBox = tp::Box<3>;
using TriangleBoxTraits = tp::BoxTraits<3>;

template <class Kernel> class Clashes {
public:
  Clashes(const tp_geom_points &points, const int *triangles)
      : points_(points), space_(points), triangles_(triangles) {
  }

  void run(tp_geom_clashes *clashes, size_t count, bool *marks) const {
    std::vector<TriangleBox> boxes(count);
    for (size_t k = 0; k < count; k++) boxes[k] = box(k);
    const auto decide = [&](const TriangleBox &one, const TriangleBox &other) {
      const size_t a = std::min(one.number, other.number);
      const size_t b = std::max(one.number, other.number);
      if (!meet(a, b)) return;
      if (marks != nullptr) marks[a] = marks[b] = true;
      if (clashes->count++ > 0 &&
          !(a < clashes->first || (a == clashes->first && b < clashes->second))) {
        return;
      }
      clashes->first = a;
      clashes->second = b;
    };
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), decide, TriangleBoxTraits());
  }

private:
  using Corners = std::array<int, 3>;

  Corners corners(size_t k) const {
    return {triangles_[3 * k], triangles_[3 * k + 1], triangles_[3 * k + 2]};
  }

  /* Rounded coordinates are off by half a unit in the last place at most: one farther out. */
  TriangleBox box(size_t k) const {
    const double far = std::numeric_limits<double>::infinity();
    TriangleBox own = {{far, far, far}, {-far, -far, -far}, k};
    for (const int corner : corners(k)) {
      for (int axis = 0; axis < 3; axis++) {
        const double at = points_.near[3 * static_cast<size_t>(corner) + axis];
        own.low[axis] = std::min(own.low[axis], points_.small ? at : std::nextafter(at, -far));
        own.high[axis] = std::max(own.high[axis], points_.small ? at : std::nextafter(at, far));
      }
    }
    return own;
  }

  /* Turned so that the corners that are shared come first, in both. */
  static int share(Corners &a, Corners &b) {
    int shared = 0;
    for (int i = 0; i < 3; i++) {
      for (int j = shared; j < 3; j++) {
        if (a[i] != b[j]) continue;
        std::swap(a[shared], a[i]);
        std::swap(b[shared], b[j]);
        shared++;
        break;
      }
    }
    return shared;
  }

  bool meet(size_t one, size_t other) const {
    Corners a = corners(one), b = corners(other);
    switch (share(a, b)) {
    case 0:
      return CGAL::do_intersect(triangle(a), triangle(b));
    case 1:
      return side_meets(a, b) || side_meets(b, a);
    case 2:
      return CGAL::orientation(at(a[0]), at(a[1]), at(a[2]), at(b[2])) == CGAL::COPLANAR &&
             CGAL::coplanar_orientation(at(a[0]), at(a[1]), at(a[2]), at(b[2])) == CGAL::POSITIVE;
    default: /* one triangle of two surfaces that touch over it */
      return false;
    }
  }

  /* Of a the side opposite its first corner. */
  bool side_meets(const Corners &a, const Corners &b) const {
    return CGAL::do_intersect(typename Kernel::Segment_3(at(a[1]), at(a[2])), triangle(b));
  }

  typename Kernel::Point_3 at(int k) const {
    return space_(static_cast<size_t>(k));
  }

  typename Kernel::Triangle_3 triangle(const Corners &own) const {
    return typename Kernel::Triangle_3(at(own[0]), at(own[1]), at(own[2]));
  }

  const tp_geom_points &points_;
  const Space<Kernel> space_;
  const int *triangles_;
};

/* Which of all points each corner equals, the first of equal ones; -1: none. */
template <class Point>
std::vector<int> find_points(const std::vector<Point> &corners, const std::vector<Point> &all) {
  std::vector<int> order(corners.size()), found(corners.size(), -1);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return CGAL::lexicographically_xyz_smaller(corners[a], corners[b]);
  });
  for (size_t k = 0; k < all.size(); k++) {
    const auto place =
        std::lower_bound(order.begin(), order.end(), all[k], [&](int a, const Point &point) {
          return CGAL::lexicographically_xyz_smaller(corners[a], point);
        });
    if (place == order.end() || corners[*place] != all[k] || found[*place] >= 0) continue;
    found[*place] = static_cast<int>(k);
  }
  return found;
}

/* CGAL chooses the predicates by the type of what it fills: for a Surface_mesh exact ones. (For two
 * arrays it takes, in 5.5, planes with rounded coefficients, which made hulls with dents and
 * crashed.) */
template <class Kernel> tp_geom_status propose(tp_geom_hull *hull, const tp_geom_points &points) {
  using Point = typename Kernel::Point_3;
  const Space<Kernel> space(points);
  std::vector<Point> all, corners;
  all.reserve(points.count);
  for (size_t k = 0; k < points.count; k++) all.push_back(space(k));
  CGAL::Surface_mesh<Point> mesh;
  CGAL::convex_hull_3(all.begin(), all.end(), mesh);
  if (mesh.number_of_faces() < 4) return TP_GEOM_FAILED;
  corners.reserve(mesh.number_of_vertices());
  for (const auto vertex : mesh.vertices()) corners.push_back(mesh.point(vertex));
  const std::vector<int> found = find_points(corners, all);
  auto *triangles = static_cast<int *>(std::malloc(3 * mesh.number_of_faces() * sizeof(int)));
  if (triangles == nullptr) return TP_GEOM_OUT_OF_MEMORY;
  size_t count = 0;
  for (const auto face : mesh.faces()) {
    auto side = mesh.halfedge(face);
    for (int c = 0; c < 3; c++, side = mesh.next(side))
      triangles[count++] = found[mesh.target(side)];
  }
  *hull = tp_geom_hull{count / 3, triangles};
  return TP_GEOM_OK;
}

} // namespace

tp_geom_status tp_geom_find_clashes(tp_geom_clashes *clashes, const tp_geom_points *points,
                                    const int *triangles, size_t count, bool *marks) {
  *clashes = tp_geom_clashes{0, 0, 0};
  return tp::guard([&] {
    if (points->small) {
      Clashes<tp::Small>(*points, triangles).run(clashes, count, marks);
    } else {
      Clashes<tp::Large>(*points, triangles).run(clashes, count, marks);
    }
    return TP_GEOM_OK;
  });
}

tp_geom_status tp_geom_propose_hull(tp_geom_hull *hull, const tp_geom_points *points, bool exact) {
  *hull = tp_geom_hull{0, nullptr};
  return tp::guard([&] {
    return points->small && !exact ? propose<tp::Small>(hull, *points)
                                   : propose<tp::Large>(hull, *points);
  });
}

void tp_geom_hull_clear(tp_geom_hull *hull) {
  std::free(hull->triangles);
  *hull = tp_geom_hull{0, nullptr};
}
