/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rays and rows of each mode in symbols, oriented as in the numerical solution (motion/strata.h),
 * and the signs that keep the modes the same. */

#include "derive/onset_modes.h"

#include "common/grow.h"
#include "derive/field_work.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

static const char by_chance[] =
    "contacts lie on one line, or parallel, only at these values of the parameters; derive at "
    "values to one side";

static void clear_rows(tp_onset_mode *mode, const tp_field *field) {
  for (long k = 0; k < mode->row_count; k++) {
    tp_vector_formulas_clear(&mode->rows[k].row, field);
    tp_vector_clear(&mode->rows[k].at);
  }
  free(mode->rows);
}

void tp_onset_modes_clear(tp_onset_modes *m) {
  const tp_field *field = m->terms->field;
  for (long k = 0; k < m->count; k++) clear_rows(m->modes + k, field);
  free(m->modes);
  for (long k = 0; k < m->ray_count; k++) tp_vector_formulas_clear(m->rays + k, field);
  free(m->rays);
  tp_twists_clear(&m->twists);
  if (m->normals.order != NULL) tp_normals_clear(&m->normals);
}

/* Turned where it has the other sense than the ray at the values, whose lengths are others; false
 * where that does not tell. */
static bool orient(tp_vector_formulas *own, const tp_onset_modes *m, const tp_ray *ray) {
  const tp_onset_terms *t = m->terms;
  tp_vector at;
  arb_t dot;
  tp_vector_init(&at);
  arb_init(dot);
  tp_vector_formulas_evaluate(&at, own, t->values, t->field, t->bits);
  if (ray->axis >= 0) {
    arb_mul(dot, at.of, ray->twist.of, t->bits);
    arb_addmul(dot, at.of + 1, ray->twist.of + 1, t->bits);
  } else {
    arb_mul(dot, at.of + 2, ray->twist.of + 2, t->bits);
  }
  const bool told = !arb_contains_zero(dot);
  if (arb_is_negative(dot)) tp_symbol_reverse(own->of, t->field);
  tp_vector_clear(&at);
  arb_clear(dot);
  return told;
}

static bool turn_about(tp_vector_formulas *own, const tp_onset_modes *m, long site) {
  const tp_onset_terms *t = m->terms;
  for (long k = 0; k < t->cones.count; k++) {
    if (t->cones.points[k].site != site) continue;
    tp_symbol_turn(own->of, t->contacts.items[k].x, t->contacts.items[k].y, t->field);
    return true;
  }
  return false;
}

static bool slide_along(tp_vector_formulas *own, const tp_onset_modes *m, long axis) {
  const tp_onset_terms *t = m->terms;
  for (long k = 0; k < t->cones.count; k++) {
    if (m->normals.families[m->normals.family_of[k]].axis != axis) continue;
    fmpz_mpoly_q_set(own->of, t->contacts.items[k].tx, t->field->ring);
    fmpz_mpoly_q_set(own->of + 1, t->contacts.items[k].ty, t->field->ring);
    fmpz_mpoly_q_zero(own->of + 2, t->field->ring);
    return true;
  }
  return false;
}

/* Where two normal lines that it lies on meet. */
static bool turn_between(tp_vector_formulas *own, const tp_onset_modes *m, const tp_ray *ray) {
  const tp_onset_terms *t = m->terms;
  const tp_normals *n = &m->normals;
  tp_vector_formulas first, second;
  tp_vector_formulas_init(&first, t->field);
  tp_vector_formulas_init(&second, t->field);
  long family = -1;
  bool found = false;
  for (long k = 0; k < n->count && !found; k++) {
    const tp_normal *line = n->items + k;
    if (tp_normal_sign(n, line, &ray->twist, ray->near, ray->site) != 0) continue;
    if (family < 0) {
      tp_onset_terms_normal(&first, t, n->order[line->first]);
      family = line->family;
    } else if (n->families[family].axis != n->families[line->family].axis) {
      tp_onset_terms_normal(&second, t, n->order[line->first]);
      tp_symbol_cross(own->of, first.of, second.of, t->field);
      found = true;
    }
  }
  tp_vector_formulas_clear(&first, t->field);
  tp_vector_formulas_clear(&second, t->field);
  return found;
}

