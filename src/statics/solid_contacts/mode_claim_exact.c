/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In rational numbers. Each number here is a function of the true load w of the target,
 *
 *     q(w) = q0 w_0 + q1 w_1 + q2 w_2 + q3,
 *
 * four columns; w is within its errors. A basic force w2 - w1 has its direction without error only
 * where one of its components alone is not zero: that direction is taken. */

#include "solid_contacts/mode_claim.h"

#include <flint/fmpq_mat.h>

enum { COLUMNS = 4, PRICE = 3 };

typedef struct exact_proof {
  const tp_mode_claim *claim;
  fmpq_mat_t turning; /* C */
  fmpq_mat_t y;       /* by columns */
} exact_proof;

/* ---- vectors -----------------------------------------------------------------------------------
 */

/* A row or a force, which are exact, as a column. */
static void set_column(fmpq_mat_t matrix, long column, const tp_mode_vector *v) {
  for (int k = 0; k < TP_WRENCH; k++) {
    arf_get_fmpq(fmpq_mat_entry(matrix, k, column), arb_midref(v->at + k));
  }
}

/* Of a unit force at the centroid g along an axis: (e, g x e). */
static void set_unit(fmpq_mat_t matrix, long column, const tp_mode_cones *m, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  fmpq_one(fmpq_mat_entry(matrix, axis, column));
  fmpq_set(fmpq_mat_entry(matrix, 3 + i, column), m->exact_centroid + j);
  fmpq_neg(fmpq_mat_entry(matrix, 3 + j, column), m->exact_centroid + i);
}

/* Along which axis is w2 - w1 alone? Below zero: along more than one. */
static int axis_of_change(const tp_mode_cones *m) {
  int axis = -1, count = 0;
  for (int k = 0; k < 3; k++) {
    if (fmpq_is_zero(m->exact_loads[2] + k) && fmpq_is_zero(m->load_errors[2] + k)) continue;
    axis = k;
    count++;
  }
  return count == 1 ? axis : -1;
}

/* ---- body --------------------------------------------------------------------------------------
 */

static void set_cross(fmpq_mat_t matrix, const fmpq v[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpq_neg(fmpq_mat_entry(matrix, i, j), v + k);
    fmpq_set(fmpq_mat_entry(matrix, j, i), v + k);
  }
}

/* With G the matrix of g x: moments T - G F, turns J^-1 of them, velocities F + G of those. */
static bool set_turning(fmpq_mat_t turning, const tp_mode_cones *m) {
  static const int place[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  fmpq_mat_t inertia, arm, arms, part;
  fmpq_mat_init(inertia, 3, 3);
  fmpq_mat_init(arm, 3, 3);
  fmpq_mat_init(arms, 3, 3);
  fmpq_mat_init(part, 3, 3);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      fmpq_neg(fmpq_mat_entry(inertia, i, j), m->exact_inertia + place[i][j]);
    }
    fmpq_add(fmpq_mat_entry(inertia, i, i), m->exact_inertia + (i + 1) % 3,
             m->exact_inertia + (i + 2) % 3);
  }
  set_cross(arm, m->exact_centroid);
  const bool is_regular = fmpq_mat_inv(inertia, inertia) != 0;
  fmpq_mat_mul(part, inertia, arm); /* J^-1 G */
  fmpq_mat_mul(arms, arm, part);    /* G J^-1 G */
  for (int i = 0; i < 3 && is_regular; i++) {
    for (int j = 0; j < 3; j++) {
      fmpq_neg(fmpq_mat_entry(turning, i, j), fmpq_mat_entry(arms, i, j));
      fmpq_neg(fmpq_mat_entry(turning, 3 + i, j), fmpq_mat_entry(part, i, j));
      /* (J^-1 G)^T = - G J^-1 */
      fmpq_neg(fmpq_mat_entry(turning, i, 3 + j), fmpq_mat_entry(part, j, i));
      fmpq_set(fmpq_mat_entry(turning, 3 + i, 3 + j), fmpq_mat_entry(inertia, i, j));
    }
    fmpq_add_si(fmpq_mat_entry(turning, i, i), fmpq_mat_entry(turning, i, i), 1);
  }
  fmpq_mat_clear(inertia);
  fmpq_mat_clear(arm);
  fmpq_mat_clear(arms);
  fmpq_mat_clear(part);
  return is_regular;
}

/* ---- signs -------------------------------------------------------------------------------------
 */

