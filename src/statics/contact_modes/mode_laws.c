/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Signs of balls: rows of contacts on the shares, and forces. */

#include "contact_modes/mode_laws.h"

#include "contact_modes/corner_modes.h"

#include "number/ball.h"

enum { BITS = TP_EQUATION_BITS };

typedef enum sign { SIGN_HOLDS, SIGN_TIED, SIGN_FAILS } sign;

/* Certainly not below zero; else nothing, next to weights and gravity of about one; else below. */
static sign sign_of(const arb_t number) {
  static const double tied = 1e-10;
  if (arb_is_nonnegative(number)) return SIGN_HOLDS;
  return arf_cmpabs_d(arb_midref(number), tied) < 0 ? SIGN_TIED : SIGN_FAILS;
}

/* A row of a contact on the shares. */
static void velocity(arb_t sum, const tp_mode_equations *s, long contact, int end, bool along) {
  const long freedom = s->groups->freedom;
  fmpz *row = _fmpz_vec_init(freedom);
  tp_rigid_groups_row(row, s->groups, contact, end, along);
  arb_t part;
  arb_init(part);
  arb_zero(sum);
  for (long f = 0; f < freedom; f++) {
    if (fmpz_is_zero(row + f)) continue;
    arb_set(part, arb_mat_entry(s->factors, f, 0));
    arb_mul_2exp_si(part, part, -s->groups->scale[f]);
    arb_addmul_fmpz(sum, part, row + f, BITS);
  }
  arb_clear(part);
  _fmpz_vec_clear(row, freedom);
}

/* In units of the assemblage, as velocities are of the order of gravity there. */
static void scaled_velocity(arb_t sum, const tp_mode_equations *s, long contact, int end,
                            bool along) {
  const tp_resting *r = s->groups->resting;
  const tp_block_contact *c = &r->contacts[contact].of;
  const tp_lattice *l = &r->assemblage->lattice;
  fmpz_t dx, dy;
  fmpz_init(dx);
  fmpz_init(dy);
  fmpz_sub(dx, l->x + c->along[1], l->x + c->along[0]);
  fmpz_sub(dy, l->y + c->along[1], l->y + c->along[0]);
  const long x = (long)fmpz_bits(dx), y = (long)fmpz_bits(dy);
  fmpz_clear(dx);
  fmpz_clear(dy);
  velocity(sum, s, contact, end, along);
  arb_mul_2exp_si(sum, sum, -(x > y ? x : y));
}

static sign sign_of_velocity(const tp_mode_equations *s, long contact, int end, bool along,
                             bool back) {
  arb_t sum;
  arb_init(sum);
  scaled_velocity(sum, s, contact, end, along);
  if (back) arb_neg(sum, sum);
  const sign own = sign_of(sum);
  arb_clear(sum);
  return own;
}

static const arb_struct *force(const tp_mode_equations *s, long at) {
  return arb_mat_entry(s->factors, at, 0);
}

/* N tan(phi) + c - |T| of a contact that sticks. */
static sign sign_of_reserve(const tp_mode_equations *s, long contact) {
  arb_t left, part;
  arb_init(left);
  arb_init(part);
  for (int e = 0; e < 2; e++) {
    const long at = s->normal_at[2 * contact + e];
    if (at >= 0) arb_add(left, left, force(s, at), BITS);
  }
  tp_ball_set_bounded(part, s->question->friction[contact].value,
                      s->question->friction[contact].error);
  arb_mul(left, left, part, BITS);
  tp_ball_set_bounded(part, s->question->cohesion[contact].value,
                      s->question->cohesion[contact].error);
  arb_add(left, left, part, BITS);
  arb_abs(part, force(s, s->shear_at[contact]));
  arb_sub(left, left, part, BITS);
  const sign own = sign_of(left);
  arb_clear(left);
  arb_clear(part);
  return own;
}

/* ---- one contact -------------------------------------------------------------------------------
 */

static void set_mode(tp_trial_mode *own, const bool closed[2], tp_mode_slip slip) {
  own->mode = closed[0] || closed[1] ? tp_mode_of(closed[0], closed[1], slip) : TP_MODES_OPEN;
  if (own->mode == TP_MODES_OPEN) own->spent = 0;
}

static tp_mode_slip slip_of(tp_mode_set mode) {
  return (mode & TP_MODES_STICK) != 0     ? TP_MODE_STICKS
         : (mode & TP_MODES_FORWARD) != 0 ? TP_MODE_FORWARD
                                          : TP_MODE_BACK;
}

/* Does the other side of a pair of corners keep them apart, or is it the one that is to close? */
static bool is_kept_apart(const tp_trial_mode *own, const tp_mode_equations *s, long k) {
  const long twin = s->groups->resting->contacts[k].twin;
  if (twin < 0) return false;
  if (s->trial[twin].mode != TP_MODES_OPEN) return true;
  if (own->mode != TP_MODES_OPEN) return false;
  if (sign_of_velocity(s, twin, 0, false, false) == SIGN_HOLDS) return true;
  arb_t one, other;
  arb_init(one);
  arb_init(other);
  scaled_velocity(one, s, k, 0, false);
  scaled_velocity(other, s, twin, 0, false);
  const int order = arf_cmp(arb_midref(one), arb_midref(other));
  arb_clear(one);
  arb_clear(other);
  return order < 0 || (order == 0 && twin < k);
}

/* How far the pulls of a bond are below what it can bear: of pieces, below what both end ones can.
 */
