/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The equations of all squeezed points are rows over twists. Motions that satisfy them are
 * combinations of the vectors that elimination leaves free; each is verified in the rows as they
 * were given, and a determinant shows that no others are left. Rays of the cone in up to three of
 * these vectors are across one or two of the rows n . a >= 0. */

#include "solid_contacts/squeezed.h"

#include "solid_contacts/solid_section_parts.h"

#include <flint/fmpq_mat.h>
#include <math.h>
#include <stdlib.h>

enum { MOST_FREE = 3, MOST_CONTACTS = 32 };

typedef enum squeeze {
  SQUEEZE_NONE,
  SQUEEZE_FAST,  /* the point does not move */
  SQUEEZE_AWAY,  /* along m alone */
  SQUEEZE_ACROSS /* across the normal */
} squeeze;

typedef struct squeezed {
  const tp_friction_cones *cones;
  fmpq_mat_t rows; /* over twists; how many are in use: */
  long count;
  bool any;
  int free_count;
  fmpq free[MOST_FREE][TP_WRENCH]; /* the twists that all rows leave */
  long sign_count;                 /* rows that must not be below zero, over these: */
  fmpq signs[MOST_CONTACTS][MOST_FREE];
} squeezed;

/* ---- one contact -------------------------------------------------------------------------------
 */

/* How does a force squeeze a contact? Above zero: within its cone; zero: on its edge. */
static int place_in_cone(const tp_friction_cone *cone, const fmpq force[3]) {
  fmpq_t along, square, part;
  fmpq_init(along);
  fmpq_init(square);
  fmpq_init(part);
  tp_rational3_dot(along, cone->normal, force);
  const bool pushes = fmpq_sgn(along) > 0;
  tp_rational3_dot(square, force, force);
  tp_rational3_dot(part, cone->normal, cone->normal);
  fmpq_mul(square, square, part);
  tp_hold_double(part, cone->friction.value);
  fmpq_mul(part, part, part);
  fmpq_add_si(part, part, 1);
  fmpq_mul(along, along, along);
  fmpq_mul(along, along, part);
  fmpq_sub(along, along, square);
  const int place = pushes ? fmpq_sgn(along) : -1;
  fmpq_clear(along);
  fmpq_clear(square);
  fmpq_clear(part);
  return place;
}

static squeeze squeeze_of(const tp_friction_cone *cone, const fmpq force[3]) {
  const int place = place_in_cone(cone, force);
  return place < 0                         ? SQUEEZE_NONE
         : tp_near_is_zero(cone->friction) ? SQUEEZE_ACROSS
         : place > 0                       ? SQUEEZE_FAST
                                           : SQUEEZE_AWAY;
}

/* The row (d, r x d) of the motion of the point along d, times a twist. */
static void set_row(fmpq row[TP_WRENCH], const tp_friction_cone *cone, const fmpq along[3]) {
  for (int k = 0; k < 3; k++) fmpq_set(row + k, along + k);
  tp_rational3_cross(row + 3, cone->at, along);
}

static void add_row(squeezed *s, const tp_friction_cone *cone, const fmpq along[3]) {
  fmpq row[TP_WRENCH];
  for (int k = 0; k < TP_WRENCH; k++) fmpq_init(row + k);
  set_row(row, cone, along);
  for (int k = 0; k < TP_WRENCH; k++) fmpq_set(fmpq_mat_entry(s->rows, s->count, k), row + k);
  s->count++;
  for (int k = 0; k < TP_WRENCH; k++) fmpq_clear(row + k);
}

/* Along m, or nowhere where m is zero: across three axes. */
static void add_across(squeezed *s, const tp_friction_cone *cone, const fmpq m[3]) {
  for (int k = 0; k < 3; k++) {
    fmpq axis[3], along[3];
    tp_rational3_init(axis);
    tp_rational3_init(along);
    fmpq_one(axis + k);
    tp_rational3_cross(along, m, axis);
    add_row(s, cone, tp_rational3_is_zero(m) ? axis : along);
    tp_rational3_clear(axis);
    tp_rational3_clear(along);
  }
}

