/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of the friction cones in symbols, the twist of two columns as their cross product,
 * tan(alpha) from v . F = 0, and the powers of all other columns (docs/mechanics.md sections 6 and
 * 9). */

#include "derive/limit_formulas.h"

#include "derive/field_work.h"
#include "derive/vector_formulas.h"

#include <string.h>

static const tp_field *field_of(const tp_limit_formulas *f) {
  return &f->model->symbols.field;
}

void tp_force_formulas_init(tp_force_formulas *force, const tp_field *field) {
  fmpz_mpoly_q_init(force->x, field->ring);
  fmpz_mpoly_q_init(force->y, field->ring);
  fmpz_mpoly_q_init(force->moment, field->ring);
}

void tp_force_formulas_clear(tp_force_formulas *force, const tp_field *field) {
  fmpz_mpoly_q_clear(force->x, field->ring);
  fmpz_mpoly_q_clear(force->y, field->ring);
  fmpz_mpoly_q_clear(force->moment, field->ring);
}

static bool difference(fmpz_mpoly_q_t dx, fmpz_mpoly_q_t dy, const tp_model *m, long from,
                       long to) {
  tp_symbolic_point p, q;
  if (!tp_formulas_point(&p, &m->symbols, &m->problem, from) ||
      !tp_formulas_point(&q, &m->symbols, &m->problem, to)) {
    return false;
  }
  tp_field_sub(dx, q.x, p.x, &m->symbols.field);
  tp_field_sub(dy, q.y, p.y, &m->symbols.field);
  return true;
}

/* A mated base past the block: its teeth go on, so that the next flank mirrors the block's last
 * one; any other is level there. */
static bool beyond_direction(fmpz_mpoly_q_t tx, fmpz_mpoly_q_t ty, const tp_model *m,
                             const tp_facet *single) {
  const tp_contact *contact = &m->problem.contact;
  const tp_scene *scene = m->problem.scene;
  if (!scene->base.mated) return false;
  if (scene->block.form != TP_OUTLINE_TEETH || !m->problem.base.mated) {
    fmpz_mpoly_q_one(tx, m->symbols.field.ring);
    fmpz_mpoly_q_zero(ty, m->symbols.field.ring);
    return true;
  }
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    if (f->q0 == f->q1 || !tp_facet_ends_in(&m->problem.lattice, f, tp_facet_begin(single)))
      continue;
    const bool found = difference(tx, ty, m, f->t0, f->t1);
    fmpz_mpoly_q_neg(ty, ty, m->symbols.field.ring);
    return found;
  }
  return false;
}

void tp_contact_formulas_init(tp_contact_formulas *c, const tp_field *field) {
  fmpz_mpoly_q_init(c->x, field->ring);
  fmpz_mpoly_q_init(c->y, field->ring);
  fmpz_mpoly_q_init(c->tx, field->ring);
  fmpz_mpoly_q_init(c->ty, field->ring);
}

void tp_contact_formulas_clear(tp_contact_formulas *c, const tp_field *field) {
  fmpz_mpoly_q_clear(c->x, field->ring);
  fmpz_mpoly_q_clear(c->y, field->ring);
  fmpz_mpoly_q_clear(c->tx, field->ring);
  fmpz_mpoly_q_clear(c->ty, field->ring);
}

bool tp_contact_formulas_set(tp_contact_formulas *c, const tp_model *m, tp_direction towards,
                             size_t index, bool at_right_end) {
  const fmpz_mpoly_ctx_struct *ring = m->symbols.field.ring;
  const tp_facet *facet = m->problem.contact.facets + index;
  tp_symbolic_point point;
  if (!(difference(c->tx, c->ty, m, facet->t0, facet->t1) ||
        (facet->q0 == facet->q1 && beyond_direction(c->tx, c->ty, m, facet))) ||
      !tp_formulas_point(&point, &m->symbols, &m->problem, at_right_end ? facet->q1 : facet->q0)) {
    return false;
  }
  fmpz_mpoly_q_set(c->x, point.x, ring);
  fmpz_mpoly_q_set(c->y, point.y, ring);
  if (towards == TP_TOWARDS_RIGHT) {
    fmpz_mpoly_q_neg(c->x, c->x, ring);
    fmpz_mpoly_q_neg(c->ty, c->ty, ring);
  }
  return true;
}

