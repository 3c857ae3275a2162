/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Searches and proofs together. A factor is bisected by searches alone; then it is proven a little
 * to either side, as near as proofs go. */

#include "solid_contacts/hold.h"

#include "solid_contacts/squeezed.h"

#include <math.h>
#include <stdlib.h>

bool tp_hold_init(tp_hold *hold, const tp_friction_cones *cones, double friction) {
  static const double none[3] = {0};
  tp_hold_answer answer = {.forces = NULL};
  *hold = (tp_hold){.cones = cones, .friction = friction};
  hold->share =
      friction == 1 ? (tp_near){1, 0} : tp_near_div((tp_near){1, 0}, (tp_near){friction, 0});
  hold->deep.forces = calloc((size_t)cones->count + 1, sizeof *hold->deep.forces);
  hold->found.forces = calloc((size_t)cones->count + 1, sizeof *hold->found.forces);
  if (hold->deep.forces == NULL || hold->found.forces == NULL) return false;
  if (!tp_hold_search_init(&hold->search, cones, hold->share.value, 0)) return false;
  tp_hold_basis_choose(&hold->basis, cones);
  if (!tp_hold_find(&answer, &hold->search, TP_HOLD_APART, none, none)) return false;
  hold->has_apart = answer.outcome == TP_HOLD_FOUND;
  for (int r = 0; r < TP_WRENCH; r++) hold->apart[r] = answer.twist[r];
  return true;
}

void tp_hold_clear(tp_hold *hold) {
  tp_hold_search_clear(&hold->search);
  free(hold->deep.forces);
  free(hold->found.forces);
  *hold = (tp_hold){.cones = NULL};
}

static void copy_forces(tp_held *to, const tp_held *from, long count) {
  to->t = from->t;
  for (long k = 0; k < 3 * count; k++) to->forces[k / 3][k % 3] = from->forces[k / 3][k % 3];
}

/* Forces deep within their cones that hold a load, into `deep`. */
static bool find_deep(tp_hold_answer *answer, tp_hold *hold, const tp_hold_load *load) {
  static const double none[3] = {0};
  *answer = (tp_hold_answer){.forces = hold->deep.forces};
  hold->deep.t = 0;
  return tp_hold_find(answer, &hold->search, TP_HOLD_DEEPEST, load->nearest, none);
}

/* Forces that were found for other loads come close to each other, and a load can be along some of
 * those that a search begins with, so that programs are degenerate: what is open is asked again,
 * with other forces to begin with. */
enum { TRIES = 3 };

static bool begin_anew(tp_hold *hold, int number) {
  static const double turn = 0.29; /* of a turn between neighbours of 0.785, no simple part */
  tp_hold_search_clear(&hold->search);
  return tp_hold_search_init(&hold->search, hold->cones, hold->share.value, turn * number);
}

static bool find_side(tp_hold_side *side, double twist[TP_WRENCH], tp_hold *hold,
                      const tp_hold_load *load) {
  tp_hold_answer answer;
  *side = TP_HOLD_OPEN;
  if (!find_deep(&answer, hold, load)) return false;
  if (answer.outcome == TP_HOLD_FOUND) {
    bool proven = false;
    copy_forces(&hold->found, &hold->deep, hold->cones->count);
    hold->found.t = hold->deep.t = answer.t;
    if (!tp_hold_prove_forces(&proven, &hold->found, &hold->deep, hold->cones, &hold->basis,
                              hold->share, load, NULL)) {
      return false;
    }
    if (proven) *side = TP_HOLD_HOLDS;
  } else if (answer.outcome == TP_HOLD_NONE && hold->has_apart) {
    for (int r = 0; r < TP_WRENCH; r++) twist[r] = answer.twist[r];
    if (tp_hold_prove_motion(twist, hold->apart, hold->cones, hold->share) &&
        tp_near_sign(tp_hold_gain(twist, load)) > 0) {
      *side = TP_HOLD_MOVES;
    }
  }
  return true;
}

bool tp_hold_load_side(tp_hold_side *side, double twist[TP_WRENCH], tp_hold *hold,
                       const tp_hold_load *load) {
  if (!find_side(side, twist, hold, load)) return false;
  for (int k = 0; k < TRIES && *side == TP_HOLD_OPEN; k++) {
    if (!begin_anew(hold, k) || !find_side(side, twist, hold, load)) return false;
  }
  return true;
}

/* ---- the limit ---------------------------------------------------------------------------------
 */

