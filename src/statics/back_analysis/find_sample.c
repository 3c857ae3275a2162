/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names and values of the results that back-analysis can ask for, and the sample at one number: the
 * scene solved with it, and the gap to the wanted value with its sign where certain. */

#include "back_analysis/find_sample.h"

#include "back_analysis/find_system.h"
#include "common/grow.h"
#include "evaluation/case_numbers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool tp_search_value(tp_bounded *value, const tp_case *own, tp_find_target target) {
  const tp_pivot *pivot = own->has_toppling_pivot ? own->pivots + own->toppling_pivot : NULL;
  const bool slides = own->sliding.known && !own->sliding.never;
  const bool has_angle = slides && !own->sliding.always;
  switch (target) {
  case TP_FIND_CRITICAL_ANGLE:
    return tp_case_moments_deg(value, own) == TP_CASE_NUMBER;
  case TP_FIND_FOS:
    if (pivot != NULL) *value = pivot->fos.value;
    return pivot != NULL && pivot->fos.state == TP_FOS_NUMBER;
  case TP_FIND_SLIDING_ANGLE:
    if (has_angle) *value = own->sliding.critical_angle_deg;
    return has_angle;
  case TP_FIND_SLIDING_FOS:
    if (slides) *value = own->sliding.fos.value;
    return slides && own->sliding.fos.state == TP_FOS_NUMBER;
  case TP_FIND_LIMIT_ANGLE:
    return tp_case_limit_deg(value, own) == TP_CASE_NUMBER;
  case TP_FIND_ONSET_ANGLE:
    return tp_case_onset_deg(value, own) == TP_CASE_NUMBER;
  case TP_FIND_GOVERNING_FOS:
    return tp_case_fos(value, own) == TP_CASE_NUMBER;
  case TP_FIND_LIMIT_FOS:
    *value = own->limit.fos.value;
    return own->limit.fos.state == TP_FOS_NUMBER;
  case TP_FIND_FOS_GOODMAN_BRAY:
  case TP_FIND_ACCELERATION:
    break;
  }
  return false;
}

bool tp_find_target_is_factor(tp_find_target target) {
  return target == TP_FIND_FOS || target == TP_FIND_SLIDING_FOS || target == TP_FIND_LIMIT_FOS ||
         target == TP_FIND_GOVERNING_FOS || target == TP_FIND_FOS_GOODMAN_BRAY;
}

/* A factor that is no number, as nothing drives the block. */
static bool is_unbounded(const tp_case *own, tp_find_target target) {
  const tp_fos_state state = TP_FOS_NO_OVERTURNING;
  switch (target) {
  case TP_FIND_FOS:
    return own->has_toppling_pivot && own->pivots[own->toppling_pivot].fos.state == state;
  case TP_FIND_SLIDING_FOS:
    return own->sliding.known && !own->sliding.never && own->sliding.fos.state == state;
  case TP_FIND_LIMIT_FOS:
    return own->limit.fos.state == state;
  case TP_FIND_GOVERNING_FOS:
    return own->governing_fos.fos.state == state;
  case TP_FIND_CRITICAL_ANGLE:
  case TP_FIND_SLIDING_ANGLE:
  case TP_FIND_LIMIT_ANGLE:
  case TP_FIND_ONSET_ANGLE:
  case TP_FIND_FOS_GOODMAN_BRAY:
  case TP_FIND_ACCELERATION:
    break;
  }
  return false;
}

/* A number of digits as they are printed, or nothing. */
static void take_digits(char out[TP_SAMPLE_DIGITS], tp_bounded value) {
  out[0] = '\0';
  if (value.digits != NULL && strlen(value.digits) < TP_SAMPLE_DIGITS) strcpy(out, value.digits);
}

static void note_result(tp_found *found, tp_bounded value) {
  const bool first = found->least.value > found->greatest.value;
  if (first || value.value < found->least.value) found->least = value;
  if (first || value.value > found->greatest.value) found->greatest = value;
}