static sign sign_of_bond(const tp_trial_mode *trial, const tp_mode_equations *s, long k) {
  const tp_near *piece = s->question->piece + 2 * k;
  const tp_near most = piece[piece[1].value < piece[0].value ? 1 : 0];
  arb_t left;
  arb_init(left);
  tp_ball_set_bounded(left, most.value, most.error);
  for (int e = 0; e < 2; e++) {
    const long at = s->normal_at[2 * k + e];
    if (trial->pulled[e] && at >= 0) arb_add(left, left, force(s, at), BITS);
  }
  const sign found = sign_of(left);
  arb_clear(left);
  return found;
}

/* An end that would pull does, one that pulls and would press presses, and what is neither bears
 * nothing; where the bond is not enough the end that pulls the most opens. True where something has
 * to change. */
static bool change_bonded(tp_trial_mode *trial, const tp_mode_equations *s, long k) {
  const tp_trial_mode before = *trial;
  const sign bond = sign_of_bond(trial, s, k);
  bool changed = false;
  for (int e = 0; e < 2; e++) {
    const long at = s->normal_at[2 * k + e];
    if (at < 0) continue;
    arb_t normal;
    arb_init(normal);
    if (before.pulled[e])
      arb_neg(normal, force(s, at));
    else
      arb_set(normal, force(s, at));
    const sign found = sign_of(normal);
    arb_clear(normal);
    if (found == SIGN_HOLDS) continue;
    trial->idle[e] = found == SIGN_TIED;
    trial->pulled[e] = found == SIGN_FAILS && !before.pulled[e];
    changed = true;
  }
  if (changed || bond == SIGN_HOLDS) return changed;
  const long *at = s->normal_at + 2 * k;
  int opens = before.pulled[0] && at[0] >= 0 ? 0 : 1;
  if (opens == 0 && before.pulled[1] && at[1] >= 0 &&
      arf_cmp(arb_midref(force(s, at[1])), arb_midref(force(s, at[0]))) < 0) {
    opens = 1;
  }
  const bool closed[2] = {opens != 0, opens != 1};
  trial->pulled[0] = trial->pulled[1] = false;
  set_mode(trial, closed, slip_of(trial->mode));
  return true;
}

/* Ends that open or close; true where one has to. */
static bool change_ends(tp_trial_mode *own, const tp_mode_equations *s, long k) {
  bool closed[2] = {false, false}, changed = false, bears = false;
  const tp_mode_set mode = own->mode;
  if (tp_trial_is_bonded(s->question, own, k)) return change_bonded(own, s, k);
  for (int e = 0; e < s->groups->resting->contacts[k].ends; e++) {
    closed[e] = (mode & tp_modes_closed(e)) != 0;
    const long at = s->normal_at[2 * k + e];
    if (closed[e] && at < 0) continue; /* idle */
    const sign found = closed[e] ? sign_of(force(s, at)) : sign_of_velocity(s, k, e, false, false);
    if (found == SIGN_HOLDS || (!closed[e] && is_kept_apart(own, s, k))) continue;
    own->idle[e] = !closed[e] && found == SIGN_TIED;
    closed[e] = !closed[e];
    bears = bears || (closed[e] && !own->idle[e]);
    changed = true;
  }
  const tp_mode_slip anew = bears ? TP_MODE_STICKS : TP_MODE_FORWARD; /* idle: either way */
  if (changed) set_mode(own, closed, mode == TP_MODES_OPEN ? anew : slip_of(mode));
  return changed;
}

/* Corners part that slip along an edge to where it ends. */
static bool parts_by_slip(const tp_trial_mode *own, const tp_resting *r, long k) {
  if (r->contacts[k].twin < 0 || own->spent != 0) return false;
  return (own->mode & (tp_modes_is_second_side(r, k) ? TP_MODES_FORWARD : TP_MODES_BACK)) != 0;
}

/* Friction of a contact that bears something; true where it has to change. */
static bool change_slip(tp_trial_mode *own, const tp_mode_equations *s, long k) {
  const long *normals = s->normal_at + 2 * k;
  const bool closed[2] = {(own->mode & tp_modes_closed(0)) != 0,
                          (own->mode & tp_modes_closed(1)) != 0};
  if (normals[0] < 0 && normals[1] < 0) return false;
  if (parts_by_slip(own, s->groups->resting, k)) {
    *own = (tp_trial_mode){.mode = TP_MODES_OPEN};
    return true;
  }
  if (s->shear_at[k] >= 0) {
    const sign found = sign_of_reserve(s, k);
    if (found == SIGN_HOLDS) return false;
    const bool back = arf_sgn(arb_midref(force(s, s->shear_at[k]))) > 0;
    own->spent = found == SIGN_FAILS ? 0 : back ? -1 : 1;
    if (found == SIGN_FAILS) set_mode(own, closed, back ? TP_MODE_BACK : TP_MODE_FORWARD);
    return true;
  }
  if (own->spent != 0) return false;
  const bool back = (own->mode & TP_MODES_BACK) != 0;
  const sign found = sign_of_velocity(s, k, 0, true, back);
  if (found == SIGN_HOLDS) return false;
  own->spent = found == SIGN_FAILS ? 0 : back ? -1 : 1;
  set_mode(own, closed, TP_MODE_STICKS);
  return true;
}

static bool moves(const tp_mode_equations *s) {
  for (long f = 0; f < s->groups->freedom; f++) {
    if (!arb_contains_zero(force(s, f))) return true;
  }
  return false;
}

tp_laws tp_mode_laws(tp_trial_mode *trial, const tp_mode_equations *s) {
  enum { MOST = 8 };
  long changes = 0;
  for (long k = 0; k < s->groups->resting->contact_count; k++) {
    if (change_ends(trial + k, s, k) || change_slip(trial + k, s, k)) changes++;
  }
  if (changes > MOST) return TP_LAWS_BROKEN;
  if (changes > 0) return TP_LAWS_CHANGED;
  return moves(s) ? TP_LAWS_HOLD : TP_LAWS_BROKEN;
}
