/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* For each mode that does not begin at the onset, one plane or two, or the work of the weight, that
 * keeps it from beginning below; their signs become conditions. */

#include "derive/onset_exclusion.h"

#include "derive/field_work.h"

static const char not_apart[] =
    "at these values another motion is about to begin below the onset; derive at values to one "
    "side";

/* What is at work: that of which no mode may begin below the tangent, and what it rests on. */
typedef struct exclusion {
  const tp_onset_terms *terms;
  const tp_onset_modes *modes;
  const tp_onset_planes *planes;
  const fmpz_mpoly_q_struct *tangent;
  tp_conditions *conditions;
} exclusion;

/* Does the plane keep its mode from beginning, level and at the onset? Then on what that rests. */
static bool add_one(const exclusion *f, const tp_onset_plane *plane) {
  const tp_field *field = f->terms->field;
  if (!arb_is_negative(plane->level)) return false;
  fmpz_mpoly_q_t slope, level, at_onset;
  fmpz_mpoly_q_init(slope, field->ring);
  fmpz_mpoly_q_init(level, field->ring);
  fmpz_mpoly_q_init(at_onset, field->ring);
  tp_onset_plane_work(slope, level, f->planes, plane);
  tp_field_mul(at_onset, slope, f->tangent, field);
  tp_field_add(at_onset, at_onset, level, field);
  const int sign = tp_onset_terms_sign(f->terms, at_onset);
  const bool keeps = sign == -1 || sign == 0;
  if (keeps) {
    tp_conditions_add(f->conditions, level);
    tp_conditions_add(f->conditions, at_onset);
    tp_onset_plane_conditions(f->conditions, f->planes, plane);
  }
  fmpz_mpoly_q_clear(slope, field->ring);
  fmpz_mpoly_q_clear(level, field->ring);
  fmpz_mpoly_q_clear(at_onset, field->ring);
  return keeps;
}

/* Of a plane that the weight passes upwards and one that it passes downwards: is the second passed
 * first? With slopes s, s' and levels l, l': s' l - s l' >= 0. */
static bool add_two(const exclusion *f, const tp_onset_plane *up, const tp_onset_plane *down) {
  const tp_field *field = f->terms->field;
  if (!arb_is_positive(up->slope) || !arb_is_negative(down->slope)) return false;
  fmpz_mpoly_q_t slopes[2], levels[2], gap;
  for (int k = 0; k < 2; k++) {
    fmpz_mpoly_q_init(slopes[k], field->ring);
    fmpz_mpoly_q_init(levels[k], field->ring);
  }
  fmpz_mpoly_q_init(gap, field->ring);
  tp_onset_plane_work(slopes[0], levels[0], f->planes, up);
  tp_onset_plane_work(slopes[1], levels[1], f->planes, down);
  tp_formulas_determinant(gap, slopes[1], slopes[0], levels[1], levels[0], field);
  const int sign = tp_onset_terms_sign(f->terms, gap);
  const bool keeps = sign == 1 || sign == 0;
  if (keeps) {
    tp_conditions_add(f->conditions, slopes[0]);
    tp_conditions_add(f->conditions, slopes[1]);
    tp_conditions_add(f->conditions, gap);
    tp_onset_plane_conditions(f->conditions, f->planes, up);
    tp_onset_plane_conditions(f->conditions, f->planes, down);
  }
  for (int k = 0; k < 2; k++) {
    fmpz_mpoly_q_clear(slopes[k], field->ring);
    fmpz_mpoly_q_clear(levels[k], field->ring);
  }
  fmpz_mpoly_q_clear(gap, field->ring);
  return keeps;
}

/* Is the work of the weight on the ray not above zero, level and at the onset? */
static bool add_work(const exclusion *f, long ray) {
  const tp_field *field = f->terms->field;
  fmpz_mpoly_q_t slope, level, at_onset;
  fmpz_mpoly_q_init(slope, field->ring);
  fmpz_mpoly_q_init(level, field->ring);
  fmpz_mpoly_q_init(at_onset, field->ring);
  tp_onset_terms_work(slope, level, f->terms, f->modes->rays[ray].of);
  tp_field_mul(at_onset, slope, f->tangent, field);
  tp_field_add(at_onset, at_onset, level, field);
  const int first = tp_onset_terms_sign(f->terms, level);
  const int last = tp_onset_terms_sign(f->terms, at_onset);
  const bool none = (first == -1 || first == 0) && (last == -1 || last == 0);
  if (none) {
    tp_conditions_add(f->conditions, level);
    tp_conditions_add(f->conditions, at_onset);
  }
  fmpz_mpoly_q_clear(slope, field->ring);
  fmpz_mpoly_q_clear(level, field->ring);
  fmpz_mpoly_q_clear(at_onset, field->ring);
  return none;
}

/* By energy: a . M a = a . w + sum of f . a, above zero, and friction takes some. */
static bool exclude_by_work(const exclusion *f, const tp_onset_mode *mode) {
  const long before = f->conditions->count;
  const long count = mode->leaves ? f->modes->base_rays : mode->row_count;
  bool none = count > 0;
  for (long k = 0; k < count && none; k++) {
    if (mode->leaves || mode->rows[k].is_ray) {
      none = add_work(f, mode->leaves ? k : mode->rows[k].ray);
    }
  }
  if (!none) tp_conditions_forget(f->conditions, before);
  return none;
}

/* Planes that do, of which that with the shortest conditions is taken: each costs products. */
enum { TRIALS = 8 };

/* By one plane: of the first few that do, the one that asks least that is new. */
static bool exclude_by_one(const exclusion *f, long first, long end) {
  tp_conditions *c = f->conditions;
  const long before = c->count;
  long best = -1, least = 0;
  for (long k = first, trials = 0; k < end && trials < TRIALS && (best < 0 || least > 0); k++) {
    if (!add_one(f, f->planes->items + k)) continue;
    const long length = tp_conditions_length(c, before);
    if (best < 0 || length < least) {
      best = k;
      least = length;
    }
    trials++;
    tp_conditions_forget(c, before);
  }
  return best >= 0 && add_one(f, f->planes->items + best);
}

static bool exclude_by_two(const exclusion *f, long first, long end) {
  for (long i = first; i < end; i++) {
    for (long j = first; j < end; j++) {
      if (i != j && add_two(f, f->planes->items + i, f->planes->items + j)) return true;
    }
  }
  return false;
}

const char *tp_onset_exclude(tp_conditions *conditions, const tp_onset_planes *planes,
                             const fmpz_mpoly_q_t tangent) {
  const exclusion all = {planes->modes->terms, planes->modes, planes, tangent, conditions};
  const exclusion *f = &all;
  long first = 0;
  for (long mode = 0; mode < f->modes->count; mode++) {
    long end = first;
    while (end < f->planes->count && f->planes->items[end].mode == mode) end++;
    if (!exclude_by_work(f, f->modes->modes + mode) && !exclude_by_one(f, first, end) &&
        !exclude_by_two(f, first, end)) {
      return not_apart;
    }
    first = end;
  }
  return NULL;
}