static const char *set_rays(tp_onset_modes *m, bool *failed) {
  m->rays = calloc((size_t)m->twists.ray_count + 1, sizeof *m->rays);
  if (m->rays == NULL) {
    *failed = true;
    return "";
  }
  for (; m->ray_count < m->twists.ray_count; m->ray_count++) {
    tp_vector_formulas_init(m->rays + m->ray_count, m->terms->field);
  }
  for (long k = 0; k < m->ray_count; k++) {
    const tp_ray *ray = m->twists.rays + k;
    tp_vector_formulas *own = m->rays + k;
    const bool found = ray->site >= 0   ? turn_about(own, m, ray->site)
                       : ray->axis >= 0 ? slide_along(own, m, ray->axis)
                                        : turn_between(own, m, ray);
    if (!found) return "the block rests on one line of contact, about which it turns anyhow";
    if (!orient(own, m, ray)) return by_chance;
  }
  return NULL;
}

static bool add_row(tp_onset_mode *own, const tp_onset_modes *m, tp_onset_row row) {
  tp_onset_row *more = realloc(own->rows, (size_t)(own->row_count + 1) * sizeof *more);
  if (more == NULL) return false;
  own->rows = more;
  own->rows[own->row_count] = row;
  tp_vector_formulas_init(&own->rows[own->row_count].row, m->terms->field);
  tp_vector_init(&own->rows[own->row_count++].at);
  return true;
}

/* All that slide along one direction, of which the mode has but the two farthest apart. */
static bool add_sliding(tp_onset_mode *own, const tp_onset_modes *m, const tp_mode *mode) {
  const tp_ray *ray = m->twists.rays + mode->rays[0];
  if (mode->ray_count != 1 || ray->axis < 0 || mode->edge_count == 0) return true;
  const tp_normals *n = &m->normals;
  const long family = n->family_of[mode->edges[0].point];
  for (long k = 0; k < m->terms->cones.count; k++) {
    bool known = n->family_of[k] != family || n->same[k] != k;
    for (long e = 0; e < mode->edge_count; e++) known = known || mode->edges[e].point == k;
    if (known) continue;
    if (!add_row(own, m, (tp_onset_row){.point = k, .against = mode->edges[0].against}))
      return false;
  }
  return true;
}

static tp_motion_outcome add_mode(void *context, const tp_mode *mode) {
  tp_onset_modes *m = context;
  tp_onset_mode *more = tp_grow(m->modes, m->count, &m->room, sizeof *more);
  if (more == NULL) return TP_MOTION_OUT_OF_MEMORY;
  m->modes = more;
  tp_onset_mode *own = m->modes + m->count++;
  *own = (tp_onset_mode){.leaves = mode->ray_count == 0};
  bool done = true;
  for (int k = 0; k < mode->ray_count && done; k++) {
    done = add_row(own, m, (tp_onset_row){.is_ray = true, .ray = mode->rays[k]});
  }
  for (long k = 0; k < mode->edge_count && done; k++) {
    done = add_row(
        own, m, (tp_onset_row){.point = mode->edges[k].point, .against = mode->edges[k].against});
  }
  own->spanning = own->row_count;
  return done && add_sliding(own, m, mode) ? TP_MOTION_PROVEN : TP_MOTION_OUT_OF_MEMORY;
}

static void set_rows(tp_onset_modes *m) {
  const tp_onset_terms *t = m->terms;
  for (long k = 0; k < m->count; k++) {
    for (long r = 0; r < m->modes[k].row_count; r++) {
      tp_onset_row *row = m->modes[k].rows + r;
      if (row->is_ray) {
        tp_onset_terms_inertia(&row->row, t, m->rays + row->ray);
      } else {
        tp_onset_terms_force(&row->row, t, row->point, row->against);
      }
      tp_vector_formulas_evaluate(&row->at, &row->row, t->values, t->field, t->bits);
    }
  }
}