static void take_force(squeezed *s, const tp_friction_cone *cone, const fmpq force[3]) {
  fmpq m[3];
  fmpq_t square, along;
  tp_rational3_init(m);
  fmpq_init(square);
  fmpq_init(along);
  switch (squeeze_of(cone, force)) {
  case SQUEEZE_ACROSS:
    add_row(s, cone, cone->normal);
    break;
  case SQUEEZE_AWAY:
    tp_rational3_dot(square, force, force);
    tp_rational3_dot(along, cone->normal, force);
    for (int k = 0; k < 3; k++) {
      fmpq_mul(m + k, square, cone->normal + k);
      fmpq_submul(m + k, along, force + k);
    }
    add_across(s, cone, m);
    break;
  default:
    add_across(s, cone, m);
    break;
  }
  tp_rational3_clear(m);
  fmpq_clear(square);
  fmpq_clear(along);
}

/* ---- pairs -------------------------------------------------------------------------------------
 */

/* A force on the first contact and its opposite on the second, where both are in their cones. */
static void take_opposite(squeezed *s, const tp_friction_cone *a, const tp_friction_cone *b,
                          const fmpq force[3]) {
  fmpq against[3];
  tp_rational3_init(against);
  for (int k = 0; k < 3; k++) fmpq_neg(against + k, force + k);
  if (squeeze_of(a, force) != SQUEEZE_NONE && squeeze_of(b, against) != SQUEEZE_NONE) {
    take_force(s, a, force);
    take_force(s, b, against);
    s->any = true;
  }
  tp_rational3_clear(against);
}

/* The root of a number, rounded where it has none that is rational. */
static void set_root(fmpq_t root, const fmpq_t square) {
  if (fmpz_is_square(fmpq_numref(square)) && fmpz_is_square(fmpq_denref(square))) {
    fmpz_sqrt(fmpq_numref(root), fmpq_numref(square));
    fmpz_sqrt(fmpq_denref(root), fmpq_denref(square));
  } else {
    tp_hold_double(root, sqrt(fmpq_get_d(square)));
  }
}

/* Two contacts in one point, as in the notch of a groove: along the one normal, against the other,
 * and in the middle of both, where cones of equal friction meet first. */
static void take_notch(squeezed *s, const tp_friction_cone *a, const tp_friction_cone *b) {
  fmpq force[3];
  fmpq_t share, part;
  tp_rational3_init(force);
  fmpq_init(share);
  fmpq_init(part);
  tp_rational3_dot(share, a->normal, a->normal);
  tp_rational3_dot(part, b->normal, b->normal);
  fmpq_div(share, share, part);
  set_root(part, share);
  for (int k = 0; k < 3; k++) {
    fmpq_set(force + k, a->normal + k);
    fmpq_submul(force + k, part, b->normal + k);
  }
  take_opposite(s, a, b, force);
  take_opposite(s, a, b, a->normal);
  for (int k = 0; k < 3; k++) fmpq_neg(force + k, b->normal + k);
  take_opposite(s, a, b, force);
  tp_rational3_clear(force);
  fmpq_clear(share);
  fmpq_clear(part);
}

static void take_pair(squeezed *s, const tp_friction_cone *a, const tp_friction_cone *b) {
  fmpq force[3];
  tp_rational3_init(force);
  for (int k = 0; k < 3; k++) fmpq_sub(force + k, b->at + k, a->at + k);
  if (tp_rational3_is_zero(force)) {
    take_notch(s, a, b);
  } else {
    take_opposite(s, a, b, force);
    for (int k = 0; k < 3; k++) fmpq_neg(force + k, force + k);
    take_opposite(s, a, b, force);
  }
  tp_rational3_clear(force);
}

/* ---- motions that are left ---------------------------------------------------------------------
 */

/* Of the rows in their reduced form: one vector for each column without a pivot. */
static bool find_free(squeezed *s) {
  fmpq_mat_t reduced;
  long pivots[TP_WRENCH];
  fmpq_mat_init(reduced, s->count, TP_WRENCH);
  for (long r = 0; r < s->count; r++) {
    for (int k = 0; k < TP_WRENCH; k++) {
      fmpq_set(fmpq_mat_entry(reduced, r, k), fmpq_mat_entry(s->rows, r, k));
    }
  }
  const long rank = fmpq_mat_rref(reduced, reduced);
  s->free_count = 0;
  bool fits = TP_WRENCH - rank <= MOST_FREE;
  for (long r = 0, column = 0; r < rank && fits; r++, column++) {
    while (column < TP_WRENCH && fmpq_is_zero(fmpq_mat_entry(reduced, r, column))) column++;
    pivots[r] = column;
  }
  for (long column = 0; column < TP_WRENCH && fits; column++) {
    bool is_pivot = false;
    for (long r = 0; r < rank; r++) is_pivot = is_pivot || pivots[r] == column;
    if (is_pivot) continue;
    fmpq *own = s->free[s->free_count++];
    fmpq_one(own + column);
    for (long r = 0; r < rank; r++) fmpq_neg(own + pivots[r], fmpq_mat_entry(reduced, r, column));
  }
  fmpq_mat_clear(reduced);
  return fits;
}