/* Are all values of a function not above zero, or not below it where `sign` is 1?*/
static bool is_below(const fmpq *const q[COLUMNS], const fmpq load[3], const fmpq error[3],
                     int sign) {
  fmpq_t value, part;
  fmpq_init(value);
  fmpq_init(part);
  fmpq_set(value, q[PRICE]);
  for (int k = 0; k < 3; k++) fmpq_addmul(value, q[k], load + k);
  if (sign > 0) fmpq_neg(value, value);
  for (int k = 0; k < 3; k++) {
    fmpq_abs(part, q[k]);
    fmpq_addmul(value, part, error + k);
  }
  const bool is = fmpq_sgn(value) <= 0;
  fmpq_clear(value);
  fmpq_clear(part);
  return is;
}

static bool is_sign(const exact_proof *f, const fmpq_mat_t functions, long row, int sign) {
  const tp_mode_claim *c = f->claim;
  const fmpq *q[COLUMNS];
  for (int k = 0; k < COLUMNS; k++) q[k] = fmpq_mat_entry(functions, row, k);
  return is_below(q, c->modes->exact_loads[c->target], c->modes->load_errors[c->target], sign);
}

/* y . w2 for the load w2 of w: sum of w_i P_ij w2_j + sum of p_j w2_j, P_ij the product of y's
 * column i with a unit force along j. Where w2 is w, P_ij and P_ji count together. */
static bool resists_load(const exact_proof *f, int which) {
  const tp_mode_claim *c = f->claim;
  const tp_mode_cones *m = c->modes;
  const fmpq *w = m->exact_loads[c->target], *error = m->load_errors[c->target];
  const fmpq *w2 = m->exact_loads[which], *error2 = m->load_errors[which];
  fmpq_mat_t units, turned, products;
  fmpq_t value, part, other;
  fmpq_mat_init(units, TP_WRENCH, 3);
  fmpq_mat_init(turned, 3, TP_WRENCH);
  fmpq_mat_init(products, 3, COLUMNS);
  fmpq_init(value);
  fmpq_init(part);
  fmpq_init(other);
  for (int k = 0; k < 3; k++) set_unit(units, k, m, k);
  fmpq_mat_transpose(turned, units);
  fmpq_mat_mul(products, turned, f->y);
  if (which == c->target) { /* symmetric */
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < i; j++) {
        fmpq *one = fmpq_mat_entry(products, i, j), *two = fmpq_mat_entry(products, j, i);
        fmpq_add(one, one, two);
        fmpq_zero(two);
      }
    }
  }
  for (int j = 0; j < 3; j++) {
    const fmpq *price = fmpq_mat_entry(products, j, PRICE);
    fmpq_addmul(value, price, w2 + j);
    fmpq_abs(part, price);
    fmpq_addmul(value, part, error2 + j);
    for (int i = 0; i < 3; i++) {
      const fmpq *own = fmpq_mat_entry(products, j, i);
      fmpq_mul(part, w + i, w2 + j);
      fmpq_addmul(value, own, part);
      /* |w_i| e2_j + e_i |w2_j| + e_i e2_j */
      fmpq_abs(other, w2 + j);
      fmpq_add(other, other, error2 + j);
      fmpq_mul(other, other, error + i);
      fmpq_abs(part, w + i);
      fmpq_addmul(other, part, error2 + j);
      fmpq_abs(part, own);
      fmpq_addmul(value, part, other);
    }
  }
  const bool is = fmpq_sgn(value) <= 0;
  fmpq_mat_clear(units);
  fmpq_mat_clear(turned);
  fmpq_mat_clear(products);
  fmpq_clear(value);
  fmpq_clear(part);
  fmpq_clear(other);
  return is;
}

/* ---- the proof ---------------------------------------------------------------------------------
 */

/* Of the functions z, by rows, those of the wrench w + sum of z rows, turned into y. */
static void set_y(exact_proof *f, const fmpq_mat_t start, const fmpq_mat_t rows,
                  const fmpq_mat_t z) {
  fmpq_mat_t sum;
  fmpq_mat_init(sum, TP_WRENCH, COLUMNS);
  fmpq_mat_set(sum, start);
  if (f->claim->unknown_count > 0) {
    fmpq_mat_mul(sum, rows, z);
    fmpq_mat_add(sum, sum, start);
  }
  fmpq_mat_mul(f->y, f->turning, sum);
  fmpq_mat_clear(sum);
}

