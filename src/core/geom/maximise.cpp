/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The exact linear program of three rows by CGAL's simplex solver over rationals, with the ray that
 * proves an unbounded one. */

#include "geom/geom.h"
#include "geom/guard.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

static CGAL::Gmpq rational(const fmpq *value) {
  mpq_t copy;
  mpq_init(copy);
  fmpq_get_mpq(copy, value);
  CGAL::Gmpq result(copy);
  mpq_clear(copy);
  return result;
}

using Program = CGAL::Quadratic_program<CGAL::Gmpq>;

static Program program_of(const tp_geom_program &given) {
  const int t = static_cast<int>(given.count);
  Program program(CGAL::EQUAL, true, 0, false, 0);
  for (int row = 0; row < 3; row++) {
    for (int k = 0; k < t; k++) program.set_a(k, row, rational(given.columns + 3 * k + row));
    program.set_a(t, row, rational(given.direction + row));
    program.set_b(row, rational(given.target + row));
  }
  for (int k = 0; k < t && given.most != nullptr; k++) {
    if (given.most[k] != nullptr) program.set_u(k, true, rational(given.most[k]));
  }
  program.set_l(t, false);
  program.set_c(t, -1);
  return program;
}

/* The columns that grow with t without end; of a simplex method's ray at most three. */
static void take_ray(tp_geom_maximum &maximum,
                     const CGAL::Quadratic_program_solution<CGAL::Gmpq> &of,
                     const tp_geom_program &given) {
  const auto ray = of.unboundedness_certificate_begin();
  for (long k = 0; k < static_cast<long>(given.count) && maximum.basis_count < 3; k++) {
    if (*(ray + k) != CGAL::Gmpq(0)) maximum.basis[maximum.basis_count++] = k;
  }
}

tp_geom_status tp_geom_maximise(tp_geom_maximum *maximum, const tp_geom_program *given) {
  return tp::guard([&] {
    const Program program = program_of(*given);
    const auto solution = CGAL::solve_linear_program(program, CGAL::Gmpq());
    maximum->outcome = solution.is_optimal()     ? TP_GEOM_OPTIMAL
                       : solution.is_unbounded() ? TP_GEOM_UNBOUNDED
                                                 : TP_GEOM_INFEASIBLE;
    maximum->basis_count = 0;
    if (solution.is_unbounded()) take_ray(*maximum, solution, *given);
    if (!solution.is_optimal()) return TP_GEOM_OK;
    for (auto at = solution.basic_variable_indices_begin();
         at != solution.basic_variable_indices_end(); ++at) {
      const long index = *at;
      if (index < static_cast<long>(given->count) && maximum->basis_count < 3) {
        maximum->basis[maximum->basis_count++] = index;
      }
    }
    const auto value = -solution.objective_value();
    const CGAL::Gmpq t(value.numerator() / value.denominator());
    fmpq_set_mpq(maximum->value, t.mpq());
    return TP_GEOM_OK;
  });
}