static void note_tried(tp_search *s, const tp_sample *at, bool unbounded) {
  static const tp_tried_standing by_side[] = {TP_TRIED_BELOW, TP_TRIED_NEAR, TP_TRIED_ABOVE};
  tp_tried *all = tp_grow(s->tried, s->tried_count, &s->tried_room, sizeof *all);
  if (all == NULL) {
    s->status = tp_fail_memory(s->message, "the points of the range");
    return;
  }
  s->tried = all;
  tp_tried_standing standing = unbounded ? TP_TRIED_ABOVE : TP_TRIED_NONE;
  if (at->known) standing = by_side[tp_search_side(at) + 1];
  if (at->is_bound && standing == TP_TRIED_ABOVE) standing = TP_TRIED_NEAR;
  all[s->tried_count++] = (tp_tried){.x = at->x, .standing = standing};
}

/* Of one block. */
static tp_status take_from_case(tp_sample *at, bool *unbounded, tp_search *s) {
  tp_solution *solution = NULL;
  const tp_status status = tp_varied_solve(&solution, &s->varied, &at->x, &s->why);
  if (status == TP_OK && solution->case_count > 0) {
    at->known = tp_search_value(&at->result, solution->cases, s->options->target);
    take_digits(at->digits, at->result);
    at->result.digits = NULL;
    *unbounded = !at->known && is_unbounded(solution->cases, s->options->target);
    at->governing = solution->cases[0].governing_fos.fos;
    at->governing.value.digits = NULL;
  }
  tp_solution_free(solution);
  return status;
}

/* Of many blocks up to where forces can hold them, though a motion may begin before? */
static bool is_of_forces(tp_find_target target) {
  return target == TP_FIND_LIMIT_FOS || target == TP_FIND_LIMIT_ANGLE ||
         target == TP_FIND_ACCELERATION;
}

/* Solve the scene with the number replaced. */
tp_sample tp_search_sample(tp_search *s, double x) {
  tp_sample at = {.x = x};
  bool unbounded = false;
  const tp_status status =
      s->of_many ? tp_search_take_system(&at, &unbounded, s) : take_from_case(&at, &unbounded, s);
  if (at.known) {
    note_result(s->found, at.result);
    s->found->is_upper_bound =
        s->found->is_upper_bound || at.is_bound || (s->of_many && is_of_forces(s->options->target));
    at.gap = at.result;
    at.gap.value -= s->options->value;
    /* the difference is rounded once */
    at.gap.error += fabs(at.gap.value) * 0x1p-52;
  }
  if (status == TP_OUT_OF_MEMORY || status == TP_SYSTEM_FAILED || status == TP_DEPENDENCY_FAILED) {
    s->status = tp_fail(s->message, status, (tp_place){0}, "%s", s->why.text);
  }
  if (s->status == TP_OK) note_tried(s, &at, unbounded);
  return at;
}

int tp_search_side(const tp_sample *at) {
  if (at->gap.value > at->gap.error) return 1;
  return at->gap.value < -at->gap.error ? -1 : 0;
}

static tp_bounded between(double low, double high) {
  const double middle = low + (high - low) / 2;
  const double error = (high - low) / 2 + fabs(middle) * 0x1p-51; /* decimal text, and rounding */
  return (tp_bounded){.value = middle, .error = error};
}

/* A number between two to one of the lists of what is found. */
static void add_number(tp_search *s, tp_bounded **list, size_t *count, double low, double high) {
  tp_bounded *all = realloc(*list, (*count + 1) * sizeof *all);
  if (all == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  *list = all;
  all[(*count)++] = between(low, high);
}

void tp_search_add_solution(tp_search *s, double low, double high) {
  add_number(s, &s->found->solutions, &s->found->count, low, high);
}

void tp_search_add_touching(tp_search *s, double low, double high) {
  add_number(s, &s->found->touching, &s->found->touching_count, low, high);
}

void tp_search_add_interval(tp_search *s, const double from[2], const double to[2]) {
  tp_found *f = s->found;
  tp_found_interval *all = realloc(f->intervals, (f->interval_count + 1) * sizeof *all);
  if (all == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  f->intervals = all;
  all[f->interval_count++] =
      (tp_found_interval){.low = between(from[0], from[1]), .high = between(to[0], to[1])};
}
