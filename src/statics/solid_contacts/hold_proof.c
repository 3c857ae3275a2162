/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mixes, equilibrium in rational numbers, and cones by doubles with bounds. */

#include "solid_contacts/hold_proof.h"

#include <flint/fmpq_mat.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_SHARE = 44, LAST_SHARE = 16, SHARE_STEP = 4 };

/* ---- the basis ---------------------------------------------------------------------------------
 */

static void component(double column[TP_WRENCH], const tp_friction_cone *cone, int axis) {
  double force[3] = {0};
  if (axis >= 0) force[axis] = 1;
  tp_friction_cone_column(column, cone, axis >= 0 ? force : cone->unit);
}

static double product(const double a[TP_WRENCH], const double b[TP_WRENCH]) {
  double sum = 0;
  for (int r = 0; r < TP_WRENCH; r++) sum += a[r] * b[r];
  return sum;
}

/* The part of a column across those that are taken, twice for its digits; its length. */
static double part_across(double column[TP_WRENCH], const double (*taken)[TP_WRENCH], int count) {
  for (int again = 0; again < 2; again++) {
    for (int k = 0; k < count; k++) {
      const double along = product(column, taken[k]);
      for (int r = 0; r < TP_WRENCH; r++) column[r] -= along * taken[k][r];
    }
  }
  return sqrt(product(column, column));
}

/* Always the one that is farthest across those taken. */
static bool choose_next(tp_hold_basis *basis, double (*taken)[TP_WRENCH],
                        const tp_friction_cones *cones) {
  static const double least = 1e-9;
  double most = least;
  for (long n = 0; n < cones->count; n++) {
    const bool rough = !tp_near_is_zero(cones->cones[n].friction);
    for (int axis = rough ? 0 : -1; axis < (rough ? 3 : 0); axis++) {
      double own[TP_WRENCH];
      component(own, cones->cones + n, axis);
      const double length = part_across(own, taken, basis->count);
      if (!(length > 1.0001 * most)) continue;
      most = length;
      basis->cones[basis->count] = n;
      basis->axes[basis->count] = axis;
      for (int r = 0; r < TP_WRENCH; r++) taken[basis->count][r] = own[r] / length;
    }
  }
  return most > least;
}

void tp_hold_basis_choose(tp_hold_basis *basis, const tp_friction_cones *cones) {
  double taken[TP_WRENCH][TP_WRENCH];
  *basis = (tp_hold_basis){.count = 0};
  while (basis->count < TP_WRENCH && choose_next(basis, taken, cones)) basis->count++;
}

/* ---- forces ------------------------------------------------------------------------------------
 */

/* All forces, exactly: three components each; of a cone without friction a share of its normal. */
typedef struct balance {
  const tp_friction_cones *cones;
  fmpq *forces;
  fmpq_mat_t rows;  /* of the basis, and what is missing */
  fmpq_mat_t given; /* the same before elimination */
  fmpq_t own;
} balance;

static bool balance_init(balance *b, const tp_friction_cones *cones) {
  *b = (balance){.cones = cones, .forces = calloc(3 * (size_t)cones->count + 1, sizeof(fmpq))};
  if (b->forces == NULL) return false;
  for (long k = 0; k < 3 * cones->count; k++) fmpq_init(b->forces + k);
  fmpq_mat_init(b->rows, TP_WRENCH, TP_WRENCH + 1);
  fmpq_mat_init(b->given, TP_WRENCH, TP_WRENCH + 1);
  fmpq_init(b->own);
  return true;
}

static void balance_clear(balance *b) {
  for (long k = 0; k < 3 * b->cones->count; k++) fmpq_clear(b->forces + k);
  free(b->forces);
  fmpq_mat_clear(b->rows);
  fmpq_mat_clear(b->given);
  fmpq_clear(b->own);
}

