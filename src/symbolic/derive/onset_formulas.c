/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Finds the plane of the first motion among those of all modes, its tangent, and the conditions
 * listed in the header, with reasons where there is no single formula. */

#include "derive/onset_formulas.h"

#include "derive/contact_conditions.h"
#include "derive/field_work.h"
#include "derive/onset_exclusion.h"
#include "number/ball.h"

#include <string.h>

static const char two_begin[] =
    "at these values two motions begin at once, each with a different formula; derive at values "
    "to one side";
static const char single_tilt[] =
    "the motion begins by forces that are in balance at a single tilt; derive at other values";
static const char at_45_degrees[] =
    "the contact ends where the underside rises at just 45 degrees at these values, and elsewhere "
    "beside them; say where with 'between'";

/* Does the weight leave the plane upwards at the onset that was found? */
static bool is_at_onset(const tp_onset_plane *plane, const tp_onset_wanted *wanted, long bits) {
  if (!arb_is_positive(plane->slope)) return false;
  arb_t level, degrees, gap;
  arb_init(level);
  arb_init(degrees);
  arb_init(gap);
  arb_neg(level, plane->level);
  tp_ball_atan2_degrees(degrees, level, plane->slope, bits);
  arb_set_d(gap, wanted->degrees.value);
  arb_sub(gap, gap, degrees, bits);
  arb_set_d(level, wanted->degrees.error);
  arb_abs(gap, gap);
  const bool within = !arb_gt(gap, level);
  arb_clear(level);
  arb_clear(degrees);
  arb_clear(gap);
  return within;
}

/* W w at the onset, over cos. */
static void set_weight(tp_vector_formulas *w, const tp_onset_formulas *f) {
  const tp_onset_terms *t = &f->terms;
  tp_field_mul(w->of, t->weight.w, f->tangent, t->field);
  fmpz_mpoly_q_set(w->of + 1, t->weight.w, t->field->ring);
  tp_field_mul(w->of + 2, t->weight.y6, f->tangent, t->field);
  tp_field_sub(w->of + 2, t->weight.x6, w->of + 2, t->field);
  tp_symbol_reverse(w->of, t->field);
}

/* An entry of h that is something, moments first: they hold no radius of gyration. */
static int entry_of(const tp_vector_formulas *h, const tp_onset_terms *t) {
  static const int order[] = {2, 1, 0};
  for (int k = 0; k < 3; k++) {
    const int sign = tp_onset_terms_sign(t, h->of + order[k]);
    if (sign == 1 || sign == -1) return order[k];
  }
  return -1;
}

/* mu and nu with w = mu g_i + nu g_j: w x g_j = mu h, g_i x w = nu h. False where one is not above
 * zero. */
static bool set_shares(fmpz_mpoly_q_t shares[2], const tp_onset_formulas *f,
                       const tp_onset_plane *plane) {
  const tp_onset_terms *t = &f->terms;
  const tp_onset_row *rows = f->modes.modes[plane->mode].rows;
  tp_vector_formulas w, h, product;
  tp_vector_formulas_init(&w, t->field);
  tp_vector_formulas_init(&h, t->field);
  tp_vector_formulas_init(&product, t->field);
  set_weight(&w, f);
  tp_symbol_cross(h.of, rows[plane->i].row.of, rows[plane->j].row.of, t->field);
  const int entry = entry_of(&h, t);
  bool positive = entry >= 0;
  for (int k = 0; k < 2 && positive; k++) {
    if (k == 0) tp_symbol_cross(product.of, w.of, rows[plane->j].row.of, t->field);
    if (k == 1) tp_symbol_cross(product.of, rows[plane->i].row.of, w.of, t->field);
    tp_field_div(shares[k], product.of + entry, h.of + entry, t->field);
    positive = tp_onset_terms_sign(t, shares[k]) == 1;
  }
  tp_vector_formulas_clear(&w, t->field);
  tp_vector_formulas_clear(&h, t->field);
  tp_vector_formulas_clear(&product, t->field);
  return positive;
}

static void set_tangent(fmpz_mpoly_q_t tangent, const tp_onset_formulas *f,
                        const tp_onset_plane *plane) {
  const tp_field *field = f->terms.field;
  fmpz_mpoly_q_t slope;
  fmpz_mpoly_q_init(slope, field->ring);
  tp_onset_plane_work(slope, tangent, &f->planes, plane);
  if (fmpz_mpoly_q_is_zero(slope, field->ring)) { /* work that was refused */
    fmpz_mpoly_q_zero(tangent, field->ring);
  } else {
    tp_field_div(tangent, tangent, slope, field);
    fmpz_mpoly_q_neg(tangent, tangent, field->ring);
  }
  fmpz_mpoly_q_clear(slope, field->ring);
}