static void evaluate(fmpq_t sum, const fmpq *a, const fmpq *b, int count) {
  fmpq_zero(sum);
  for (int k = 0; k < count; k++) fmpq_addmul(sum, a + k, b + k);
}

/* Each free twist satisfies all rows, and no twist across all free ones does. */
static bool is_proven(const squeezed *s) {
  fmpq_t sum;
  fmpq_mat_t all;
  bool proven = true;
  fmpq_init(sum);
  for (int k = 0; k < s->free_count; k++) {
    for (long r = 0; r < s->count && proven; r++) {
      evaluate(sum, fmpq_mat_entry(s->rows, r, 0), s->free[k], TP_WRENCH);
      proven = fmpq_is_zero(sum) != 0;
    }
  }
  /* rows^T rows + free free^T is regular just where no such twist is left */
  fmpq_mat_init(all, TP_WRENCH, TP_WRENCH);
  for (int i = 0; i < TP_WRENCH; i++) {
    for (int j = 0; j < TP_WRENCH; j++) {
      fmpq *entry = fmpq_mat_entry(all, i, j);
      for (long r = 0; r < s->count; r++) {
        fmpq_addmul(entry, fmpq_mat_entry(s->rows, r, i), fmpq_mat_entry(s->rows, r, j));
      }
      for (int k = 0; k < s->free_count; k++) {
        fmpq_addmul(entry, s->free[k] + i, s->free[k] + j);
      }
    }
  }
  fmpq_mat_det(sum, all);
  proven = proven && !fmpq_is_zero(sum);
  fmpq_mat_clear(all);
  fmpq_clear(sum);
  return proven;
}

/* Every contact moves away or not at all: n . a >= 0 over the free twists. */
static void set_signs(squeezed *s) {
  fmpq row[TP_WRENCH];
  for (int k = 0; k < TP_WRENCH; k++) fmpq_init(row + k);
  for (long n = 0; n < s->cones->count; n++) {
    bool any = false;
    set_row(row, s->cones->cones + n, s->cones->cones[n].normal);
    for (int k = 0; k < s->free_count; k++) {
      fmpq *own = s->signs[s->sign_count] + k;
      evaluate(own, row, s->free[k], TP_WRENCH);
      any = any || !fmpq_is_zero(own);
    }
    s->sign_count += any;
  }
  for (int k = 0; k < TP_WRENCH; k++) fmpq_clear(row + k);
}

/* ---- rays --------------------------------------------------------------------------------------
 */

/* Does a motion lie in the dual of a cone of friction: |n| (n . a) >= mu |n x a|? */
static bool is_let(const tp_friction_cone *cone, const fmpq twist[TP_WRENCH]) {
  fmpq motion[3], across[3];
  fmpq_t along, part;
  tp_rational3_init(motion);
  tp_rational3_init(across);
  fmpq_init(along);
  fmpq_init(part);
  tp_rational3_cross(motion, twist + 3, cone->at);
  for (int k = 0; k < 3; k++) fmpq_add(motion + k, motion + k, twist + k);
  tp_rational3_dot(along, cone->normal, motion);
  bool is = fmpq_sgn(along) >= 0;
  /* |n|^2 (n . a)^2 >= mu^2 |n|^2 |n x a|^2 / |n|^2, all times |n|^2 */
  tp_rational3_cross(across, cone->normal, motion);
  tp_rational3_dot(part, across, across);
  tp_hold_double(across, cone->friction.value);
  fmpq_mul(part, part, across);
  fmpq_mul(part, part, across);
  fmpq_mul(along, along, along);
  is = is && fmpq_cmp(along, part) >= 0;
  tp_rational3_clear(motion);
  tp_rational3_clear(across);
  fmpq_clear(along);
  fmpq_clear(part);
  return is;
}

typedef struct answer {
  bool any;     /* a ray was found */
  bool is_open; /* a ray gains on the load itself, or is no motion of all cones */
  bool has_least;
  fmpq_t least, error; /* t, and by how much the true one of its ray may differ as loads may; */
  fmpq_t low;          /* and no less of all rays than this */
  fmpq twist[TP_WRENCH];
} answer;

