/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moment equilibrium about every candidate pivot (docs/mechanics.md section 3; Eqs. (2), (A1.3),
 * (A1.7)).
 */

#include "evaluation/loaded.h"
#include "evaluation/pivot_list.h"
#include "evaluation/stages.h"
#include "problem/bearing.h"

#include "number/ball.h"
#include "plane/contact_rows.h"

/* The critical angle under loads, with its direction for what compares angles by it. */
static void loaded_angle(const tp_evaluation *e, long k, tp_direction_ball *angle, tp_roots *roots,
                         tp_certainty *certainty) {
  tp_loaded_critical(angle->degrees, roots, e->loaded, e, k, certainty);
  tp_ball_sin_cos(angle->sine, angle->cosine, angle->degrees, e->rung.bits);
  angle->exact_direction = false;
}

/* Lever arms of the weight about the k-th contact point, times 3 A2 > 0: the direction of the
 * critical angle, atan2(x arm, y arm). Towards the right x is mirrored. */
void tp_evaluate_turning(const tp_evaluation *e, tp_direction towards, long k,
                         tp_direction_ball *angle, tp_certainty *certainty) {
  const long exact = tp_evaluation_bits(e);
  if (e->loaded != NULL) {
    tp_roots roots;
    tp_roots_init(&roots);
    loaded_angle(e, k, angle, &roots, certainty);
    tp_roots_clear(&roots);
    return;
  }
  const arb_struct *sums = e->moments.weighted;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_evaluation_axis(x, y, e, k);
  arb_mul(angle->sine, sums + TP_A2, x, exact);
  arb_mul_ui(angle->sine, angle->sine, 3, exact);
  arb_sub(angle->sine, sums + TP_X6, angle->sine, exact);
  tp_ball_mirror(angle->sine, towards);
  arb_mul(angle->cosine, sums + TP_A2, y, exact);
  arb_mul_ui(angle->cosine, angle->cosine, 3, exact);
  arb_sub(angle->cosine, sums + TP_Y6, angle->cosine, exact);
  arb_clear(x);
  arb_clear(y);
  tp_ball_atan2_degrees(angle->degrees, angle->sine, angle->cosine, e->rung.bits);
  angle->exact_direction = true;
}

/* x arm cot(alpha) / y arm, Eq. (2). Nothing overturns where the centroid is not above the pivot,
 * or on level ground; a weight past the pivot has no factor then. */
static tp_fos resultant_form(const tp_evaluation *e, const tp_direction_ball *angle,
                             tp_certainty *certainty) {
  if (!e->problem->scene->tilt_angle_deg.given) return (tp_fos){.state = TP_FOS_NO_TILT};
  if (arb_is_zero(e->tilt_sine) || arb_is_nonpositive(angle->cosine)) {
    const bool past = arb_is_negative(angle->sine);
    return (tp_fos){.state = past ? TP_FOS_UNDEFINED : TP_FOS_NO_OVERTURNING};
  }
  tp_fos fos = {.state = TP_FOS_NUMBER};
  arb_t value, divisor;
  arb_init(value);
  arb_init(divisor);
  arb_mul(value, angle->sine, e->tilt_cosine, e->rung.bits);
  arb_mul(divisor, angle->cosine, e->tilt_sine, e->rung.bits);
  arb_div(value, value, divisor, e->rung.bits);
  fos.value = tp_result(e, value, certainty);
  arb_clear(value);
  arb_clear(divisor);
  return fos;
}

/* normal * cosine + parallel * sine with exact moments. */
static void combine(arb_t sum, const fmpz_t normal, const fmpz_t parallel, const arb_t sine,
                    const arb_t cosine, long bits) {
  arb_mul_fmpz(sum, cosine, normal, bits);
  arb_addmul_fmpz(sum, sine, parallel, bits);
}

/* Each element's components with the stabilising or the overturning moments by their own sign,
 * (A1.3): the normal component W cos(alpha) stabilises beyond the pivot, the parallel one
 * W sin(alpha) overturns above it. */