/* w by its unit forces, and the rows that have a price. */
static void set_start(fmpq_mat_t start, const tp_mode_claim *c) {
  fmpq_mat_t row;
  fmpq_mat_init(row, TP_WRENCH, 1);
  for (int k = 0; k < 3; k++) set_unit(start, k, c->modes, k);
  for (long r = 0; r < c->priced_count; r++) {
    set_column(row, 0, c->priced[r].vector);
    for (int k = 0; k < TP_WRENCH; k++) {
      fmpq *entry = fmpq_mat_entry(start, k, PRICE), *own = fmpq_mat_entry(row, k, 0);
      fmpq_mul_2exp(own, own, (ulong)c->price_bits);
      if (c->priced[r].sign < 0) fmpq_neg(own, own);
      fmpq_add(entry, entry, own);
    }
  }
  fmpq_mat_clear(row);
}

static bool resists_forces(const exact_proof *f) {
  const tp_mode_claim *c = f->claim;
  fmpq_mat_t forces, products;
  fmpq_mat_init(forces, TP_WRENCH, c->force_count);
  fmpq_mat_init(products, c->force_count, COLUMNS);
  for (long g = 0; g < c->force_count; g++) set_column(forces, g, c->forces[g]);
  fmpq_mat_t turned;
  fmpq_mat_init(turned, c->force_count, TP_WRENCH);
  fmpq_mat_transpose(turned, forces);
  fmpq_mat_mul(products, turned, f->y);
  bool resists = true;
  for (long g = 0; g < c->force_count && resists; g++) {
    resists = tp_mode_claim_has_basic(c, c->forces[g]) || is_sign(f, products, g, -1);
  }
  fmpq_mat_clear(forces);
  fmpq_mat_clear(products);
  fmpq_mat_clear(turned);
  return resists;
}

/* z by y . f = 0. */
static bool solve(fmpq_mat_t z, const exact_proof *f, const fmpq_mat_t start, const fmpq_mat_t rows,
                  int axis) {
  const tp_mode_claim *c = f->claim;
  const long count = c->unknown_count;
  if (count == 0) return true;
  fmpq_mat_t basic, turned, left, right;
  fmpq_mat_init(basic, TP_WRENCH, count);
  fmpq_mat_init(turned, count, TP_WRENCH);
  fmpq_mat_init(left, count, count);
  fmpq_mat_init(right, count, COLUMNS);
  for (long k = 0; k < count; k++) {
    if (c->basic[k] == c->change) {
      set_unit(basic, k, c->modes, axis);
    } else {
      set_column(basic, k, c->basic[k]);
    }
  }
  fmpq_mat_transpose(turned, basic);
  fmpq_mat_mul(turned, turned, f->turning);
  fmpq_mat_mul(left, turned, rows);
  fmpq_mat_mul(right, turned, start);
  fmpq_mat_neg(right, right);
  bool solved = fmpq_mat_solve(z, left, right) != 0;
  for (long k = 0; k < count && solved; k++) {
    solved = c->unknown[k].sign == 0 || is_sign(f, z, k, c->unknown[k].sign);
  }
  fmpq_mat_clear(basic);
  fmpq_mat_clear(turned);
  fmpq_mat_clear(left);
  fmpq_mat_clear(right);
  return solved;
}

bool tp_mode_claim_holds_exactly(const tp_mode_claim *c) {
  const int axis = c->change != NULL ? axis_of_change(c->modes) : 0;
  if (axis < 0) return false;
  exact_proof f = {.claim = c};
  fmpq_mat_t start, rows, z;
  fmpq_mat_init(f.turning, TP_WRENCH, TP_WRENCH);
  fmpq_mat_init(f.y, TP_WRENCH, COLUMNS);
  fmpq_mat_init(start, TP_WRENCH, COLUMNS);
  fmpq_mat_init(rows, TP_WRENCH, c->unknown_count);
  fmpq_mat_init(z, c->unknown_count, COLUMNS);
  for (long k = 0; k < c->unknown_count; k++) set_column(rows, k, c->unknown[k].vector);
  set_start(start, c);
  bool holds = set_turning(f.turning, c->modes) && solve(z, &f, start, rows, axis);
  if (holds && c->basic_count < TP_WRENCH) {
    set_y(&f, start, rows, z);
    /* with y . (w2 - w1) = 0 one of them is enough */
    holds = resists_load(&f, c->target) && (c->change != NULL || resists_load(&f, 1 - c->target)) &&
            resists_forces(&f);
  }
  fmpq_mat_clear(f.turning);
  fmpq_mat_clear(f.y);
  fmpq_mat_clear(start);
  fmpq_mat_clear(rows);
  fmpq_mat_clear(z);
  return holds;
}
