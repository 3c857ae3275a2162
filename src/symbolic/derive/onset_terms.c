/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact normals, slips, forces, inertia and the work of the weight as rational functions, and the
 * sign of one at the scene's values. */

#include "derive/onset_terms.h"

#include "derive/derive_limit.h"
#include "derive/field_work.h"
#include "number/ball.h"
#include "number/ladder.h"
#include "static_limit/limit_cones.h"

#include <stdlib.h>
#include <string.h>

/* Signs at the values as the solver settles them; the modes of more points are too many to derive.
 */
enum { BITS = TP_SETTLING_BITS, MOST_POINTS = 400 };

/* Does t in symbols point where that of the cones does? */
static bool is_along(const tp_onset_terms *t, long point) {
  arb_t x, y, dot;
  arb_init(x);
  arb_init(y);
  arb_init(dot);
  tp_field_evaluate_ball(x, t->contacts.items[point].tx, t->values, t->field, t->bits);
  tp_field_evaluate_ball(y, t->contacts.items[point].ty, t->values, t->field, t->bits);
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

static const char *set_contacts(const tp_onset_terms *t) {
  for (long k = 0; k < t->cones.count; k++) {
    if (!t->contacts.items[k].known || !is_along(t, k)) {
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
  if (!tp_contacts_formulas_init(&t->contacts, model, towards)) {
    tp_cones_clear(&t->cones);
    *failed = true;
    return "";
  }
  t->values = _arb_vec_init(t->field->symbol_count);
  tp_derive_limit_values(t->values, model, friction, BITS);
  arb_set(t->cones.friction, t->values + friction);
  tp_weight_formulas_init(&t->weight, model, towards);
  fmpz_mpoly_q_init(t->polar12, t->field->ring);
  tp_formulas_polar(t->polar12, &model->symbols, &model->problem.section);
  const char *reason = set_contacts(t);
  if (reason != NULL) tp_onset_terms_clear(t);
  return reason;
}

void tp_onset_terms_clear(tp_onset_terms *t) {
  tp_contacts_formulas_clear(&t->contacts, t->field);
  _arb_vec_clear(t->values, t->field->symbol_count);
  tp_weight_formulas_clear(&t->weight, t->field);
  fmpz_mpoly_q_clear(t->polar12, t->field->ring);
  tp_cones_clear(&t->cones);
  memset(t, 0, sizeof *t);
}

void tp_onset_terms_normal(tp_vector_formulas *h, const tp_onset_terms *t, long point) {
  const tp_contact_formulas *c = t->contacts.items + point;
  tp_symbol_normal_row(h->of, c->x, c->y, c->tx, c->ty, t->field);
}

void tp_onset_terms_slip(tp_vector_formulas *g, const tp_onset_terms *t, long point) {
  const tp_contact_formulas *c = t->contacts.items + point;
  tp_symbol_slip_row(g->of, c->x, c->y, c->tx, c->ty, t->field);
}

void tp_onset_terms_force(tp_vector_formulas *force, const tp_onset_terms *t, long point,
                          bool against) {
  tp_contact_formulas_edge(force, t->contacts.items + point, t->friction, against, t->field);
  tp_symbol_reverse(force->of, t->field);
}

/* About the centroid it would be as in numbers; the rest is what moving to the origin adds. */
void tp_onset_terms_inertia(tp_vector_formulas *own, const tp_onset_terms *t,
                            const tp_vector_formulas *twist) {
  const tp_weight_formulas *w = &t->weight;
  fmpz_mpoly_q_t moment;
  fmpz_t two;
  fmpz_mpoly_q_init(moment, t->field->ring);
  fmpz_init_set_ui(two, 2);
  tp_symbol_inertia(own->of, twist->of, w->w, w->x6, w->y6, t->polar12, true, t->field);
  tp_formulas_determinant(moment, w->x6, w->y6, twist->of, twist->of + 1, t->field);
  fmpz_mpoly_q_mul_fmpz(own->of, own->of, two, t->field->ring);
  fmpz_mpoly_q_mul_fmpz(own->of + 1, own->of + 1, two, t->field->ring);
  fmpz_mpoly_q_mul_fmpz(moment, moment, two, t->field->ring);
  tp_field_add(own->of + 2, own->of + 2, moment, t->field);
  fmpz_mpoly_q_clear(moment, t->field->ring);
  fmpz_clear(two);
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
