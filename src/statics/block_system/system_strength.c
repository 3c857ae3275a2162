/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The margin between the angle at which the blocks lie and the limit with less strength falls with
 * the divisor: its zero is searched in doubles, and then proven on both sides, at a distance that
 * grows until both proofs are there. */

#include "block_system/system_strength.h"

#include "number/root.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Limits to both sides with one divisor. */
typedef struct both {
  tp_load_bracket side, other;
} both;

typedef struct searching {
  const tp_built_system *s;
  bool towards_left;
  tp_near tangent;
  bool sees_other; /* the limit to the other side takes part */
  tp_status status;
  tp_message *message;
} searching;

static void clear_both(both *b) {
  tp_load_bracket_clear(&b->side);
  tp_load_bracket_clear(&b->other);
}

static tp_status find_both(both *b, const searching *x, double divisor) {
  memset(b, 0, sizeof *b);
  tp_status status = tp_built_system_bracket(&b->side, x->s, x->towards_left, divisor, x->message);
  if (status == TP_OK) {
    status = tp_built_system_bracket(&b->other, x->s, !x->towards_left, divisor, x->message);
  }
  if (status != TP_OK) clear_both(b);
  return status;
}

/* Forces that hold one load and forces that hold one the other way hold, mixed, all between. */
static bool holds(const both *b, tp_near tangent) {
  return b->side.is_held && b->other.is_held && b->side.held >= tangent.value + tangent.error &&
         b->other.held >= -(tangent.value - tangent.error);
}

static bool exceeds(const tp_load_bracket *b, tp_near tangent) {
  return b->is_bounded && b->bound < tangent.value - tangent.error;
}

static bool fails(const both *b, tp_near tangent) {
  return exceeds(&b->side, tangent) || exceeds(&b->other, tp_near_neg(tangent));
}

/* An angle near the limit. */
static double angle_of(const tp_load_bracket *b) {
  return atan(b->is_bounded ? b->bound : b->is_held ? b->held : -INFINITY);
}

/* By the logarithm of the divisor. */
static bool margin(double *value, void *context, double x_log) {
  searching *x = context;
  tp_load_bracket bracket;
  x->status = tp_built_system_bracket(&bracket, x->s, x->towards_left, exp(x_log), x->message);
  if (x->status != TP_OK) return false;
  *value = angle_of(&bracket) - atan(x->tangent.value);
  tp_load_bracket_clear(&bracket);
  if (!x->sees_other) return true;
  x->status = tp_built_system_bracket(&bracket, x->s, !x->towards_left, exp(x_log), x->message);
  if (x->status != TP_OK) return false;
  *value = fmin(*value, angle_of(&bracket) + atan(x->tangent.value));
  tp_load_bracket_clear(&bracket);
  return true;
}

/* By factors of two from 1 on to a divisor at which the margin has the other sign. */
static bool bracket_factor(tp_root_end *low, tp_root_end *high, searching *x) {
  static const double most = TP_MOST_STRENGTH_FACTOR;
  tp_root_end end = {0, 0};
  if (!margin(&end.value, x, 0)) return false;
  *low = *high = end;
  const double step = end.value >= 0 ? log(2) : -log(2);
  while (fabs(end.x) < log(most)) {
    end.x = fmax(-log(most), fmin(log(most), end.x + step));
    if (!margin(&end.value, x, end.x)) return false;
    *(step > 0 ? high : low) = end;
    if ((end.value >= 0) != (step > 0)) return true;
    *(step > 0 ? low : high) = end;
  }
  return false;
}

/* The collapse is the one to the side whose limit is exceeded. */
static void keep_collapse(tp_system_strength *strength, both *b, tp_near tangent) {
  tp_load_bracket *own = exceeds(&b->side, tangent) ? &b->side : &b->other;
  strength->collapse = *own;
  memset(own, 0, sizeof *own);
}

static tp_status prove(tp_system_strength *strength, searching *x, double factor) {
  static const double first = 2.5e-7, last = 1e-2, growth = 4;
  for (double away = first; away < last; away *= growth) {
    both b;
    if (!strength->is_held) {
      const double divisor = factor * (1 - away);
      x->status = find_both(&b, x, divisor);
      if (x->status != TP_OK) return x->status;
      strength->is_held = holds(&b, x->tangent);
      strength->held = divisor;
      clear_both(&b);
    }
    if (!strength->is_bounded) {
      const double divisor = factor * (1 + away);
      x->status = find_both(&b, x, divisor);
      if (x->status != TP_OK) return x->status;
      strength->is_bounded = fails(&b, x->tangent);
      strength->bound = divisor;
      if (strength->is_bounded) keep_collapse(strength, &b, x->tangent);
      clear_both(&b);
    }
    if (strength->is_held && strength->is_bounded) break;
  }
  return TP_OK;
}

/* No divisor up to the greatest was too much. */
static tp_status prove_least(tp_system_strength *strength, searching *x) {
  both b;
  const tp_status status = find_both(&b, x, TP_MOST_STRENGTH_FACTOR);
  if (status != TP_OK) return status;
  strength->is_held = holds(&b, x->tangent);
  strength->held = TP_MOST_STRENGTH_FACTOR;
  clear_both(&b);
  return TP_OK;
}

static tp_status search(tp_system_strength *strength, searching *x) {
  enum { MOST = 60 };
  static const double width = 1e-9, flat = 1e-9;
  const tp_root_search of = {margin, x, flat, width, MOST};
  tp_root_end low, high;
  tp_root root;
  if (!bracket_factor(&low, &high, x)) {
    return x->status != TP_OK || low.value < 0 ? x->status : prove_least(strength, x);
  }
  if (!tp_root_find(&root, &of, low, high)) return x->status;
  return prove(strength, x, exp(root.low + (root.high - root.low) / 2));
}

tp_status tp_system_strength_find(tp_system_strength *strength, const tp_built_system *s,
                                  bool towards_left, const tp_near *tangent, tp_message *message) {
  memset(strength, 0, sizeof *strength);
  searching x = {.s = s, .towards_left = towards_left, .tangent = *tangent, .message = message};
  tp_status status = search(strength, &x);
  if (status == TP_OK && !strength->is_held && !x.sees_other) {
    tp_system_strength_clear(strength);
    x.sees_other = true;
    status = search(strength, &x);
  }
  if (status != TP_OK) tp_system_strength_clear(strength);
  return status;
}

void tp_system_strength_clear(tp_system_strength *strength) {
  tp_load_bracket_clear(&strength->collapse);
  memset(strength, 0, sizeof *strength);
}
