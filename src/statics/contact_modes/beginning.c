/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* M Z q - A f = w: Z the free accelerations, q their shares, f a normal force an end that is
 * closed, with friction of its own where it slips, and a shear force a contact that sticks. */

#include "contact_modes/beginning.h"

#include "common/message.h"
#include "contact_modes/basis_proof.h"
#include "contact_modes/rigid_groups.h"

#include "number/ball.h"

#include <math.h>
#include <stdlib.h>

enum { BITS = 192 };

typedef struct proving {
  const tp_beginning_question *q;
  tp_rigid_groups groups;
  long count;                 /* of the columns: shares first, then forces */
  tp_mode_set *modes;         /* by contact; one that slips without force is open */
  long *normal_at, *shear_at; /* 2 and 1 a contact: columns of its forces; -1 */
  arb_mat_t columns, right, factors;
  double *preference;
} proving;

static long contact_count(const proving *s) {
  return s->q->resting->contact_count;
}

static void set_ball(arb_t ball, tp_near number) {
  tp_ball_set_bounded(ball, number.value, number.error);
}

/* ---- columns -----------------------------------------------------------------------------------
 */

static bool number_columns(proving *s) {
  s->normal_at = calloc(2 * (size_t)contact_count(s) + 1, sizeof *s->normal_at);
  s->shear_at = calloc((size_t)contact_count(s) + 1, sizeof *s->shear_at);
  if (s->normal_at == NULL || s->shear_at == NULL) return false;
  s->count = s->groups.freedom;
  for (long k = 0; k < contact_count(s); k++) {
    const tp_mode_set mode = s->modes[k];
    for (int e = 0; e < 2; e++) {
      const bool has = e < s->q->resting->contacts[k].ends && (mode & tp_modes_closed(e)) != 0;
      s->normal_at[2 * k + e] = has ? s->count++ : -1;
    }
    s->shear_at[k] = (mode & TP_MODES_STICK) != 0 ? s->count++ : -1;
  }
  s->preference = calloc((size_t)s->count + 1, sizeof *s->preference);
  return s->preference != NULL;
}

/* a of a block in one free acceleration, in units of the assemblage, over 2^scale. */
static void set_acceleration(arb_struct a[3], const proving *s, long block, long freedom,
                             long scale) {
  fmpz_t own;
  fmpz_init(own);
  for (int e = 0; e < 3; e++) {
    tp_rigid_groups_acceleration(own, &s->groups, block, e, freedom);
    arb_set_fmpz(a + e, own);
    const long unit = e == 2 ? s->q->resting->assemblage->length_exponent : 0;
    arb_mul_2exp_si(a + e, a + e, unit - scale);
  }
  fmpz_clear(own);
}

/* So that the largest number of a free acceleration is about one. */
static long scale_of(const proving *s, long freedom) {
  fmpz_t own;
  fmpz_init(own);
  long most = 0;
  for (long b = 0; b < s->q->resting->rows / 3; b++) {
    for (int e = 0; e < 2; e++) {
      tp_rigid_groups_acceleration(own, &s->groups, s->q->resting->block[b], e, freedom);
      most = most > (long)fmpz_bits(own) ? most : (long)fmpz_bits(own);
    }
  }
  fmpz_clear(own);
  return most;
}

static const tp_rigid_block *block_of(const proving *s, long number) {
  return s->q->resting->assemblage->blocks + s->q->resting->block[number];
}

/* M a = W (a_x - r_y theta, a_y + r_x theta, (k^2 - r^2) theta) about the centroid, r from the
 * block's own point to there. */
static void set_inertia(proving *s, long number, long column, arb_struct a[3]) {
  const tp_rigid_block *b = block_of(s, number);
  arb_t weight, x, y, gyration2;
  arb_init(weight);
  arb_init(x);
  arb_init(y);
  arb_init(gyration2);
  set_ball(weight, b->weight);
  set_ball(x, b->arm_x);
  set_ball(y, b->arm_y);
  set_ball(gyration2, b->gyration2);
  arb_submul(gyration2, x, x, BITS);
  arb_submul(gyration2, y, y, BITS);
  arb_struct *const own[3] = {arb_mat_entry(s->columns, 3 * number, column),
                              arb_mat_entry(s->columns, 3 * number + 1, column),
                              arb_mat_entry(s->columns, 3 * number + 2, column)};
  arb_set(own[0], a + 0);
  arb_submul(own[0], y, a + 2, BITS);
  arb_set(own[1], a + 1);
  arb_addmul(own[1], x, a + 2, BITS);
  arb_mul(own[2], gyration2, a + 2, BITS);
  for (int e = 0; e < 3; e++) arb_mul(own[e], own[e], weight, BITS);
  arb_clear(weight);
  arb_clear(x);
  arb_clear(y);
  arb_clear(gyration2);
}

