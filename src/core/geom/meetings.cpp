/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs of edges that meet: candidates by intersecting bounding boxes (Zomorodian and Edelsbrunner,
 * in CGAL), each decided by exact orientation predicates: CGAL's on doubles, and our own, filtered,
 * on larger numbers. The boxes are doubles rounded outwards, so none is missed. */

#include "geom/boxes.hpp"
#include "geom/filtered.hpp"
#include "geom/rings.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace {

using EdgeBox = tp::Box<2>;
using EdgeBoxTraits = tp::BoxTraits<2>;

struct Stop {};

/* The predicates of tp::Filtered by CGAL, on coordinates that are doubles. */
class Exact {
public:
  explicit Exact(const tp_geom_rings &rings) : rings_(rings) {
  }

  int turn(size_t p, size_t q, size_t r) const {
    return CGAL::orientation(point(p), point(q), point(r));
  }

  bool less_xy(size_t p, size_t q) const {
    return rings_.u[p] < rings_.u[q] || (rings_.u[p] == rings_.u[q] && rings_.v[p] < rings_.v[q]);
  }

  void box(double low[2], double high[2], size_t p, size_t q) const {
    low[0] = std::min(rings_.u[p], rings_.u[q]);
    high[0] = std::max(rings_.u[p], rings_.u[q]);
    low[1] = std::min(rings_.v[p], rings_.v[q]);
    high[1] = std::max(rings_.v[p], rings_.v[q]);
  }

private:
  tp::Small::Point_2 point(size_t k) const {
    return tp::point<tp::Small>(rings_, k);
  }

  const tp_geom_rings &rings_;
};

bool overlap(const EdgeBox &one, const EdgeBox &other) {
  return one.low[0] <= other.high[0] && other.low[0] <= one.high[0] &&
         one.low[1] <= other.high[1] && other.low[1] <= one.high[1];
}

template <class Predicates> class Search {
public:
  Search(const tp_geom_rings &rings, tp_geom_visitor visitor, void *context)
      : rings_(rings), visitor_(visitor), context_(context), predicates_(rings) {
  }

  void run(long between) {
    const auto decide = [this](const EdgeBox &one, const EdgeBox &other) {
      const size_t a = std::min(one.number, other.number), b = std::max(one.number, other.number);
      const auto kind = meet(a, b);
      if (kind && !visitor_(context_, {*kind, a, b})) throw Stop();
    };
    if (between < 0) {
      auto all = boxes([](size_t) { return true; });
      CGAL::box_self_intersection_d(all.begin(), all.end(), decide, EdgeBoxTraits());
      return;
    }
    const auto own = static_cast<size_t>(between);
    auto others = boxes([own](size_t ring) { return ring != own; });
    const EdgeBox around = box_around(others);
    auto ours = boxes([own](size_t ring) { return ring == own; }, &around);
    CGAL::box_intersection_d(ours.begin(), ours.end(), others.begin(), others.end(), decide,
                             EdgeBoxTraits());
  }

private:
  /* Of the edges of some rings, those that meet a box. */
  template <class Choice>
  std::vector<EdgeBox> boxes(Choice is_chosen, const EdgeBox *within = nullptr) const {
    std::vector<EdgeBox> result;
    for (size_t ring = 0; ring < rings_.count; ring++) {
      if (!is_chosen(ring)) continue;
      for (size_t k = rings_.start[ring]; k < rings_.start[ring + 1]; k++) {
        EdgeBox own = {{}, {}, k};
        predicates_.box(own.low, own.high, k,
                        k + 1 == rings_.start[ring + 1] ? rings_.start[ring] : k + 1);
        if (within == nullptr || overlap(own, *within)) result.push_back(own);
      }
    }
    return result;
  }

  static EdgeBox box_around(const std::vector<EdgeBox> &boxes) {
    const double far = std::numeric_limits<double>::infinity();
    EdgeBox all = {{far, far}, {-far, -far}, 0};
    for (const auto &own : boxes) {
      for (int axis = 0; axis < 2; axis++) {
        all.low[axis] = std::min(all.low[axis], own.low[axis]);
        all.high[axis] = std::max(all.high[axis], own.high[axis]);
      }
    }
    return all;
  }

  size_t next(size_t edge) const {
    const size_t *end = std::upper_bound(rings_.start, rings_.start + rings_.count + 1, edge);
    return edge + 1 == *end ? *(end - 1) : edge + 1;
  }

  std::optional<tp_geom_meeting_kind> meet(size_t a, size_t b) const {
    const size_t p = a, q = next(a), r = b, s = next(b);
    const int pqr = predicates_.turn(p, q, r), pqs = predicates_.turn(p, q, s);
    if (pqr == 0 && pqs == 0) return meet_on_line(a, b);
    if (q == b || s == a) return std::nullopt; /* only in their common vertex */
    if (pqr * pqs > 0) return std::nullopt;
    const int rsp = predicates_.turn(r, s, p), rsq = predicates_.turn(r, s, q);
    if (rsp * rsq > 0) return std::nullopt;
    return pqr * pqs < 0 && rsp * rsq < 0 ? TP_GEOM_CROSS : TP_GEOM_TOUCH;
  }

  std::optional<tp_geom_meeting_kind> meet_on_line(size_t a, size_t b) const {
    const auto less = [this](size_t p, size_t q) { return predicates_.less_xy(p, q); };
    const size_t next_a = next(a), next_b = next(b);
    const size_t low = std::max(std::min(a, next_a, less), std::min(b, next_b, less), less);
    const size_t high = std::min(std::max(a, next_a, less), std::max(b, next_b, less), less);
    if (less(high, low)) return std::nullopt;
    if (less(low, high)) return TP_GEOM_OVERLAP;
    if (next_a == b || next_b == a) return std::nullopt;
    return TP_GEOM_TOUCH;
  }

  const tp_geom_rings &rings_;
  tp_geom_visitor visitor_;
  void *context_;
  Predicates predicates_;
};

} // namespace

tp_geom_status tp_geom_find_meetings(const tp_geom_rings *rings, long between,
                                     tp_geom_visitor visitor, void *context) {
  return tp::guard([&] {
    try {
      if (rings->small) {
        Search<Exact>(*rings, visitor, context).run(between);
      } else {
        Search<tp::Filtered>(*rings, visitor, context).run(between);
      }
    } catch (const Stop &) {
      /* the visitor has seen enough */
    }
    return TP_GEOM_OK;
  });
}