static tp_fos elements_form(const tp_evaluation *e, tp_direction towards, long point,
                            tp_certainty *certainty) {
  const tp_problem *problem = e->problem;
  if (!problem->scene->tilt_angle_deg.given) return (tp_fos){.state = TP_FOS_NO_TILT};
  if (!problem->has_elements) return (tp_fos){.state = TP_FOS_NOT_ASKED};
  fmpz m[4]; /* beyond and before along x, above and below along y */
  for (int k = 0; k < 4; k++) fmpz_init(m + k);
  const tp_elements *elements = &problem->elements;
  tp_elements_moments(m, m + 1, elements, &elements->along_x, problem->lattice.x + point);
  tp_elements_moments(m + 2, m + 3, elements, &elements->along_y, problem->lattice.y + point);
  if (towards == TP_TOWARDS_RIGHT) fmpz_swap(m, m + 1);
  arb_t stabilising, overturning;
  arb_init(stabilising);
  arb_init(overturning);
  combine(stabilising, m, m + 3, e->tilt_sine, e->tilt_cosine, e->rung.bits);
  combine(overturning, m + 1, m + 2, e->tilt_sine, e->tilt_cosine, e->rung.bits);
  tp_fos fos = {.state = TP_FOS_NO_OVERTURNING};
  if (!arb_is_zero(overturning)) {
    fos.state = TP_FOS_NUMBER;
    arb_div(stabilising, stabilising, overturning, e->rung.bits);
    fos.value = tp_result(e, stabilising, certainty);
  }
  for (int k = 0; k < 4; k++) fmpz_clear(m + k);
  arb_clear(stabilising);
  arb_clear(overturning);
  return fos;
}

/* From the least safe on. */
static int rank(tp_fos_state state) {
  return state == TP_FOS_NUMBER ? 0 : 1;
}

/* At the scene's tilt, of two contact points about which it begins to move at the same angle, or at
 * none. By the weight alone they have the same factor. */
static bool is_less_safe(const tp_evaluation *e, long k, long than, tp_certainty *certainty) {
  if (e->loaded == NULL || !e->problem->scene->tilt_angle_deg.given) return false;
  arb_t own, other;
  arb_init(own);
  arb_init(other);
  const tp_fos_state state = tp_loaded_factor(own, e->loaded, e, k, certainty);
  const tp_fos_state held = tp_loaded_factor(other, e->loaded, e, than, certainty);
  bool less = rank(state) < rank(held);
  if (state == TP_FOS_NUMBER && held == TP_FOS_NUMBER) {
    less = arb_lt(own, other);
    const bool open = arb_overlaps(own, other) && !(arb_is_exact(own) && arb_is_exact(other));
    const bool settled = tp_is_settled(e, own) && tp_is_settled(e, other);
    if (open && settled) tp_certainty_take_zero(certainty, e);
    if (open && !settled) certainty->open = true;
  }
  arb_clear(own);
  arb_clear(other);
  return less;
}

/* Loads may leave a pivot no critical angle. */
static bool has_angle(const tp_evaluation *e, const tp_direction_ball *angle) {
  return e->loaded == NULL ||
         !(arb_equal_si(angle->degrees, 180) || arb_equal_si(angle->degrees, -180));
}

tp_governing_pivot tp_evaluate_toppling(const tp_evaluation *e, tp_direction towards,
                                        tp_direction_ball *toppling, tp_certainty *certainty) {
  const tp_contact *contact = &e->problem->contact;
  tp_governing_pivot governing = {.found = false};
  tp_direction_ball angle;
  tp_direction_ball_init(&angle);
  for (long step = 0; step < contact->point_count; step++) {
    const long k = towards == TP_TOWARDS_LEFT ? step : contact->point_count - 1 - step;
    if (!e->problem->admissible[towards][k]) continue;
    tp_evaluate_turning(e, towards, k, &angle, certainty);
    const tp_angle_order order = governing.found
                                     ? tp_direction_ball_order(e, &angle, toppling, certainty)
                                     : (tp_angle_order){.sign = -1};
    if (order.sign > 0) continue;
    const bool governs = order.sign < 0 || is_less_safe(e, k, (long)governing.index, certainty);
    if (order.sign < 0) {
      governing.tie = false;
      governing.tie_bits = 0;
    } else if (has_angle(e, &angle)) {
      governing.tie = true;
      if (order.tie_bits > governing.tie_bits) governing.tie_bits = order.tie_bits;
    }
    if (!governs) continue;
    const tp_direction_ball held = *toppling;
    *toppling = angle;
    angle = held;
    governing.index = (size_t)k;
    governing.found = true;
  }
  tp_direction_ball_clear(&angle);
  return governing;
}