static void set_shares(proving *s) {
  static const double first = 1e9; /* shares are always of the basis */
  arb_struct a[3];
  for (int e = 0; e < 3; e++) arb_init(a + e);
  for (long f = 0; f < s->groups.freedom; f++) {
    const long scale = scale_of(s, f);
    s->preference[f] = first;
    for (long b = 0; b < s->q->resting->rows / 3; b++) {
      set_acceleration(a, s, s->q->resting->block[b], f, scale);
      set_inertia(s, b, f, a);
    }
  }
  for (int e = 0; e < 3; e++) arb_clear(a + e);
}

/* Less so much of a force, in a column; its moment about the centroid. */
static void add_force(proving *s, long at, const tp_force_column *c, const arb_t share) {
  arb_t entry[3], arm;
  for (int e = 0; e < 3; e++) arb_init(entry[e]);
  arb_init(arm);
  for (int side = 0; side < 2; side++) {
    if (c->row[side] < 0) continue;
    const tp_rigid_block *b = block_of(s, c->row[side] / 3);
    for (int e = 0; e < 3; e++) set_ball(entry[e], c->entry[side][e]);
    set_ball(arm, b->arm_x);
    arb_submul(entry[2], arm, entry[1], BITS);
    set_ball(arm, b->arm_y);
    arb_addmul(entry[2], arm, entry[0], BITS);
    for (int e = 0; e < 3; e++) {
      arb_submul(arb_mat_entry(s->columns, c->row[side] + e, at), share, entry[e], BITS);
    }
  }
  for (int e = 0; e < 3; e++) arb_clear(entry[e]);
  arb_clear(arm);
}

static void set_normal(proving *s, long contact, int end) {
  static const double least = 1e-12;
  const long at = s->normal_at[2 * contact + end];
  const tp_resting_contact *c = s->q->resting->contacts + contact;
  const double own = fmax(0, s->q->normals[2 * contact + end]);
  const tp_mode_set mode = s->modes[contact];
  arb_t share;
  arb_init(share);
  arb_one(share);
  add_force(s, at, c->normal + end, share);
  if ((mode & TP_MODES_STICK) == 0) {
    set_ball(share, s->q->friction[contact]);
    if ((mode & TP_MODES_FORWARD) != 0) arb_neg(share, share);
    add_force(s, at, &c->along, share);
  }
  arb_set_d(arb_mat_entry(s->factors, at, 0), own);
  s->preference[at] = own + least;
  arb_clear(share);
}

static void set_shear(proving *s, long contact) {
  static const double least = 1e-12;
  const long at = s->shear_at[contact];
  const tp_resting_contact *c = s->q->resting->contacts + contact;
  const double *normals = s->q->normals + 2 * contact, *shears = s->q->shears + 2 * contact;
  double shear = shears[0], normal = normals[0];
  if (c->ends == 2) {
    shear += shears[1];
    normal += normals[1];
  }
  arb_t share;
  arb_init(share);
  arb_one(share);
  add_force(s, at, &c->along, share);
  arb_set_d(arb_mat_entry(s->factors, at, 0), shear);
  s->preference[at] = fmax(0, s->q->friction[contact].value * normal - fabs(shear)) + least;
  arb_clear(share);
}

static void set_all(proving *s) {
  set_shares(s);
  for (long k = 0; k < contact_count(s); k++) {
    for (int e = 0; e < 2; e++) {
      if (s->normal_at[2 * k + e] >= 0) set_normal(s, k, e);
    }
    if (s->shear_at[k] >= 0) set_shear(s, k);
  }
  for (long r = 0; r < s->q->resting->rows; r++) {
    set_ball(arb_mat_entry(s->right, r, 0), s->q->loads[r]);
  }
}

/* ---- what must hold ----------------------------------------------------------------------------
 */

/* A row of a contact on the shares, times their sign: certainly not below zero. */
static bool is_not_below(const proving *s, long contact, int end, bool along, bool back) {
  const long freedom = s->groups.freedom;
  fmpz *row = _fmpz_vec_init(freedom);
  tp_rigid_groups_row(row, &s->groups, contact, end, along);
  arb_t sum, part;
  arb_init(sum);
  arb_init(part);
  for (long f = 0; f < freedom; f++) {
    if (fmpz_is_zero(row + f)) continue;
    arb_set(part, arb_mat_entry(s->factors, f, 0));
    arb_mul_2exp_si(part, part, -scale_of(s, f));
    arb_addmul_fmpz(sum, part, row + f, BITS);
  }
  if (back) arb_neg(sum, sum);
  const bool holds = arb_is_nonnegative(sum);
  arb_clear(sum);
  arb_clear(part);
  _fmpz_vec_clear(row, freedom);
  return holds;
}