/* The plane by which the first motion begins; all that do must have one formula. */
static const char *find_plane(tp_onset_formulas *f, const tp_onset_wanted *wanted) {
  const tp_field *field = f->terms.field;
  fmpz_mpoly_q_t held, shares[2];
  fmpz_mpoly_q_init(held, field->ring);
  for (int k = 0; k < 2; k++) fmpz_mpoly_q_init(shares[k], field->ring);
  const char *reason = NULL;
  for (long k = 0; k < f->planes.count && reason == NULL; k++) {
    const tp_onset_plane *plane = f->planes.items + k;
    if (plane->flat || f->modes.modes[plane->mode].leaves) continue;
    if (!is_at_onset(plane, wanted, f->terms.bits)) continue;
    fmpz_mpoly_q_set(held, f->tangent, field->ring);
    set_tangent(f->tangent, f, plane);
    const bool same = f->begins != NULL && fmpz_mpoly_q_equal(held, f->tangent, field->ring);
    const bool begins = set_shares(shares, f, plane);
    if (begins && f->begins != NULL && !same) reason = two_begin;
    if (begins && (f->begins == NULL || plane->cost < f->begins->cost)) {
      f->begins = plane;
    } else {
      fmpz_mpoly_q_set(f->tangent, held, field->ring);
    }
  }
  if (reason == NULL && f->begins == NULL) reason = single_tilt;
  fmpz_mpoly_q_clear(held, field->ring);
  for (int k = 0; k < 2; k++) fmpz_mpoly_q_clear(shares[k], field->ring);
  return reason;
}

/* That it begins just beyond. */
static void add_beginning(tp_onset_formulas *f) {
  const tp_field *field = f->terms.field;
  fmpz_mpoly_q_t shares[2], slope, level;
  for (int k = 0; k < 2; k++) fmpz_mpoly_q_init(shares[k], field->ring);
  fmpz_mpoly_q_init(slope, field->ring);
  fmpz_mpoly_q_init(level, field->ring);
  if (set_shares(shares, f, f->begins)) {
    for (int k = 0; k < 2; k++) tp_conditions_add(&f->conditions, shares[k]);
  }
  tp_onset_plane_work(slope, level, &f->planes, f->begins);
  tp_conditions_add(&f->conditions, slope);
  tp_onset_plane_solid(&f->conditions, &f->planes, f->begins);
  for (int k = 0; k < 2; k++) fmpz_mpoly_q_clear(shares[k], field->ring);
  fmpz_mpoly_q_clear(slope, field->ring);
  fmpz_mpoly_q_clear(level, field->ring);
}

static const char *derive(tp_onset_formulas *f, const tp_onset_wanted *wanted) {
  const char *reason = find_plane(f, wanted);
  if (reason == NULL && !tp_contact_conditions(&f->conditions, wanted->model)) {
    reason = at_45_degrees;
  }
  if (reason == NULL) {
    add_beginning(f);
    reason = tp_onset_modes_conditions(&f->conditions, &f->modes);
  }
  return reason != NULL ? reason : tp_onset_exclude(&f->conditions, &f->planes, f->tangent);
}

const char *tp_onset_formulas_init(tp_onset_formulas *f, const tp_onset_wanted *wanted,
                                   bool *failed) {
  memset(f, 0, sizeof *f);
  const char *reason =
      tp_onset_terms_init(&f->terms, wanted->model, wanted->towards, wanted->friction, failed);
  if (reason != NULL) return reason;
  reason = tp_onset_modes_init(&f->modes, &f->terms, failed);
  if (reason != NULL) {
    tp_onset_terms_clear(&f->terms);
    return reason;
  }
  if (!tp_onset_planes_init(&f->planes, &f->modes)) *failed = true;
  fmpz_mpoly_q_init(f->tangent, f->terms.field->ring);
  f->conditions = (tp_conditions){.field = f->terms.field,
                                  .positive = wanted->positive,
                                  .at = f->terms.values,
                                  .bits = f->terms.bits};
  reason = *failed ? "" : derive(f, wanted);
  if (f->conditions.failed) *failed = true;
  if (reason == NULL) reason = tp_field_problem(f->terms.field);
  if (reason != NULL) tp_onset_formulas_clear(f);
  return reason;
}

void tp_onset_formulas_clear(tp_onset_formulas *f) {
  tp_conditions_clear(&f->conditions);
  fmpz_mpoly_q_clear(f->tangent, f->terms.field->ring);
  tp_onset_planes_clear(&f->planes);
  tp_onset_modes_clear(&f->modes);
  tp_onset_terms_clear(&f->terms);
}