/* By how much what a twist gains may differ from the true gain. */
static void set_gain_error(fmpq_t error, const fmpq twist[TP_WRENCH], const tp_hold_load *load) {
  fmpq_t part, own;
  fmpq_init(part);
  fmpq_init(own);
  fmpq_zero(error);
  for (int k = 0; k < 3; k++) {
    tp_hold_double(own, load->error[k]);
    fmpq_abs(part, twist + k);
    fmpq_addmul(error, part, own);
  }
  fmpq_clear(part);
  fmpq_clear(own);
}

/* What begins at t: (-w . a) / (way . a), with the errors e and f of the two products and t >= 0
 * within (e + t f) / (way . a - f). */
static void take_limit(answer *a, const fmpq twist[TP_WRENCH], const fmpq_t loss, const fmpq_t gain,
                       const fmpq_t loss_error, const fmpq_t gain_error) {
  fmpq_t t, error, part;
  fmpq_init(t);
  fmpq_init(error);
  fmpq_init(part);
  fmpq_div(t, loss, gain);
  fmpq_mul(error, t, gain_error);
  fmpq_add(error, error, loss_error);
  fmpq_sub(part, gain, gain_error);
  fmpq_div(error, error, part);
  if (!a->has_least || fmpq_cmp(t, a->least) < 0) {
    fmpq_set(a->least, t);
    fmpq_set(a->error, error);
    for (int k = 0; k < TP_WRENCH; k++) fmpq_set(a->twist + k, twist + k);
  }
  fmpq_sub(part, t, error);
  if (!a->has_least || fmpq_cmp(part, a->low) < 0) fmpq_set(a->low, part);
  a->has_least = true;
  fmpq_clear(t);
  fmpq_clear(error);
  fmpq_clear(part);
}

static void take_ray(answer *a, const squeezed *s, const fmpq ray[MOST_FREE],
                     const tp_hold_load *load, const tp_hold_load *way) {
  fmpq twist[TP_WRENCH];
  fmpq_t entry, gain, part, entry_error, gain_error;
  for (long n = 0; n < s->sign_count; n++) {
    fmpq_init(entry);
    evaluate(entry, s->signs[n], ray, s->free_count);
    const bool against = fmpq_sgn(entry) < 0;
    fmpq_clear(entry);
    if (against) return;
  }
  fmpq_init(entry);
  fmpq_init(gain);
  fmpq_init(part);
  fmpq_init(entry_error);
  fmpq_init(gain_error);
  for (int k = 0; k < TP_WRENCH; k++) {
    fmpq_init(twist + k);
    for (int i = 0; i < s->free_count; i++) fmpq_addmul(twist + k, s->free[i] + k, ray + i);
  }
  a->any = true;
  tp_rational3_dot(entry, twist, load->exact);
  tp_rational3_dot(gain, twist, way->exact);
  set_gain_error(entry_error, twist, load);
  set_gain_error(gain_error, twist, way);
  fmpq_neg(entry, entry);
  fmpq_abs(part, gain);
  const bool has_sign = fmpq_is_zero(gain_error) || fmpq_cmp(part, gain_error) > 0;
  if (fmpq_cmp(entry, entry_error) < 0 || !has_sign) {
    a->is_open = true;
  } else if (fmpq_sgn(gain) > 0) {
    take_limit(a, twist, entry, gain, entry_error, gain_error);
  }
  for (int k = 0; k < TP_WRENCH; k++) fmpq_clear(twist + k);
  fmpq_clear(entry);
  fmpq_clear(gain);
  fmpq_clear(part);
  fmpq_clear(entry_error);
  fmpq_clear(gain_error);
}

static void take_both(answer *a, const squeezed *s, fmpq ray[MOST_FREE], const tp_hold_load *load,
                      const tp_hold_load *way) {
  if (tp_rational3_is_zero(ray)) return;
  for (int turn = 0; turn < 2; turn++) {
    take_ray(a, s, ray, load, way);
    for (int k = 0; k < MOST_FREE; k++) fmpq_neg(ray + k, ray + k);
  }
}

/* Is some free motion on no sign row at all? Then rays are not all of the cone. */
static bool has_line(const squeezed *s) {
  fmpq_mat_t rows;
  fmpq_mat_init(rows, s->sign_count > 0 ? s->sign_count : 1, MOST_FREE);
  for (long n = 0; n < s->sign_count; n++) {
    for (int k = 0; k < s->free_count; k++) fmpq_set(fmpq_mat_entry(rows, n, k), s->signs[n] + k);
  }
  const long rank = fmpq_mat_rref(rows, rows);
  fmpq_mat_clear(rows);
  return rank < s->free_count;
}

