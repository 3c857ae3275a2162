/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Predicates on rings of whole numbers of any size: in doubles with a bound of their error first,
 * in the whole numbers where these do not tell.
 *
 * With M the largest |u|, each u is off by 2^-52 M, and a difference of two by 2 2^-52 M and its
 * rounding, 2^-52 M: E_u = 2^-50 M covers it, E_v likewise. Then a d - b c, of such differences, is
 * off by at most E_u (|d| + |b|) + E_v (|a| + |c|) + 2 E_u E_v + 2^-52 (|a d| + |b c|), less than
 * what is compared, which is rounded in turn. */

#ifndef TP_GEOM_FILTERED_HPP
#define TP_GEOM_FILTERED_HPP

#include "geom/geom.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace tp {

class Filtered {
public:
  explicit Filtered(const tp_geom_rings &rings) : rings_(rings) {
    const size_t count = rings.start[rings.count];
    for (size_t k = 0; k < count; k++) {
      error_u_ = std::max(error_u_, std::fabs(rings.u[k]));
      error_v_ = std::max(error_v_, std::fabs(rings.v[k]));
    }
    error_u_ *= 4 * DBL_EPSILON;
    error_v_ *= 4 * DBL_EPSILON;
    for (auto &number : work_) fmpz_init(number);
  }
  ~Filtered() {
    for (auto &number : work_) fmpz_clear(number);
  }
  Filtered(const Filtered &) = delete;
  Filtered &operator=(const Filtered &) = delete;

  /* 1 where r lies left of the line from p to q, 0 on it, -1 right of it. */
  int turn(size_t p, size_t q, size_t r) const {
    const double *u = rings_.u, *v = rings_.v;
    const double a = u[q] - u[p], b = v[q] - v[p], c = u[r] - u[p], d = v[r] - v[p];
    const double one = a * d, other = b * c, value = one - other;
    const double bound = error_u_ * (std::fabs(d) + std::fabs(b)) +
                         error_v_ * (std::fabs(a) + std::fabs(c)) + 2 * error_u_ * error_v_ +
                         4 * DBL_EPSILON * (std::fabs(one) + std::fabs(other));
    if (std::fabs(value) > bound * (1 + 16 * DBL_EPSILON)) return value > 0 ? 1 : -1;
    return exact_turn(p, q, r);
  }

  bool less_xy(size_t p, size_t q) const {
    const int order = fmpz_cmp(rings_.x + p, rings_.x + q);
    return order < 0 || (order == 0 && fmpz_cmp(rings_.y + p, rings_.y + q) < 0);
  }

  /* Around the edge from p to q, and a little more. */
  void box(double low[2], double high[2], size_t p, size_t q) const {
    low[0] = std::min(rings_.u[p], rings_.u[q]) - error_u_;
    high[0] = std::max(rings_.u[p], rings_.u[q]) + error_u_;
    low[1] = std::min(rings_.v[p], rings_.v[q]) - error_v_;
    high[1] = std::max(rings_.v[p], rings_.v[q]) + error_v_;
  }

private:
  int exact_turn(size_t p, size_t q, size_t r) const {
    fmpz_sub(work_[0], rings_.x + q, rings_.x + p);
    fmpz_sub(work_[1], rings_.y + r, rings_.y + p);
    fmpz_mul(work_[2], work_[0], work_[1]);
    fmpz_sub(work_[0], rings_.y + q, rings_.y + p);
    fmpz_sub(work_[1], rings_.x + r, rings_.x + p);
    fmpz_submul(work_[2], work_[0], work_[1]);
    return fmpz_sgn(work_[2]);
  }

  const tp_geom_rings &rings_;
  double error_u_ = 0, error_v_ = 0;
  mutable fmpz_t work_[3];
};

} // namespace tp

#endif