static const char *find_modes(tp_onset_modes *m, bool *failed) {
  const tp_judge judge = {.bits = m->terms->bits, .precision = ARF_PREC_EXACT, .settled = true};
  tp_motion_outcome done = tp_normals_init(&m->normals, &m->terms->cones, &judge);
  if (done == TP_MOTION_PROVEN) done = tp_twists_init(&m->twists, &m->normals, NULL);
  if (done == TP_MOTION_PROVEN) {
    m->base_rays = m->twists.ray_count;
    done = tp_strata_visit(&m->twists, &m->normals, false, add_mode, m);
  }
  if (done == TP_MOTION_OUT_OF_MEMORY) *failed = true;
  if (done != TP_MOTION_PROVEN) return "the motions are undecided at these values";
  const char *reason = set_rays(m, failed);
  if (reason == NULL) set_rows(m);
  return reason;
}

const char *tp_onset_modes_init(tp_onset_modes *m, const tp_onset_terms *terms, bool *failed) {
  memset(m, 0, sizeof *m);
  m->terms = terms;
  const char *reason = find_modes(m, failed);
  if (reason != NULL) tp_onset_modes_clear(m);
  return reason;
}

/* The sign of v . r stays, and nothing stays nothing. */
static int keep_sign(tp_conditions *conditions, const tp_onset_modes *m,
                     const tp_vector_formulas *v, long ray) {
  fmpz_mpoly_q_t value;
  fmpz_mpoly_q_init(value, m->terms->field->ring);
  tp_symbol_set_dot(value, v->of, m->rays[ray].of, m->terms->field);
  const int sign = tp_onset_terms_sign(m->terms, value);
  if (sign != TP_SIGN_BY_CHANCE) tp_conditions_add(conditions, value);
  fmpz_mpoly_q_clear(value, m->terms->field->ring);
  return sign;
}

/* Does the ray turn about a point on a face, that of the point's normal line? */
static bool is_on_face(const tp_onset_modes *m, long ray, long point) {
  const tp_normals *n = &m->normals;
  return tp_normal_has_site(n, n->items + n->normal_of[point], m->twists.rays[ray].site);
}

/* Which points stay closed along each ray of K, and how they slip; on a face, how they do about
 * each point that sticks there. */
const char *tp_onset_modes_conditions(tp_conditions *conditions, const tp_onset_modes *m) {
  const tp_onset_terms *t = m->terms;
  tp_vector_formulas own;
  tp_vector_formulas_init(&own, t->field);
  const char *reason = NULL;
  for (long p = 0; p < t->cones.count && reason == NULL; p++) {
    for (long r = 0; r < m->ray_count && reason == NULL; r++) {
      int sign = 0;
      if (r < m->base_rays) {
        tp_onset_terms_normal(&own, t, p);
        sign = keep_sign(conditions, m, &own, r);
      } else if (!is_on_face(m, r, p)) {
        continue;
      }
      if (sign == 0) {
        tp_onset_terms_slip(&own, t, p);
        sign = keep_sign(conditions, m, &own, r);
      }
      if (sign == TP_SIGN_BY_CHANCE) reason = by_chance;
    }
  }
  tp_vector_formulas_clear(&own, t->field);
  return reason;
}

void tp_onset_rows_determinant(fmpz_mpoly_q_t value, const tp_onset_modes *m, const tp_onset_row *a,
                               const tp_onset_row *b, const tp_onset_row *c) {
  tp_vector_formulas cross;
  tp_vector_formulas_init(&cross, m->terms->field);
  tp_symbol_cross(cross.of, a->row.of, b->row.of, m->terms->field);
  tp_symbol_set_dot(value, cross.of, c->row.of, m->terms->field);
  tp_vector_formulas_clear(&cross, m->terms->field);
}

int tp_onset_rows_sign(const tp_onset_modes *m, const tp_onset_row *a, const tp_onset_row *b,
                       const tp_onset_row *c) {
  tp_vector cross;
  arb_t ball;
  tp_vector_init(&cross);
  arb_init(ball);
  tp_vector_cross(&cross, &a->at, &b->at, m->terms->bits);
  tp_vector_dot(ball, &cross, &c->at, m->terms->bits);
  int sign = tp_ball_sign(ball);
  tp_vector_clear(&cross);
  arb_clear(ball);
  if (sign != 0) return sign;
  fmpz_mpoly_q_t value;
  fmpz_mpoly_q_init(value, m->terms->field->ring);
  tp_onset_rows_determinant(value, m, a, b, c);
  sign = tp_onset_terms_sign(m->terms, value);
  fmpz_mpoly_q_clear(value, m->terms->field->ring);
  return sign;
}
