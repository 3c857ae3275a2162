/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With v = -(A x + u + c) >= 0, multipliers y of v, a of u >= 0 and b of u <= most, the margins and
 * all multipliers are eliminated row by row; what remains are x and the multipliers of E. */

#include "linear_program/margins.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

struct Factors : Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> {
  double work() const {
    double sum = 0;
    for (Eigen::Index k = 0; k < m_nonZerosPerCol.size(); k++) {
      sum += double(m_nonZerosPerCol[k]) * double(m_nonZerosPerCol[k]);
    }
    return sum;
  }
};

Matrix matrix_of(const tp_margin_rows &rows, long columns) {
  std::vector<Eigen::Triplet<double>> all;
  for (long r = 0; r < rows.count; r++) {
    for (long k = rows.first[r]; k < rows.first[r + 1]; k++) {
      all.emplace_back(int(r), int(rows.column[k]), rows.entry[k]);
    }
  }
  Matrix m(rows.count, columns);
  m.setFromTriplets(all.begin(), all.end());
  return m;
}

Vector constants_of(const tp_margin_rows &rows) {
  Vector c(rows.count);
  for (long r = 0; r < rows.count; r++) c[r] = -rows.constant[r];
  return c;
}

/* How far a positive vector can go along a step, of 1 at most. */
double reach(double most, const Vector &x, const Vector &step) {
  for (Eigen::Index k = 0; k < x.size(); k++) {
    if (step[k] < 0) most = std::min(most, -x[k] / step[k]);
  }
  return most;
}

class Search {
public:
  explicit Search(const tp_margin_program &p)
      : wants(p.wants_margin), most(p.most), a(matrix_of(p.rows, p.columns)),
        e(matrix_of(p.equations, p.columns)), at(a.transpose()), et(e.transpose()),
        limit(constants_of(p.rows)), equal(constants_of(p.equations)), n(p.columns),
        rows(p.rows.count), equations(p.equations.count) {
    x = Vector::Zero(n);
    multipliers = Vector::Zero(equations);
    y = v = Vector::Ones(rows);
    u = low = high = Vector::Zero(rows);
    for (long k = 0; k < rows; k++) {
      if (!wants[k]) continue;
      u[k] = most / 2;
      low[k] = high[k] = 1;
    }
  }

  bool find(double most_work) {
    static const double best = 1e-9, enough = 1e-5; /* of margins of a thousandth */
    enum { MOST_STEPS = 60, SLOW = 3 };
    bool done = false, goes_on = true;
    int slow = 0;
    for (int k = 0; k < MOST_STEPS && goes_on && !done; k++) {
      set_residuals();
      done = mean < best && is_solved(best);
      if (!done) goes_on = factorise(most_work) && step();
      slow = reached < 0.1 ? slow + 1 : 0;
      goes_on = goes_on && slow < SLOW;
    }
    return mean < enough && is_solved(enough);
  }

  Vector x, u;

private:
  const bool *wants;
  double most, mean = 0, reached = 1;
  Matrix a, e, at, et;
  Vector limit, equal;
  long n, rows, equations, products = 0;
  Vector v, y, low, high, multipliers, off, off_equal, off_dual;
  Vector weight;
  Matrix system;
  Factors factors;
  bool analysed = false;

  static double size(const Vector &v) {
    return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0;
  }

  bool is_solved(double near) const {
    return std::max(size(off), size(off_equal)) < 10 * near;
  }

  void set_residuals() {
    off = limit - a * x - v - u;
    off_equal = equal - e * x;
    off_dual = -(at * y + et * multipliers);
    double sum = 0;
    products = rows;
    for (long k = 0; k < rows; k++) {
      sum += y[k] * v[k];
      if (!wants[k]) continue;
      sum += low[k] * u[k] + high[k] * (most - u[k]);
      products += 2;
    }
    mean = sum / double(products);
  }

  double stiffness(long k) const {
    return low[k] / u[k] + high[k] / (most - u[k]);
  }

  bool factorise(double most_work) {
    static const double of_columns = 1e-6, of_equations = 1e-7;
    weight = Vector(rows);
    for (long k = 0; k < rows; k++) {
      const double d = y[k] / v[k];
      weight[k] = wants[k] ? d * stiffness(k) / (d + stiffness(k)) : d;
    }
    const Matrix squares = at * weight.asDiagonal() * a;
    std::vector<Eigen::Triplet<double>> all;
    for (int c = 0; c < n; c++) {
      for (Matrix::InnerIterator k(squares, c); k; ++k) {
        if (k.row() >= c) all.emplace_back(int(k.row()), c, k.value());
      }
      all.emplace_back(c, c, of_columns);
      for (Matrix::InnerIterator k(e, c); k; ++k) {
        all.emplace_back(int(n + k.row()), c, k.value());
      }
    }
    for (long k = 0; k < equations; k++) all.emplace_back(n + k, n + k, -of_equations);
    system = Matrix(n + equations, n + equations);
    system.setFromTriplets(all.begin(), all.end());
    if (!analysed) {
      factors.analyzePattern(system);
      if (factors.work() > most_work) return false;
    }
    analysed = true;
    factors.factorize(system);
    return factors.info() == Eigen::Success;
  }