/* All numbers of one pivot; of the governing one by its angle, which is known, else NULL. */
static void evaluate_pivot(const tp_evaluation *e, tp_direction towards, tp_pivot *pivot, long k,
                           const tp_direction_ball *known, tp_certainty *certainty) {
  const tp_contact_point *point = e->problem->contact.points + k;
  tp_direction_ball angle;
  tp_direction_ball_init(&angle);
  pivot->rounded = point->cut != NULL;
  if (pivot->rounded) {
    tp_result_point(&pivot->x_m, &pivot->y_m, e, tp_contact_on_outline(point), certainty);
  }
  if (e->loaded != NULL) {
    tp_roots roots;
    tp_roots_init(&roots);
    loaded_angle(e, k, &angle, &roots, certainty);
    tp_loaded_pivot(pivot, e->loaded, e, k, angle.degrees, &roots, certainty);
    tp_roots_clear(&roots);
    pivot->critical_angle_deg = tp_result(e, angle.degrees, certainty);
  } else {
    if (known == NULL) tp_evaluate_turning(e, towards, k, &angle, certainty);
    const tp_direction_ball *own = known != NULL ? known : &angle;
    pivot->fos = resultant_form(e, own, certainty);
    pivot->fos_elements = elements_form(e, towards, point->point, certainty);
    pivot->critical_angle_deg = tp_result(e, own->degrees, certainty);
  }
  tp_direction_ball_clear(&angle);
}

/* Its numbers, unless they are settled. */
static void tell_pivot(const tp_evaluation *e, tp_direction towards, tp_pivot *pivot, bool *settled,
                       const tp_direction_ball *known, tp_certainty *certainty) {
  if (settled[pivot->index]) return;
  tp_certainty own = {0};
  pivot->computed = true;
  evaluate_pivot(e, towards, pivot, (long)pivot->index, known, &own);
  settled[pivot->index] = !own.open;
  tp_certainty_add(certainty, &own);
}

void tp_evaluate_pivots(const tp_evaluation *e, tp_case *result, bool *settled,
                        tp_direction_ball *toppling, tp_certainty *certainty) {
  const tp_direction towards = result->towards;
  const tp_governing_pivot governing = tp_evaluate_toppling(e, towards, toppling, certainty);
  for (size_t k = 0; k < result->pivot_count; k++) {
    tp_pivot *pivot = result->pivots + k;
    pivot->admissible = e->problem->admissible[towards][pivot->index];
    if (!tp_pivots_list_from_start(result, e->problem, e->pivots, pivot->index)) continue;
    const bool governs = governing.found && governing.index == pivot->index;
    tell_pivot(e, towards, pivot, settled, governs ? toppling : NULL, certainty);
  }
  result->has_toppling_pivot = governing.found;
  result->toppling_pivot = governing.found ? tp_pivots_place(result, governing.index) : 0;
  result->toppling_tie = governing.tie;
  result->toppling_tie_bits = governing.tie_bits;
}

bool tp_evaluate_bearing_pivots(const tp_evaluation *e, tp_case *result, bool *settled,
                                tp_certainty *certainty) {
  if (tp_pivots_list_all(e->pivots, result->candidate_count)) return true;
  if (!tp_pivots_list_more(result, e->problem)) return false;
  for (size_t k = 0; k < result->pivot_count; k++) {
    if (!tp_pivot_bears(result->pivots + k, &result->limit)) continue;
    tell_pivot(e, result->towards, result->pivots + k, settled, NULL, certainty);
  }
  return true;
}