static void set_force(balance *b, long n, const double force[3]) {
  const tp_friction_cone *cone = b->cones->cones + n;
  if (!tp_near_is_zero(cone->friction)) {
    for (int k = 0; k < 3; k++) tp_hold_double(b->forces + 3 * n + k, force[k]);
    return;
  }
  double along = 0, length = 0;
  for (int k = 0; k < 3; k++) {
    const double own = fmpq_get_d(cone->normal + k);
    along += force[k] * cone->unit[k];
    length = hypot(length, own);
  }
  tp_hold_double(b->own, along / length);
  for (int k = 0; k < 3; k++) fmpq_mul(b->forces + 3 * n + k, cone->normal + k, b->own);
}

/* A column of a force, exactly, added to the rows at `at`, or subtracted. */
static void add_column(balance *b, long at, const tp_friction_cone *cone, const fmpq force[3],
                       bool subtract) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpq *row = fmpq_mat_entry(b->rows, k, at), *moment = fmpq_mat_entry(b->rows, 3 + k, at);
    void (*const plus)(fmpq_t, const fmpq_t, const fmpq_t) = subtract ? fmpq_submul : fmpq_addmul;
    void (*const minus)(fmpq_t, const fmpq_t, const fmpq_t) = subtract ? fmpq_addmul : fmpq_submul;
    if (subtract) {
      fmpq_sub(row, row, force + k);
    } else {
      fmpq_add(row, row, force + k);
    }
    plus(moment, cone->at + i, force + j);
    minus(moment, cone->at + j, force + i);
  }
}

static void set_basis_column(balance *b, const tp_hold_basis *basis, int k) {
  const tp_friction_cone *cone = b->cones->cones + basis->cones[k];
  fmpq force[3];
  for (int i = 0; i < 3; i++) {
    fmpq_init(force + i);
    if (basis->axes[k] < 0) {
      fmpq_set(force + i, cone->normal + i);
    } else {
      fmpq_set_si(force + i, i == basis->axes[k], 1);
    }
  }
  add_column(b, k, cone, force, false);
  for (int i = 0; i < 3; i++) fmpq_clear(force + i);
}

/* What is missing to equilibrium, into the column after those of the basis. */
static void set_missing(balance *b, const tp_hold_basis *basis, const tp_hold_load *load,
                        const tp_hold_load *way, double t) {
  fmpq_mat_zero(b->rows);
  for (int k = 0; k < basis->count; k++) set_basis_column(b, basis, k);
  tp_hold_double(b->own, t);
  for (int k = 0; k < 3; k++) {
    fmpq *row = fmpq_mat_entry(b->rows, k, basis->count);
    fmpq_neg(row, load->exact + k);
    if (way != NULL) fmpq_submul(row, way->exact + k, b->own);
  }
  for (long n = 0; n < b->cones->count; n++) {
    add_column(b, basis->count, b->cones->cones + n, b->forces + 3 * n, true);
  }
}

/* Do the numbers that elimination left in the last column satisfy the rows as they were given? */
static bool is_solution(balance *b, int count) {
  bool is = true;
  for (int r = 0; r < TP_WRENCH && is; r++) {
    fmpq_neg(b->own, fmpq_mat_entry(b->given, r, count));
    for (int k = 0; k < count; k++) {
      fmpq_addmul(b->own, fmpq_mat_entry(b->given, r, k), fmpq_mat_entry(b->rows, k, count));
    }
    is = fmpq_is_zero(b->own) != 0;
  }
  return is;
}

/* By elimination, and verified; false: the rows have no solution. */
static bool solve_missing(balance *b, const tp_hold_basis *basis) {
  fmpq_mat_set(b->given, b->rows);
  const slong rank = fmpq_mat_rref(b->rows, b->rows);
  if (rank != basis->count || !is_solution(b, basis->count)) return false;
  for (int k = 0; k < basis->count; k++) {
    const fmpq *own = fmpq_mat_entry(b->rows, k, basis->count);
    const tp_friction_cone *cone = b->cones->cones + basis->cones[k];
    fmpq *force = b->forces + 3 * basis->cones[k];
    if (!fmpq_is_one(fmpq_mat_entry(b->rows, k, k))) return false;
    for (int i = 0; i < 3; i++) {
      if (basis->axes[k] < 0) fmpq_addmul(force + i, cone->normal + i, own);
      if (basis->axes[k] == i) fmpq_add(force + i, force + i, own);
    }
  }
  return true;
}