  struct Step {
    Vector x, v, u, y, low, high, multipliers;
  };

  /* The products y v, low u and high (most - u) are to be `target` less what `known` changes. */
  Step solve(double target, const Step *known) const {
    Vector fixed(rows), own_u = Vector::Zero(rows), first(rows);
    for (long k = 0; k < rows; k++) {
      const double d = y[k] / v[k];
      first[k] = (target - (known ? known->v[k] * known->y[k] : 0)) / v[k] - y[k] - d * off[k];
      fixed[k] = first[k];
      if (!wants[k]) continue;
      const double to_low = target - (known ? known->u[k] * known->low[k] : 0);
      const double to_high = target + (known ? known->u[k] * known->high[k] : 0);
      own_u[k] =
          (1 - y[k] - first[k] + to_low / u[k] - to_high / (most - u[k])) / (d + stiffness(k));
      fixed[k] += d * own_u[k];
    }
    Vector right(n + equations);
    right << off_dual - at * fixed, off_equal;
    Vector all = factors.solve(right);
    all += factors.solve(right - system.selfadjointView<Eigen::Lower>() * all);
    Step s;
    s.x = all.head(n);
    s.multipliers = all.tail(equations);
    const Vector change = a * s.x;
    s.u = s.low = s.high = Vector::Zero(rows);
    s.v = s.y = Vector(rows);
    for (long k = 0; k < rows; k++) {
      const double d = y[k] / v[k];
      if (wants[k]) s.u[k] = own_u[k] - d / (d + stiffness(k)) * change[k];
      s.v[k] = off[k] - change[k] - s.u[k];
      s.y[k] = first[k] + d * (change[k] + s.u[k]);
      if (!wants[k]) continue;
      const double to_low = target - (known ? known->u[k] * known->low[k] : 0);
      const double to_high = target + (known ? known->u[k] * known->high[k] : 0);
      s.low[k] = (to_low - low[k] * s.u[k]) / u[k] - low[k];
      s.high[k] = (to_high + high[k] * s.u[k]) / (most - u[k]) - high[k];
    }
    return s;
  }

  double reach_of_points(const Step &s) const {
    const double up_to = reach(reach(1, v, s.v), u, s.u);
    double most_up = up_to;
    for (long k = 0; k < rows; k++) {
      if (wants[k] && s.u[k] > 0) most_up = std::min(most_up, (most - u[k]) / s.u[k]);
    }
    return most_up;
  }

  double reach_of_multipliers(const Step &s) const {
    return reach(reach(reach(1, y, s.y), low, s.low), high, s.high);
  }

  bool step() {
    static const double damping = 0.95;
    const Step first = solve(0, nullptr);
    const double p = reach_of_points(first), d = reach_of_multipliers(first);
    double after = 0;
    for (long k = 0; k < rows; k++) {
      after += (y[k] + d * first.y[k]) * (v[k] + p * first.v[k]);
      if (!wants[k]) continue;
      after += (low[k] + d * first.low[k]) * (u[k] + p * first.u[k]);
      after += (high[k] + d * first.high[k]) * (most - u[k] - p * first.u[k]);
    }
    const double share = after / (double(products) * mean);
    const Step s = solve(share * share * share * mean, &first);
    const double of_points = damping * reach_of_points(s);
    const double of_multipliers = damping * reach_of_multipliers(s);
    reached = std::max(of_points, of_multipliers);
    x += of_points * s.x;
    v += of_points * s.v;
    u += of_points * s.u;
    y += of_multipliers * s.y;
    low += of_multipliers * s.low;
    high += of_multipliers * s.high;
    multipliers += of_multipliers * s.multipliers;
    return std::isfinite(x.sum()) && std::isfinite(y.sum());
  }
};

} // namespace

extern "C" bool tp_margins_find(bool *found, double *x, double *margin,
                                const tp_margin_program *program) {
  *found = false;
  try {
    Search search(*program);
    *found = search.find(program->most_work);
    std::copy(search.x.data(), search.x.data() + search.x.size(), x);
    std::copy(search.u.data(), search.u.data() + search.u.size(), margin);
  } catch (const std::exception &) {
    return false;
  }
  return true;
}