/* The upper end: no more than what a motion gains on the load over what it does on the way. */
static tp_near upper_end(tp_hold_limit *limit, const tp_hold *hold, const tp_hold_load *load,
                         const tp_hold_load *way) {
  const tp_near nothing = {0, INFINITY};
  if (!hold->has_apart ||
      !tp_hold_prove_motion(limit->twist, hold->apart, hold->cones, hold->share)) {
    return nothing;
  }
  const tp_near on_way = tp_hold_gain(limit->twist, way);
  if (tp_near_sign(on_way) <= 0) return nothing;
  return tp_near_div(tp_near_neg(tp_hold_gain(limit->twist, load)), on_way);
}

static void set_between(tp_hold_limit *limit, double low, tp_near high) {
  const double end = high.value + high.error;
  if (!isfinite(end) || end < low) return;
  const double middle = low + (end - low) / 2;
  limit->t = tp_near_of(middle, (end - low) / 2 + fabs(middle) * DBL_EPSILON);
  limit->is_open = false;
}

/* Where all of the way is held, the way itself is, as a load. */
static bool is_endless(bool *endless, tp_hold *hold, const tp_hold_load *way) {
  tp_hold_side side;
  double twist[TP_WRENCH];
  if (!tp_hold_load_side(&side, twist, hold, way)) return false;
  *endless = side == TP_HOLD_HOLDS;
  return true;
}

/* Forces of many loads before make programs slow. */
static bool forget_forces(tp_hold *hold) {
  enum { MOST_OF_EACH = 30, MOST_BESIDE = 300 };
  if (hold->search.count <= MOST_OF_EACH * hold->cones->count + MOST_BESIDE) return true;
  return begin_anew(hold, 0);
}

static bool find_limit(tp_hold_limit *limit, tp_hold *hold, const tp_hold_load *load,
                       const tp_hold_load *way) {
  tp_hold_answer answer;
  bool proven = false;
  *limit = (tp_hold_limit){.is_open = true};
  if (!forget_forces(hold)) return false;
  if (!find_deep(&answer, hold, load)) return false;
  if (answer.outcome != TP_HOLD_FOUND) return true;
  answer.forces = hold->found.forces;
  if (!tp_hold_find(&answer, &hold->search, TP_HOLD_FARTHEST, load->nearest, way->nearest)) {
    return false;
  }
  if (answer.outcome == TP_HOLD_ENDLESS) {
    if (!is_endless(&limit->is_endless, hold, way)) return false;
    limit->is_open = !limit->is_endless;
    return true;
  }
  if (answer.outcome != TP_HOLD_FOUND) return true;
  hold->found.t = answer.t;
  for (int r = 0; r < TP_WRENCH; r++) limit->twist[r] = answer.twist[r];
  if (!tp_hold_prove_forces(&proven, &hold->found, &hold->deep, hold->cones, &hold->basis,
                            hold->share, load, way)) {
    return false;
  }
  if (proven) set_between(limit, hold->found.t, upper_end(limit, hold, load, way));
  return true;
}

/* Do forces strictly within all cones hold a load? In those of a little less friction. */
static bool is_inside(bool *inside, tp_hold *hold, const tp_hold_load *load) {
  static const tp_near little_less = {1 - 0x1p-30, 0};
  tp_hold_answer answer;
  *inside = false;
  if (!find_deep(&answer, hold, load)) return false;
  if (answer.outcome != TP_HOLD_FOUND || !(answer.t > 0)) return true;
  copy_forces(&hold->found, &hold->deep, hold->cones->count);
  hold->found.t = hold->deep.t = answer.t;
  if (!tp_hold_prove_forces(inside, &hold->found, &hold->deep, hold->cones, &hold->basis,
                            little_less, load, NULL)) {
    return false;
  }
  for (long n = 0; n < hold->cones->count && *inside; n++) {
    const double *own = hold->found.forces[n];
    *inside = own[0] != 0 || own[1] != 0 || own[2] != 0;
  }
  return true;
}

/* What doubles leave open, in rational numbers. */
static bool find_squeezed(tp_hold_limit *limit, tp_hold *hold, const tp_hold_load *load,
                          const tp_hold_load *way) {
  bool inside;
  tp_squeezed_limit own;
  tp_squeezed_find(&own, hold->cones, load, way);
  if (!own.is_known) return true;
  if (!is_inside(&inside, hold, load)) return false;
  if (!inside) return true;
  *limit = (tp_hold_limit){.is_endless = own.is_endless, .t = own.t};
  for (int k = 0; k < TP_WRENCH; k++) limit->twist[k] = own.twist[k];
  return true;
}