/* n + s t tan(phi) with n = (-t_y, t_x), s = 1 against slip and -1 otherwise. */
void tp_force_formulas_at(tp_force_formulas *force, const tp_contact_formulas *c, long friction,
                          bool against_slip, const tp_field *field) {
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t tangent;
  fmpz_mpoly_q_init(tangent, ring);
  fmpz_mpoly_q_gen(tangent, friction, ring);
  if (!against_slip) fmpz_mpoly_q_neg(tangent, tangent, ring);
  tp_field_mul(force->x, c->tx, tangent, field);
  tp_field_sub(force->x, force->x, c->ty, field);
  tp_field_mul(force->y, c->ty, tangent, field);
  tp_field_add(force->y, force->y, c->tx, field);
  tp_formulas_determinant(force->moment, c->x, c->y, force->x, force->y, field);
  fmpz_mpoly_q_clear(tangent, ring);
}

bool tp_force_formulas_set(tp_force_formulas *force, const tp_limit_formulas *f,
                           const tp_cone_edge *edge) {
  const tp_field *field = field_of(f);
  tp_contact_formulas contact;
  tp_contact_formulas_init(&contact, field);
  const bool found =
      tp_contact_formulas_set(&contact, f->model, f->towards, edge->facet, edge->at_right_end);
  if (found) tp_force_formulas_at(force, &contact, f->friction, edge->against_slip, field);
  tp_contact_formulas_clear(&contact, field);
  return found;
}

static void set_twist(tp_limit_formulas *f) {
  const tp_force_formulas *a = f->basis, *b = f->basis + 1;
  tp_formulas_determinant(f->twist[0], a->y, a->moment, b->y, b->moment, field_of(f));
  tp_formulas_determinant(f->twist[1], a->moment, a->x, b->moment, b->x, field_of(f));
  tp_formulas_determinant(f->twist[2], a->x, a->y, b->x, b->y, field_of(f));
}

/* With S = 3 (2 A) G, the power of the weight on the twist is -sin (3 (2 A) v_x - S_y omega) - cos
 * (3 (2 A) v_y + S_x omega): zero at tan = -(3 (2 A) v_y + S_x omega) / (3 (2 A) v_x - S_y omega).
 */
static void set_tilt(tp_limit_formulas *f) {
  const tp_formulas *sums = &f->model->formulas;
  const tp_field *field = field_of(f);
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t weight, term;
  fmpz_t three;
  fmpz_mpoly_q_init(weight, ring);
  fmpz_mpoly_q_init(term, ring);
  fmpz_init_set_ui(three, 3);
  fmpz_mpoly_q_mul_fmpz(weight, sums->weighted2, three, ring);
  tp_field_mul(term, sums->x6, f->twist[2], field);
  if (f->towards == TP_TOWARDS_RIGHT) fmpz_mpoly_q_neg(term, term, ring);
  tp_field_mul(f->sine, weight, f->twist[1], field);
  tp_field_add(f->sine, f->sine, term, field);
  tp_field_mul(term, sums->y6, f->twist[2], field);
  tp_field_mul(f->cosine, weight, f->twist[0], field);
  tp_field_sub(f->cosine, term, f->cosine, field);
  fmpz_mpoly_q_clear(weight, ring);
  fmpz_mpoly_q_clear(term, ring);
  fmpz_clear(three);
}

tp_status tp_limit_formulas_init(tp_limit_formulas *f, const tp_model *model, tp_direction towards,
                                 long friction, const tp_cone_edge basis[2], tp_message *message) {
  memset(f, 0, sizeof *f);
  f->model = model;
  f->towards = towards;
  f->friction = friction;
  const tp_field *field = &model->symbols.field;
  for (int k = 0; k < 2; k++) tp_force_formulas_init(f->basis + k, field);
  for (int k = 0; k < 3; k++) fmpz_mpoly_q_init(f->twist[k], field->ring);
  fmpz_mpoly_q_init(f->sine, field->ring);
  fmpz_mpoly_q_init(f->cosine, field->ring);
  if (tp_force_formulas_set(f->basis, f, basis) &&
      tp_force_formulas_set(f->basis + 1, f, basis + 1)) {
    set_twist(f);
    set_tilt(f);
    return TP_OK;
  }
  tp_limit_formulas_clear(f);
  return tp_fail(message, TP_NO_ANSWER, model->problem.scene->base.place,
                 "the forces at the limit act on the base past the block, where it has no formula; "
                 "give the base as a profile");
}

