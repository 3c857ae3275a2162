/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Accelerations in whole numbers, all else in balls of doubles with their bounds. */

#include "contact_modes/mode_equations.h"

#include "common/message.h"

#include "number/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = TP_EQUATION_BITS };

static void set_ball(arb_t ball, tp_near number) {
  tp_ball_set_bounded(ball, number.value, number.error);
}

int tp_trial_slip(const tp_trial_mode *t) {
  return t->spent != 0                       ? t->spent
         : (t->mode & TP_MODES_FORWARD) != 0 ? 1
         : (t->mode & TP_MODES_BACK) != 0    ? -1
                                             : 0;
}

bool tp_trial_is_bonded(const tp_beginning_question *q, const tp_trial_mode *t, long contact) {
  if (q->bond == NULL || t->spent != 0 || (t->mode & (TP_MODES_FORWARD | TP_MODES_BACK)) == 0) {
    return false;
  }
  const bool is_whole = (t->mode & tp_modes_closed(0) & tp_modes_closed(1)) != 0;
  const tp_near *bond = q->bond + 2 * contact;
  return is_whole && !(tp_near_is_zero(bond[0]) && tp_near_is_zero(bond[1]));
}

/* ---- columns -----------------------------------------------------------------------------------
 */

static bool number_columns(tp_mode_equations *s) {
  const tp_resting *r = s->groups->resting;
  s->normal_at = calloc(2 * (size_t)r->contact_count + 1, sizeof *s->normal_at);
  s->shear_at = calloc((size_t)r->contact_count + 1, sizeof *s->shear_at);
  if (s->normal_at == NULL || s->shear_at == NULL) return false;
  s->count = s->groups->freedom;
  for (long k = 0; k < r->contact_count; k++) {
    const tp_trial_mode *own = s->trial + k;
    bool bears = false;
    for (int e = 0; e < 2; e++) {
      const bool closed = e < r->contacts[k].ends && (own->mode & tp_modes_closed(e)) != 0;
      const bool has = closed && !own->idle[e];
      s->normal_at[2 * k + e] = has ? s->count++ : -1;
      bears = bears || has;
    }
    const bool grips = bears && own->spent == 0 && (own->mode & TP_MODES_STICK) != 0;
    s->shear_at[k] = grips ? s->count++ : -1;
  }
  s->preference = calloc((size_t)s->count + 1, sizeof *s->preference);
  return s->preference != NULL;
}

void tp_mode_acceleration(arb_struct a[3], const tp_mode_equations *s, long block, long share) {
  fmpz_t own;
  fmpz_init(own);
  for (int e = 0; e < 3; e++) {
    tp_rigid_groups_acceleration(own, s->groups, block, e, share);
    arb_set_fmpz(a + e, own);
    const long unit = e == 2 ? s->groups->resting->assemblage->length_exponent : 0;
    arb_mul_2exp_si(a + e, a + e, unit - s->groups->scale[share]);
  }
  fmpz_clear(own);
}

static const tp_rigid_block *block_of(const tp_mode_equations *s, long number) {
  return s->groups->resting->assemblage->blocks + s->groups->resting->block[number];
}

/* M a = W (a_x - r_y theta, a_y + r_x theta, (k^2 - r^2) theta) about the centroid, r from the
 * block's own point to there. */
static void set_inertia(tp_mode_equations *s, long number, long column, arb_struct a[3]) {
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

static void set_shares(tp_mode_equations *s) {
  static const double first = 1e9; /* shares are always of the basis */
  arb_struct a[3];
  for (int e = 0; e < 3; e++) arb_init(a + e);
  for (long f = 0; f < s->groups->freedom; f++) {
    s->preference[f] = first;
    for (long b = 0; b < s->groups->resting->rows / 3; b++) {
      tp_mode_acceleration(a, s, s->groups->resting->block[b], f);
      set_inertia(s, b, f, a);
    }
  }
  for (int e = 0; e < 3; e++) arb_clear(a + e);
}

/* Less so much of a force, in a column of any matrix; its moment about the centroid. */
static void add_force(arb_mat_t to, const tp_mode_equations *s, long at, const tp_force_column *c,
                      const arb_t share) {
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
      arb_submul(arb_mat_entry(to, c->row[side] + e, at), share, entry[e], BITS);
    }
  }
  for (int e = 0; e < 3; e++) arb_clear(entry[e]);
  arb_clear(arm);
}

/* The normal force to begin from; of an end that may pull what is left without the pull in w. */
static double first_normal(const tp_mode_equations *s, long contact, int end) {
  const double all = fmax(0, s->question->normals[2 * contact + end]);
  if (!tp_trial_is_bonded(s->question, s->trial + contact, contact)) return all;
  const double rest = all - s->question->bond[2 * contact + end].value;
  return s->trial[contact].pulled[end] ? fmin(0, rest) : fmax(0, rest);
}

