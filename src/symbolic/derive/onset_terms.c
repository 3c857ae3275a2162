/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact normals, slips, forces, inertia and the work of the weight as rational functions, and the
 * sign of one at the scene's values. */

#include "derive/onset_terms.h"

#include "derive/derive_limit.h"
#include "derive/field_work.h"
#include "number/ball.h"
#include "number/ladder.h"
#include "stability/limit_cones.h"

#include <stdlib.h>
#include <string.h>

/* Signs at the values as the solver settles them; the modes of more points are too many to derive.
 */
enum { BITS = TP_SETTLING_BITS, MOST_POINTS = 400 };

static void set_sums(tp_onset_terms *t) {
  const tp_formulas *sums = &t->model->formulas;
  fmpz_t three;
  fmpz_init_set_ui(three, 3);
  fmpz_mpoly_q_init(t->weight, t->field->ring);
  fmpz_mpoly_q_init(t->x6, t->field->ring);
  fmpz_mpoly_q_init(t->y6, t->field->ring);
  fmpz_mpoly_q_init(t->polar12, t->field->ring);
  fmpz_mpoly_q_mul_fmpz(t->weight, sums->weighted2, three, t->field->ring);
  fmpz_mpoly_q_set(t->x6, sums->x6, t->field->ring);
  if (t->towards == TP_TOWARDS_RIGHT) fmpz_mpoly_q_neg(t->x6, t->x6, t->field->ring);
  fmpz_mpoly_q_set(t->y6, sums->y6, t->field->ring);
  tp_formulas_polar(t->polar12, &t->model->symbols, &t->model->problem.section);
  fmpz_clear(three);
}

/* Does t in symbols point where that of the cones does? */
static bool is_along(const tp_onset_terms *t, long point) {
  arb_t x, y, dot;
  arb_init(x);
  arb_init(y);
  arb_init(dot);
  tp_field_evaluate_ball(x, t->contacts[point].tx, t->values, t->field, t->bits);
  tp_field_evaluate_ball(y, t->contacts[point].ty, t->values, t->field, t->bits);
  arb_mul_fmpz(dot, x, t->cones.tx + point, t->bits);
  arb_addmul_fmpz(dot, y, t->cones.ty + point, t->bits);
  const bool same_sense = arb_is_positive(dot);
  arb_mul_fmpz(dot, x, t->cones.ty + point, t->bits);
  arb_submul_fmpz(dot, y, t->cones.tx + point, t->bits);
  const bool parallel = arb_contains_zero(dot);
  arb_clear(x);
  arb_clear(y);
  arb_clear(dot);
  return same_sense && parallel;
}

static const char *set_contacts(tp_onset_terms *t) {
  for (long k = 0; k < t->cones.count; k++) {
    tp_contact_formulas_init(t->contacts + k, t->field);
  }
  for (long k = 0; k < t->cones.count; k++) {
    const long facet = t->cones.points[k].facet;
    const bool right = k > 0 && t->cones.points[k - 1].facet == facet;
    if (!tp_contact_formulas_set(t->contacts + k, t->model, t->towards, (size_t)facet, right) ||
        !is_along(t, k)) {
      return "a contact lies on the base past the block, where it has no formula; give the base as "
             "a profile";
    }
  }
  return NULL;
}

const char *tp_onset_terms_init(tp_onset_terms *t, const tp_model *model, tp_direction towards,
                                long friction, bool *failed) {
  *t = (tp_onset_terms){.model = model,
                        .field = &model->symbols.field,
                        .towards = towards,
                        .friction = friction,
                        .bits = BITS};
  const tp_evaluation at_values = {
      .problem = &model->problem, .rung = {TP_LEVEL_EXACT, BITS}, .digits = 9};
  if (!tp_limit_cones_init(&t->cones, &at_values, towards, false)) {
    *failed = true;
    return "";
  }
  if (t->cones.count > MOST_POINTS) {
    tp_cones_clear(&t->cones);
    return "the contact has more than 400 points; derive with fewer teeth";
  }
  t->contacts = calloc((size_t)t->cones.count + 1, sizeof *t->contacts);
  if (t->contacts == NULL) {
    tp_cones_clear(&t->cones);
    *failed = true;
    return "";
  }
  t->values = _arb_vec_init(t->field->symbol_count);
  tp_derive_limit_values(t->values, model, friction, BITS);
  arb_set(t->cones.friction, t->values + friction);
  set_sums(t);
  const char *reason = set_contacts(t);
  if (reason != NULL) tp_onset_terms_clear(t);
  return reason;
}

