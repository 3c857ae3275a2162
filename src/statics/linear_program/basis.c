/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Basis of the linear program as the simplex method in doubles leaves it, or of the exact program
 * over rationals (geom/geom.h), set up at the midpoints of the balls. */

#include "linear_program/basis.h"

#include "geom/geom.h"

#include <arb_fmpz_poly.h>
#include <flint/fmpq_vec.h>
#include <math.h>
#include <stdlib.h>

tp_basis tp_basis_of(const tp_simplex_answer *answer) {
  tp_basis basis = {.outcome = answer->outcome, .columns = {-1, -1, -1}};
  for (int r = 0; r < 3; r++) {
    if (answer->basis[r] >= 0) basis.columns[basis.count++] = answer->basis[r];
  }
  return basis;
}

static bool set_middle(fmpq *entry, const arb_t of) {
  const bool finite = arf_is_finite(arb_midref(of)) != 0;
  if (finite) arf_get_fmpq(entry, arb_midref(of));
  return finite;
}

static bool set_middles(fmpq *entries, const tp_vector *of) {
  bool finite = true;
  for (int row = 0; row < 3 && finite; row++) finite = set_middle(entries + row, of->of + row);
  return finite;
}

/* The program in rationals. */
typedef struct exact_program {
  long count;
  fmpq *entries, *bounds; /* three entries and a bound a column */
  const fmpq **most;      /* the bounds of those that have one */
  fmpq ends[6];           /* direction, target */
} exact_program;

static bool exact_init(exact_program *p, long count) {
  p->count = count;
  p->most = calloc((size_t)count + 1, sizeof *p->most);
  if (p->most == NULL) return false;
  p->entries = _fmpq_vec_init(3 * count);
  p->bounds = _fmpq_vec_init(count);
  for (int k = 0; k < 6; k++) fmpq_init(p->ends + k);
  return true;
}

static void exact_clear(exact_program *p) {
  _fmpq_vec_clear(p->entries, 3 * p->count);
  _fmpq_vec_clear(p->bounds, p->count);
  for (int k = 0; k < 6; k++) fmpq_clear(p->ends + k);
  free(p->most);
}

/* False where a column is not finite. */
static bool exact_fill(exact_program *p, const tp_cones *cones, const long *columns, long bits) {
  tp_vector entries;
  tp_vector_init(&entries);
  bool finite = true;
  for (long k = 0; k < p->count && finite; k++) {
    tp_cones_column(entries.of, cones, columns[k], bits);
    finite = set_middles(p->entries + 3 * k, &entries);
    if (tp_cones_is_edge(cones, columns[k])) continue;
    tp_cones_bound(entries.of, cones, columns[k]);
    finite = finite && set_middle(p->bounds + k, entries.of);
    p->most[k] = p->bounds + k;
  }
  tp_vector_clear(&entries);
  return finite;
}

static tp_geom_status exact_solve(tp_basis *basis, exact_program *p, const long *columns) {
  fmpq_t value;
  fmpq_init(value);
  const tp_geom_program program = {(size_t)p->count, p->entries, p->ends, p->ends + 3, p->most};
  tp_geom_maximum maximum = {.value = value};
  const tp_geom_status done = tp_geom_maximise(&maximum, &program);
  *basis = (tp_basis){.outcome = maximum.outcome == TP_GEOM_OPTIMAL     ? TP_SIMPLEX_OPTIMAL
                                 : maximum.outcome == TP_GEOM_UNBOUNDED ? TP_SIMPLEX_UNBOUNDED
                                                                        : TP_SIMPLEX_INFEASIBLE,
                      .count = maximum.basis_count,
                      .columns = {-1, -1, -1}};
  for (int k = 0; k < maximum.basis_count; k++) basis->columns[k] = columns[maximum.basis[k]];
  fmpq_clear(value);
  return done;
}

tp_status tp_basis_exact(tp_basis *basis, const tp_cones *cones, const long *columns, long count,
                         const tp_vector *direction, const tp_vector *target, long bits) {
  exact_program p;
  if (!exact_init(&p, count)) return TP_OUT_OF_MEMORY;
  const bool finite = exact_fill(&p, cones, columns, bits) && set_middles(p.ends, direction) &&
                      set_middles(p.ends + 3, target);
  *basis = (tp_basis){.outcome = TP_SIMPLEX_STUCK, .columns = {-1, -1, -1}};
  const tp_geom_status done = finite ? exact_solve(basis, &p, columns) : TP_GEOM_OK;
  exact_clear(&p);
  if (done == TP_GEOM_OUT_OF_MEMORY) return TP_OUT_OF_MEMORY;
  return done == TP_GEOM_OK ? TP_OK : TP_DEPENDENCY_FAILED;
}

/* The columns as generators of what can still be borne. */
typedef struct generating {
  const tp_scaled *scaled;
  long full; /* a column at its bound, besides those of the scaled program, or -1 */
} generating;

/* What a column at its bound can do is to bear less; with a bound of zero it can do nothing. */
static bool set_column(double column[3], const generating *g, long k) {
  const tp_scaled *scaled = g->scaled;
  if (scaled->most != NULL && scaled->most[k] == 0) return false;
  const bool turned = k == g->full || (scaled->at_most != NULL && scaled->at_most[k]);
  for (int row = 0; row < 3; row++)
    column[row] = turned ? -scaled->columns[k][row] : scaled->columns[k][row];
  return true;
}

/* Wrapping about the shared edge: with n = s (shared x other) pointing into the cone, the other
 * face's column k has -s (shared x k) pointing into it. */
long tp_basis_across(const tp_scaled *scaled, long shared, long other, bool full) {
  static const double rounding = 1e-12; /* of determinants of doubles of size 1, with room */
  const generating g = {scaled, full ? other : -1};
  const double *edge = scaled->columns[shared];
  double column[3], normal[3], inward = 0;
  if (!set_column(column, &g, other)) return -1;
  tp_double_cross(normal, edge, column);
  for (long k = 0; k < scaled->count; k++) {
    if (!set_column(column, &g, k)) continue;
    const double side = tp_double_dot(normal, column);
    if (fabs(side) > fabs(inward)) inward = side;
  }
  const double turn = inward < 0 ? 1 : -1;
  long found = -1;
  for (long k = 0; k < scaled->count; k++) {
    double own[3];
    if (!set_column(column, &g, k)) continue;
    tp_double_cross(own, edge, column);
    if (fabs(own[0]) + fabs(own[1]) + fabs(own[2]) < rounding) continue; /* the edge itself */
    if (found < 0 || turn * tp_double_dot(normal, column) < -rounding) {
      found = k;
      for (int row = 0; row < 3; row++) normal[row] = own[row];
    }
  }
  return found;
}