static void set_normal(tp_mode_equations *s, long contact, int end) {
  static const double least = 1e-12;
  const long at = s->normal_at[2 * contact + end];
  const tp_resting_contact *c = s->groups->resting->contacts + contact;
  const double first = first_normal(s, contact, end);
  const bool is_bonded = tp_trial_is_bonded(s->question, s->trial + contact, contact);
  const bool pulls = is_bonded && s->trial[contact].pulled[end];
  const int slip = pulls ? 0 : tp_trial_slip(s->trial + contact);
  arb_t share;
  arb_init(share);
  arb_one(share);
  add_force(s->columns, s, at, c->normal + end, share);
  if (slip != 0) {
    set_ball(share, s->question->friction[contact]);
    if (slip > 0) arb_neg(share, share);
    add_force(s->columns, s, at, &c->along, share);
  }
  arb_set_d(arb_mat_entry(s->factors, at, 0), first);
  s->preference[at] = fabs(first) + least;
  arb_clear(share);
}

static void set_shear(tp_mode_equations *s, long contact) {
  static const double least = 1e-12;
  const long at = s->shear_at[contact];
  const tp_beginning_question *q = s->question;
  const tp_resting_contact *c = s->groups->resting->contacts + contact;
  const double *normals = q->normals + 2 * contact, *shears = q->shears + 2 * contact;
  double shear = shears[0], normal = normals[0];
  if (c->ends == 2) {
    shear += shears[1];
    normal += normals[1];
  }
  arb_t share;
  arb_init(share);
  arb_one(share);
  add_force(s->columns, s, at, &c->along, share);
  arb_set_d(arb_mat_entry(s->factors, at, 0), shear);
  s->preference[at] = fmax(0, q->friction[contact].value * normal - fabs(shear)) + least;
  arb_clear(share);
}

/* How a line slips of which one contact at least stays closed, and bears something. */
static int slip_of_line(const tp_mode_equations *s, long line) {
  const tp_resting *r = s->groups->resting;
  for (long k = line; k < r->contact_count; k++) {
    const bool bears = s->normal_at[2 * k] >= 0 || s->normal_at[2 * k + 1] >= 0;
    if (r->contacts[k].line != line || !bears) continue;
    const int slip = tp_trial_slip(s->trial + k);
    if (slip != 0) return slip;
  }
  return 0;
}

/* All of it against the slip of its line, as a load. */
static void set_cohesion(tp_mode_equations *s, long contact) {
  const tp_near own = s->question->cohesion[contact];
  if (tp_near_is_zero(own)) return;
  const tp_resting_contact *c = s->groups->resting->contacts + contact;
  const int slip = slip_of_line(s, c->line);
  if (slip == 0) return;
  arb_t share;
  arb_init(share);
  set_ball(share, own);
  if (slip < 0) arb_neg(share, share);
  add_force(s->right, s, 0, &c->along, share);
  arb_clear(share);
}

/* Without the pull in w of a contact whose ends are solved for what they bear or pull. */
static void release_bond(tp_mode_equations *s, long contact) {
  if (!tp_trial_is_bonded(s->question, s->trial + contact, contact)) return;
  const tp_resting_contact *c = s->groups->resting->contacts + contact;
  arb_t share;
  arb_init(share);
  for (int e = 0; e < 2; e++) {
    set_ball(share, s->question->bond[2 * contact + e]);
    arb_neg(share, share);
    add_force(s->right, s, 0, c->normal + e, share);
  }
  arb_clear(share);
}

static void set_all(tp_mode_equations *s) {
  const tp_resting *r = s->groups->resting;
  set_shares(s);
  for (long k = 0; k < r->contact_count; k++) {
    for (int e = 0; e < 2; e++) {
      if (s->normal_at[2 * k + e] >= 0) set_normal(s, k, e);
    }
    if (s->shear_at[k] >= 0) set_shear(s, k);
  }
  for (long row = 0; row < r->rows; row++) {
    set_ball(arb_mat_entry(s->right, row, 0), s->question->loads[row]);
  }
  for (long k = 0; k < r->contact_count; k++) {
    set_cohesion(s, k);
    release_bond(s, k);
  }
}

/* ---- all ---------------------------------------------------------------------------------------
 */

tp_status tp_mode_equations_init(tp_mode_equations *s, tp_message *message) {
  const long rows = s->groups->resting->rows;
  const bool made = number_columns(s);
  arb_mat_init(s->columns, rows, made ? s->count : 0);
  arb_mat_init(s->right, rows, 1);
  arb_mat_init(s->factors, made ? s->count : 0, 1);
  if (made) {
    set_all(s);
    return TP_OK;
  }
  tp_mode_equations_clear(s);
  return tp_fail_memory(message, "a proof");
}

void tp_mode_equations_clear(tp_mode_equations *s) {
  arb_mat_clear(s->columns);
  arb_mat_clear(s->right);
  arb_mat_clear(s->factors);
  free(s->normal_at);
  free(s->shear_at);
  free(s->preference);
}