/* Without friction a force is a share of the normal exactly: which must not be below zero. */
static bool pushes(const tp_friction_cone *cone, const fmpq force[3]) {
  for (int k = 0; k < 3; k++) {
    if (fmpq_sgn(cone->normal + k) * fmpq_sgn(force + k) < 0) return false;
  }
  return true;
}

static bool is_within_cones(const balance *b, tp_near share) {
  for (long n = 0; n < b->cones->count; n++) {
    const fmpq *force = b->forces + 3 * n;
    const tp_friction_cone *cone = b->cones->cones + n;
    tp_near own[3];
    for (int k = 0; k < 3; k++) {
      const double value = fmpq_get_d(force + k);
      own[k] =
          fmpq_is_zero(force + k) ? (tp_near){0, 0} : tp_near_of(value, fabs(value) * DBL_EPSILON);
    }
    const bool none = fmpq_is_zero(force) && fmpq_is_zero(force + 1) && fmpq_is_zero(force + 2);
    const bool holds = tp_near_is_zero(cone->friction) ? pushes(cone, force)
                                                       : tp_friction_cone_holds(cone, own, share);
    if (!none && !holds) return false;
  }
  return true;
}

static bool try_mix(balance *b, double *t, const tp_held *found, const tp_held *deep, double part,
                    const tp_hold_basis *basis, tp_near share, const tp_hold_load *load,
                    const tp_hold_load *way) {
  *t = (1 - part) * found->t + part * deep->t;
  for (long n = 0; n < b->cones->count; n++) {
    double own[3];
    for (int k = 0; k < 3; k++) {
      own[k] = (1 - part) * found->forces[n][k] + part * deep->forces[n][k];
    }
    set_force(b, n, own);
  }
  set_missing(b, basis, load, way, *t);
  return solve_missing(b, basis) && is_within_cones(b, share);
}

bool tp_hold_prove_forces(bool *proven, tp_held *found, const tp_held *deep,
                          const tp_friction_cones *cones, const tp_hold_basis *basis, tp_near share,
                          const tp_hold_load *load, const tp_hold_load *way) {
  balance b;
  double t = found->t;
  *proven = false;
  if (!balance_init(&b, cones)) return false;
  for (int own = FIRST_SHARE; own >= LAST_SHARE && !*proven; own -= SHARE_STEP) {
    *proven = try_mix(&b, &t, found, deep, ldexp(1, -own), basis, share, load, way);
  }
  if (*proven) {
    found->t = t;
    for (long k = 0; k < 3 * cones->count; k++) {
      found->forces[k / 3][k % 3] = fmpq_get_d(b.forces + k);
    }
  }
  balance_clear(&b);
  return true;
}

/* ---- motions -----------------------------------------------------------------------------------
 */

static bool lets_all(const tp_friction_cones *cones, const double twist[TP_WRENCH], tp_near share) {
  for (long n = 0; n < cones->count; n++) {
    if (!tp_friction_cone_lets(cones->cones + n, twist, share)) return false;
  }
  return true;
}

bool tp_hold_prove_motion(double twist[TP_WRENCH], const double apart[TP_WRENCH],
                          const tp_friction_cones *cones, tp_near share) {
  double size = 0, other = 0;
  for (int r = 0; r < TP_WRENCH; r++) {
    size = fmax(size, fabs(twist[r]));
    other = fmax(other, fabs(apart[r]));
  }
  if (!(size > 0 && other > 0)) return false;
  for (int own = FIRST_SHARE; own >= LAST_SHARE; own -= SHARE_STEP) {
    double mixed[TP_WRENCH];
    for (int r = 0; r < TP_WRENCH; r++) {
      mixed[r] = twist[r] + ldexp(size / other, -own) * apart[r];
    }
    if (!lets_all(cones, mixed, share)) continue;
    memcpy(twist, mixed, sizeof mixed);
    return true;
  }
  return false;
}