void tp_limit_formulas_clear(tp_limit_formulas *f) {
  const tp_field *field = &f->model->symbols.field;
  for (int k = 0; k < 2; k++) tp_force_formulas_clear(f->basis + k, field);
  for (int k = 0; k < 3; k++) fmpz_mpoly_q_clear(f->twist[k], field->ring);
  fmpz_mpoly_q_clear(f->sine, field->ring);
  fmpz_mpoly_q_clear(f->cosine, field->ring);
}

/* The twist as it is drives the block where its cosine is above zero at the scene's values; the
 * callers settle the sign there. */
void tp_limit_formulas_power(fmpz_mpoly_q_t power, const tp_limit_formulas *f,
                             const tp_force_formulas *force) {
  const tp_field *field = field_of(f);
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t term;
  fmpz_mpoly_q_init(term, ring);
  tp_field_mul(power, f->twist[0], force->x, field);
  tp_field_mul(term, f->twist[1], force->y, field);
  tp_field_add(power, power, term, field);
  tp_field_mul(term, f->twist[2], force->moment, field);
  tp_field_add(power, power, term, field);
  fmpz_mpoly_q_clear(term, ring);
}

/* f_0 e_0 + f_1 e_1 = (tan, 1): f_0 = (tan e_1y - e_1x) / omega, f_1 = (e_0x - tan e_0y) / omega;
 * of parallel forces, which slide it, by the moment row instead of that along x: with G the lever
 * of the weight, G_x - G_y tan. */
void tp_limit_formulas_factors(fmpz_mpoly_q_t factors[2], const tp_limit_formulas *f) {
  const tp_field *field = field_of(f);
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  const tp_formulas *sums = &f->model->formulas;
  fmpz_mpoly_q_t along, up, first, second, below;
  fmpz_t three;
  fmpz_mpoly_q_init(along, ring);
  fmpz_mpoly_q_init(up, ring);
  fmpz_mpoly_q_init(first, ring);
  fmpz_mpoly_q_init(second, ring);
  fmpz_mpoly_q_init(below, ring);
  fmpz_init_set_ui(three, 3);
  const tp_force_formulas *a = f->basis, *b = f->basis + 1;
  const bool slides = fmpz_mpoly_q_is_zero(f->twist[2], ring);
  tp_field_div(along, f->sine, f->cosine, field);
  fmpz_mpoly_q_one(up, ring);
  if (slides) { /* moment of the reaction: G_x - G_y tan */
    tp_field_mul(first, sums->y6, along, field);
    fmpz_mpoly_q_set(along, sums->x6, ring);
    if (f->towards == TP_TOWARDS_RIGHT) fmpz_mpoly_q_neg(along, along, ring);
    tp_field_sub(along, along, first, field);
    fmpz_mpoly_q_mul_fmpz(up, sums->weighted2, three, ring);
    tp_field_div(along, along, up, field);
    fmpz_mpoly_q_one(up, ring);
  }
  const fmpz_mpoly_q_struct *a_row = slides ? a->moment : a->x, *b_row = slides ? b->moment : b->x;
  tp_formulas_determinant(below, a_row, a->y, b_row, b->y, field);
  tp_formulas_determinant(first, along, up, b_row, b->y, field);
  tp_formulas_determinant(second, a_row, a->y, along, up, field);
  tp_field_div(factors[0], first, below, field);
  tp_field_div(factors[1], second, below, field);
  fmpz_mpoly_q_clear(along, ring);
  fmpz_mpoly_q_clear(up, ring);
  fmpz_mpoly_q_clear(first, ring);
  fmpz_mpoly_q_clear(second, ring);
  fmpz_mpoly_q_clear(below, ring);
  fmpz_clear(three);
}