bool tp_hold_limit_find(tp_hold_limit *limit, tp_hold *hold, const tp_hold_load *load,
                        const tp_hold_load *way) {
  if (!find_limit(limit, hold, load, way)) return false;
  for (int k = 0; k < TRIES && limit->is_open; k++) {
    if (!begin_anew(hold, k) || !find_limit(limit, hold, load, way)) return false;
  }
  return !limit->is_open || hold->friction != 1 || find_squeezed(limit, hold, load, way);
}

/* ---- the factor --------------------------------------------------------------------------------
 */

static bool side_with(tp_hold_side *side, double twist[TP_WRENCH], const tp_friction_cones *cones,
                      double factor, const tp_hold_load *load) {
  tp_hold hold;
  const bool done =
      tp_hold_init(&hold, cones, factor) && tp_hold_load_side(side, twist, &hold, load);
  tp_hold_clear(&hold);
  return done;
}

/* From one, by powers of two, to one that holds and one that does not. */
static bool enclose(tp_hold_factor_kind *kind, double ends[2], double twist[TP_WRENCH],
                    const tp_friction_cones *cones, const tp_hold_load *load) {
  enum { MOST = 20 };
  tp_hold_side first, side;
  if (!side_with(&first, twist, cones, 1, load)) return false;
  ends[0] = ends[1] = 1;
  *kind = TP_HOLD_FACTOR;
  if (first == TP_HOLD_OPEN) {
    ends[0] = 0.5;
    ends[1] = 2;
    return true;
  }
  for (int k = 0; k < MOST; k++) {
    double *own = first == TP_HOLD_HOLDS ? ends + 1 : ends;
    *own = first == TP_HOLD_HOLDS ? 2 * *own : *own / 2;
    if (!side_with(&side, twist, cones, *own, load)) return false;
    if (side != first) return true;
    ends[first == TP_HOLD_HOLDS ? 0 : 1] = *own;
  }
  *kind = first == TP_HOLD_HOLDS ? TP_HOLD_FREE : TP_HOLD_POWERLESS;
  return true;
}

/* Proven as near to a factor as it goes: which holds, and which does not. */
static bool prove_ends(tp_hold_factor_kind *kind, double ends[2], double twist[TP_WRENCH],
                       const tp_friction_cones *cones, const tp_hold_load *load) {
  enum { NEAREST = 33, FARTHEST = 20, STEP = 3 };
  const double middle = ends[0] + (ends[1] - ends[0]) / 2;
  for (int end = 0; end < 2; end++) {
    const tp_hold_side wanted = end == 0 ? TP_HOLD_HOLDS : TP_HOLD_MOVES;
    tp_hold_side side = TP_HOLD_OPEN;
    for (int bits = NEAREST; bits >= FARTHEST && side != wanted; bits -= STEP) {
      ends[end] = middle * (1 + (end == 0 ? -1 : 1) * ldexp(1, -bits));
      if (!side_with(&side, twist, cones, ends[end], load)) return false;
    }
    if (side != wanted) *kind = TP_HOLD_FACTOR_OPEN;
  }
  return true;
}

bool tp_hold_factor(tp_hold_factor_kind *kind, tp_near *factor, double twist[TP_WRENCH],
                    const tp_friction_cones *cones, const tp_hold_load *load) {
  static const double close = 1e-11;
  double ends[2];
  if (!enclose(kind, ends, twist, cones, load)) return false;
  if (*kind != TP_HOLD_FACTOR) return true;
  while (ends[1] - ends[0] > close * ends[1]) {
    const double middle = ends[0] + (ends[1] - ends[0]) / 2;
    tp_hold_side side;
    if (!side_with(&side, twist, cones, middle, load)) return false;
    if (side == TP_HOLD_OPEN) {
      ends[0] = ends[1] = middle;
    } else {
      ends[side == TP_HOLD_HOLDS ? 0 : 1] = middle;
    }
  }
  if (!prove_ends(kind, ends, twist, cones, load)) return false;
  *factor = tp_near_of(ends[0] + (ends[1] - ends[0]) / 2,
                       (ends[1] - ends[0]) / 2 + ends[1] * DBL_EPSILON);
  return true;
}