void tp_onset_terms_clear(tp_onset_terms *t) {
  for (long k = 0; k < t->cones.count; k++) tp_contact_formulas_clear(t->contacts + k, t->field);
  free(t->contacts);
  _arb_vec_clear(t->values, t->field->symbol_count);
  fmpz_mpoly_q_clear(t->weight, t->field->ring);
  fmpz_mpoly_q_clear(t->x6, t->field->ring);
  fmpz_mpoly_q_clear(t->y6, t->field->ring);
  fmpz_mpoly_q_clear(t->polar12, t->field->ring);
  tp_cones_clear(&t->cones);
  memset(t, 0, sizeof *t);
}

/* (-t_y, t_x, t . q) */
void tp_onset_terms_normal(tp_vector_formulas *h, const tp_onset_terms *t, long point) {
  const tp_contact_formulas *c = t->contacts + point;
  fmpz_mpoly_q_t term;
  fmpz_mpoly_q_init(term, t->field->ring);
  fmpz_mpoly_q_neg(h->of[0], c->ty, t->field->ring);
  fmpz_mpoly_q_set(h->of[1], c->tx, t->field->ring);
  tp_field_mul(h->of[2], c->tx, c->x, t->field);
  tp_field_mul(term, c->ty, c->y, t->field);
  tp_field_add(h->of[2], h->of[2], term, t->field);
  fmpz_mpoly_q_clear(term, t->field->ring);
}

/* (t_x, t_y, t_y q_x - t_x q_y) */
void tp_onset_terms_slip(tp_vector_formulas *g, const tp_onset_terms *t, long point) {
  const tp_contact_formulas *c = t->contacts + point;
  fmpz_mpoly_q_set(g->of[0], c->tx, t->field->ring);
  fmpz_mpoly_q_set(g->of[1], c->ty, t->field->ring);
  tp_formulas_determinant(g->of[2], c->x, c->y, c->tx, c->ty, t->field);
}

void tp_onset_terms_force(tp_vector_formulas *force, const tp_onset_terms *t, long point,
                          bool against) {
  tp_force_formulas own;
  tp_force_formulas_init(&own, t->field);
  tp_force_formulas_at(&own, t->contacts + point, t->friction, !against, t->field);
  fmpz_mpoly_q_neg(force->of[0], own.x, t->field->ring);
  fmpz_mpoly_q_neg(force->of[1], own.y, t->field->ring);
  fmpz_mpoly_q_neg(force->of[2], own.moment, t->field->ring);
  tp_force_formulas_clear(&own, t->field);
}

void tp_onset_terms_inertia(tp_vector_formulas *own, const tp_onset_terms *t,
                            const tp_vector_formulas *twist) {
  const fmpz_mpoly_q_struct *vx = twist->of[0], *vy = twist->of[1], *turn = twist->of[2];
  fmpz_mpoly_q_t term;
  fmpz_t two;
  fmpz_mpoly_q_init(term, t->field->ring);
  fmpz_init_set_ui(two, 2);
  tp_formulas_determinant(own->of[0], t->weight, t->y6, turn, vx, t->field);
  tp_field_mul(own->of[1], t->weight, vy, t->field);
  tp_field_mul(term, t->x6, turn, t->field);
  tp_field_add(own->of[1], own->of[1], term, t->field);
  tp_formulas_determinant(own->of[2], t->x6, t->y6, vx, vy, t->field);
  for (int k = 0; k < 3; k++) fmpz_mpoly_q_mul_fmpz(own->of[k], own->of[k], two, t->field->ring);
  tp_field_mul(term, t->polar12, turn, t->field);
  tp_field_add(own->of[2], own->of[2], term, t->field);
  fmpz_mpoly_q_clear(term, t->field->ring);
  fmpz_clear(two);
}

/* -(W h_x - Y6 h_theta), -(W h_y + X6 h_theta) */
void tp_onset_terms_work(fmpz_mpoly_q_t slope, fmpz_mpoly_q_t level, const tp_onset_terms *t,
                         const tp_vector_formulas *h) {
  fmpz_mpoly_q_t term;
  fmpz_mpoly_q_init(term, t->field->ring);
  tp_formulas_determinant(slope, t->y6, t->weight, h->of[0], h->of[2], t->field);
  tp_field_mul(term, t->weight, h->of[1], t->field);
  tp_field_mul(level, t->x6, h->of[2], t->field);
  tp_field_add(level, level, term, t->field);
  fmpz_mpoly_q_neg(level, level, t->field->ring);
  fmpz_mpoly_q_clear(term, t->field->ring);
}

int tp_onset_terms_sign(const tp_onset_terms *t, const fmpz_mpoly_q_t value) {
  if (fmpz_mpoly_q_is_zero(value, t->field->ring)) return 0;
  arb_t ball;
  arb_init(ball);
  tp_field_evaluate_ball(ball, value, t->values, t->field, t->bits);
  const int sign = tp_ball_sign(ball);
  arb_clear(ball);
  return sign != 0 ? sign : TP_SIGN_BY_CHANCE;
}
