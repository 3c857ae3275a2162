/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs of edges that meet: candidates by intersecting bounding boxes (Zomorodian and Edelsbrunner,
 * in CGAL), each decided by exact orientation predicates. The boxes are doubles rounded outwards,
 * so none is missed. */

#include "rings.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <optional>

namespace {

struct EdgeBox {
  double low[2], high[2];
  size_t edge;
};

struct EdgeBoxTraits {
  using NT = double;
  using Box_parameter = const EdgeBox &;
  using ID = size_t;
  static int dimension() {
    return 2;
  }
  static double min_coord(const EdgeBox &box, int axis) {
    return box.low[axis];
  }
  static double max_coord(const EdgeBox &box, int axis) {
    return box.high[axis];
  }
  static size_t id(const EdgeBox &box) {
    return box.edge;
  }
};

struct Stop {};

template <class Kernel> class Search {
public:
  Search(const tp_geom_rings &rings, tp_geom_visitor visitor, void *context)
      : rings_(rings), visitor_(visitor), context_(context),
        points_(tp::points<Kernel>(rings, 0, tp::vertex_count(rings))), next_(points_.size()),
        ring_(points_.size()) {
    for (size_t r = 0; r < rings.count; r++) {
      for (size_t k = rings.start[r]; k < rings.start[r + 1]; k++) {
        next_[k] = k + 1 == rings.start[r + 1] ? rings.start[r] : k + 1;
        ring_[k] = r;
      }
    }
  }

  void run(long between) {
    const auto decide = [this](const EdgeBox &one, const EdgeBox &other) {
      const size_t a = std::min(one.edge, other.edge), b = std::max(one.edge, other.edge);
      const auto kind = meet(a, b);
      if (kind && !visitor_(context_, {*kind, a, b})) throw Stop();
    };
    std::vector<EdgeBox> ours, others;
    for (size_t k = 0; k < points_.size(); k++) {
      const bool own = between < 0 || ring_[k] == static_cast<size_t>(between);
      (own ? ours : others).push_back(box(k));
    }
    if (between < 0) {
      CGAL::box_self_intersection_d(ours.begin(), ours.end(), decide, EdgeBoxTraits());
    } else {
      CGAL::box_intersection_d(ours.begin(), ours.end(), others.begin(), others.end(), decide,
                               EdgeBoxTraits());
    }
  }

private:
  EdgeBox box(size_t edge) const {
    const auto extent = points_[edge].bbox() + points_[next_[edge]].bbox();
    return {{extent.xmin(), extent.ymin()}, {extent.xmax(), extent.ymax()}, edge};
  }

  std::optional<tp_geom_meeting_kind> meet(size_t a, size_t b) const {
    const auto &p = points_[a], &q = points_[next_[a]], &r = points_[b], &s = points_[next_[b]];
    const auto pqr = CGAL::orientation(p, q, r), pqs = CGAL::orientation(p, q, s);
    const auto rsp = CGAL::orientation(r, s, p), rsq = CGAL::orientation(r, s, q);
    if (pqr == CGAL::COLLINEAR && pqs == CGAL::COLLINEAR) return meet_on_line(a, b);
    if (next_[a] == b || next_[b] == a) return std::nullopt; /* only in their common vertex */
    if (pqr * pqs > 0 || rsp * rsq > 0) return std::nullopt;
    return pqr * pqs < 0 && rsp * rsq < 0 ? TP_GEOM_CROSS : TP_GEOM_TOUCH;
  }

  std::optional<tp_geom_meeting_kind> meet_on_line(size_t a, size_t b) const {
    const auto less = typename Kernel::Less_xy_2();
    const auto &[low_a, high_a] = std::minmax(points_[a], points_[next_[a]], less);
    const auto &[low_b, high_b] = std::minmax(points_[b], points_[next_[b]], less);
    const auto &low = std::max(low_a, low_b, less), &high = std::min(high_a, high_b, less);
    if (less(high, low)) return std::nullopt;
    if (less(low, high)) return TP_GEOM_OVERLAP;
    if (next_[a] == b || next_[b] == a) return std::nullopt;
    return TP_GEOM_TOUCH;
  }

  const tp_geom_rings &rings_;
  tp_geom_visitor visitor_;
  void *context_;
  std::vector<typename Kernel::Point_2> points_;
  std::vector<size_t> next_, ring_;
};

} // namespace

tp_geom_status tp_geom_find_meetings(const tp_geom_rings *rings, long between,
                                     tp_geom_visitor visitor, void *context) {
  return tp::guard([&] {
    try {
      if (rings->small) {
        Search<tp::Small>(*rings, visitor, context).run(between);
      } else {
        Search<tp::Large>(*rings, visitor, context).run(between);
      }
    } catch (const Stop &) {
      /* the visitor has seen enough */
    }
    return TP_GEOM_OK;
  });
}