static void take_rays(answer *a, const squeezed *s, const tp_hold_load *load,
                      const tp_hold_load *way) {
  fmpq ray[MOST_FREE];
  tp_rational3_init(ray);
  if (s->free_count == 1) {
    fmpq_one(ray);
    take_both(a, s, ray, load, way);
  }
  for (long i = 0; i < s->sign_count && s->free_count == 2; i++) {
    fmpq_neg(ray, s->signs[i] + 1);
    fmpq_set(ray + 1, s->signs[i]);
    take_both(a, s, ray, load, way);
  }
  for (long i = 0; i < s->sign_count && s->free_count == 3; i++) {
    for (long j = 0; j < i; j++) {
      tp_rational3_cross(ray, s->signs[i], s->signs[j]);
      take_both(a, s, ray, load, way);
    }
  }
  tp_rational3_clear(ray);
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static void settle(tp_squeezed_limit *limit, const answer *a, const tp_friction_cones *cones) {
  if (a->is_open) return;
  if (!a->has_least) {
    limit->is_known = limit->is_endless = true;
    return;
  }
  for (long n = 0; n < cones->count; n++) {
    if (!is_let(cones->cones + n, a->twist)) return;
  }
  fmpq_t part;
  fmpq_init(part);
  fmpq_sub(part, a->least, a->low);
  const double t = fmpq_get_d(a->least), error = fmax(fmpq_get_d(part), fmpq_get_d(a->error));
  fmpq_clear(part);
  limit->is_known = true;
  limit->t = tp_near_of(t, t * DBL_EPSILON + 2 * error);
  for (int k = 0; k < TP_WRENCH; k++) limit->twist[k] = fmpq_get_d(a->twist + k);
}

static void squeezed_init(squeezed *s, const tp_friction_cones *cones) {
  enum { ROWS_OF_PAIR = 18 };
  *s = (squeezed){.cones = cones};
  fmpq_mat_init(s->rows, ROWS_OF_PAIR * cones->count * cones->count / 2, TP_WRENCH);
  for (int i = 0; i < MOST_FREE; i++) {
    for (int k = 0; k < TP_WRENCH; k++) fmpq_init(s->free[i] + k);
  }
  for (long n = 0; n < MOST_CONTACTS; n++) tp_rational3_init(s->signs[n]);
}

static void squeezed_clear(squeezed *s) {
  fmpq_mat_clear(s->rows);
  for (int i = 0; i < MOST_FREE; i++) {
    for (int k = 0; k < TP_WRENCH; k++) fmpq_clear(s->free[i] + k);
  }
  for (long n = 0; n < MOST_CONTACTS; n++) tp_rational3_clear(s->signs[n]);
}

static void find(tp_squeezed_limit *limit, squeezed *s, const tp_hold_load *load,
                 const tp_hold_load *way) {
  answer a = {.any = false};
  for (long n = 0; n < s->cones->count; n++) {
    for (long k = 0; k < n; k++) take_pair(s, s->cones->cones + n, s->cones->cones + k);
  }
  if (!s->any || !find_free(s) || !is_proven(s)) return;
  set_signs(s);
  if (has_line(s)) return;
  fmpq_init(a.least);
  fmpq_init(a.error);
  fmpq_init(a.low);
  for (int k = 0; k < TP_WRENCH; k++) fmpq_init(a.twist + k);
  take_rays(&a, s, load, way);
  settle(limit, &a, s->cones);
  fmpq_clear(a.least);
  fmpq_clear(a.error);
  fmpq_clear(a.low);
  for (int k = 0; k < TP_WRENCH; k++) fmpq_clear(a.twist + k);
}

void tp_squeezed_find(tp_squeezed_limit *limit, const tp_friction_cones *cones,
                      const tp_hold_load *load, const tp_hold_load *way) {
  *limit = (tp_squeezed_limit){.is_known = false};
  if (cones->count > MOST_CONTACTS) return;
  for (long n = 0; n < cones->count; n++) {
    if (cones->cones[n].friction.error != 0) return;
  }
  squeezed *s = malloc(sizeof *s);
  if (s == NULL) return;
  squeezed_init(s, cones);
  find(limit, s, load, way);
  squeezed_clear(s);
  free(s);
}