/* |T| <= N tan(phi). */
static bool is_within_friction(const proving *s, long contact) {
  arb_t left, part;
  arb_init(left);
  arb_init(part);
  for (int e = 0; e < 2; e++) {
    const long at = s->normal_at[2 * contact + e];
    if (at >= 0) arb_add(left, left, arb_mat_entry(s->factors, at, 0), BITS);
  }
  set_ball(part, s->q->friction[contact]);
  arb_mul(left, left, part, BITS);
  arb_abs(part, arb_mat_entry(s->factors, s->shear_at[contact], 0));
  arb_sub(left, left, part, BITS);
  const bool holds = arb_is_nonnegative(left);
  arb_clear(left);
  arb_clear(part);
  return holds;
}

static bool contact_holds(const proving *s, long k) {
  const tp_mode_set mode = s->modes[k];
  for (int e = 0; e < s->q->resting->contacts[k].ends; e++) {
    const long at = s->normal_at[2 * k + e];
    if (at < 0 ? !is_not_below(s, k, e, false, false)
               : !arb_is_nonnegative(arb_mat_entry(s->factors, at, 0))) {
      return false;
    }
  }
  if (s->shear_at[k] >= 0) return is_within_friction(s, k);
  return mode == TP_MODES_OPEN || is_not_below(s, k, 0, true, (mode & TP_MODES_BACK) != 0);
}

static bool all_hold(const proving *s) {
  bool moves = false;
  for (long f = 0; f < s->groups.freedom; f++) {
    moves = moves || !arb_contains_zero(arb_mat_entry(s->factors, f, 0));
  }
  for (long k = 0; k < contact_count(s) && moves; k++) moves = contact_holds(s, k);
  return moves;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static void tell(double *accelerations, const proving *s) {
  arb_struct a[3];
  for (int e = 0; e < 3; e++) arb_init(a + e);
  for (long r = 0; r < s->q->resting->rows; r++) accelerations[r] = 0;
  for (long f = 0; f < s->groups.freedom; f++) {
    const double share = arf_get_d(arb_midref(arb_mat_entry(s->factors, f, 0)), ARF_RND_NEAR);
    const long scale = scale_of(s, f);
    for (long b = 0; b < s->q->resting->rows / 3; b++) {
      set_acceleration(a, s, s->q->resting->block[b], f, scale);
      for (int e = 0; e < 3; e++) {
        accelerations[3 * b + e] += share * arf_get_d(arb_midref(a + e), ARF_RND_NEAR);
      }
    }
  }
  for (int e = 0; e < 3; e++) arb_clear(a + e);
}

static tp_status prove(bool *proven, double *accelerations, proving *s, tp_message *message) {
  const long rows = s->q->resting->rows;
  if (!number_columns(s)) return tp_fail_memory(message, "a proof");
  arb_mat_init(s->columns, rows, s->count);
  arb_mat_init(s->right, rows, 1);
  arb_mat_init(s->factors, s->count, 1);
  set_all(s);
  const tp_basis_task task = {s->columns, s->right, s->preference, BITS};
  tp_status status = tp_basis_solve(s->factors, &task, message);
  *proven = status == TP_OK && all_hold(s);
  if (*proven) tell(accelerations, s);
  arb_mat_clear(s->columns);
  arb_mat_clear(s->right);
  arb_mat_clear(s->factors);
  return status == TP_NO_ANSWER ? TP_OK : status;
}

/* What slips and bears nothing is held by nothing either: its block is free of it. */
static bool set_modes(proving *s) {
  static const double nothing = 1e-9;
  s->modes = calloc((size_t)contact_count(s) + 1, sizeof *s->modes);
  for (long k = 0; k < contact_count(s) && s->modes != NULL; k++) {
    const double *normals = s->q->normals + 2 * k;
    const bool bears = normals[0] > nothing || normals[1] > nothing;
    const bool slips = (s->q->modes[k] & (TP_MODES_FORWARD | TP_MODES_BACK)) != 0;
    s->modes[k] = slips && !bears ? TP_MODES_OPEN : s->q->modes[k];
  }
  return s->modes != NULL;
}

tp_status tp_beginning_prove(bool *proven, double *accelerations, const tp_beginning_question *q,
                             tp_message *message) {
  proving s = {.q = q};
  *proven = false;
  if (!set_modes(&s)) return tp_fail_memory(message, "a proof");
  tp_status status = tp_rigid_groups_init(&s.groups, q->resting, s.modes, message);
  if (status == TP_OK) {
    if (s.groups.freedom > 0) status = prove(proven, accelerations, &s, message);
    tp_rigid_groups_clear(&s.groups);
  }
  free(s.modes);
  free(s.normal_at);
  free(s.shear_at);
  free(s.preference);
  return status;
}
