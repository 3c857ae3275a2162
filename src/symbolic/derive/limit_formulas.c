/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of the friction cones in symbols, the twist of two columns as their cross product,
 * tan(alpha) from v . F = 0, and the powers of all other columns (docs/mechanics.md sections 6 and
 * 9). */

#include "derive/limit_formulas.h"

#include "derive/field_work.h"

#include <stdlib.h>

static const tp_field *field_of(const tp_limit_formulas *f) {
  return &f->model->symbols.field;
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

static bool set_contact(tp_contact_formulas *c, const tp_model *m, tp_direction towards) {
  const fmpz_mpoly_ctx_struct *ring = m->symbols.field.ring;
  const tp_facet *facet = m->problem.contact.facets + c->facet;
  tp_symbolic_point point;
  if (!(difference(c->tx, c->ty, m, facet->t0, facet->t1) ||
        (facet->q0 == facet->q1 && beyond_direction(c->tx, c->ty, m, facet))) ||
      !tp_formulas_point(&point, &m->symbols, &m->problem,
                         c->at_right_end ? facet->q1 : facet->q0)) {
    return false;
  }
  fmpz_mpoly_q_set(c->x, point.x, ring);
  fmpz_mpoly_q_set(c->y, point.y, ring);
  tp_symbol_mirror(c->x, towards, &m->symbols.field);
  tp_symbol_mirror(c->ty, towards, &m->symbols.field);
  return true;
}

bool tp_contacts_formulas_init(tp_contacts_formulas *contacts, const tp_model *m,
                               tp_direction towards) {
  const tp_contact *contact = &m->problem.contact;
  const fmpz_mpoly_ctx_struct *ring = m->symbols.field.ring;
  *contacts = (tp_contacts_formulas){
      .items = calloc(2 * (size_t)contact->facet_count + 1, sizeof *contacts->items)};
  if (contacts->items == NULL) return false;
  for (long k = 0; k < contact->facet_count; k++) {
    tp_outline_point points[2];
    const int ends = tp_facet_contacts(points, contact->facets + k);
    for (int end = 0; end < ends; end++) {
      tp_contact_formulas *c = contacts->items + contacts->count++;
      *c = (tp_contact_formulas){.facet = (size_t)k, .at_right_end = end == 1};
      fmpz_mpoly_q_init(c->x, ring);
      fmpz_mpoly_q_init(c->y, ring);
      fmpz_mpoly_q_init(c->tx, ring);
      fmpz_mpoly_q_init(c->ty, ring);
      c->known = set_contact(c, m, towards);
    }
  }
  return true;
}

void tp_contacts_formulas_clear(tp_contacts_formulas *contacts, const tp_field *field) {
  for (long k = 0; k < contacts->count; k++) {
    fmpz_mpoly_q_clear(contacts->items[k].x, field->ring);
    fmpz_mpoly_q_clear(contacts->items[k].y, field->ring);
    fmpz_mpoly_q_clear(contacts->items[k].tx, field->ring);
    fmpz_mpoly_q_clear(contacts->items[k].ty, field->ring);
  }
  free(contacts->items);
}

void tp_weight_formulas_init(tp_weight_formulas *weight, const tp_model *m, tp_direction towards) {
  const fmpz_mpoly_ctx_struct *ring = m->symbols.field.ring;
  fmpz_t three;
  fmpz_init_set_ui(three, 3);
  fmpz_mpoly_q_init(weight->w, ring);
  fmpz_mpoly_q_init(weight->x6, ring);
  fmpz_mpoly_q_init(weight->y6, ring);
  fmpz_mpoly_q_mul_fmpz(weight->w, m->formulas.weighted2, three, ring);
  fmpz_mpoly_q_set(weight->x6, m->formulas.x6, ring);
  tp_symbol_mirror(weight->x6, towards, &m->symbols.field);
  fmpz_mpoly_q_set(weight->y6, m->formulas.y6, ring);
  fmpz_clear(three);
}

void tp_weight_formulas_clear(tp_weight_formulas *weight, const tp_field *field) {
  fmpz_mpoly_q_clear(weight->w, field->ring);
  fmpz_mpoly_q_clear(weight->x6, field->ring);
  fmpz_mpoly_q_clear(weight->y6, field->ring);
}

void tp_contact_formulas_edge(tp_vector_formulas *force, const tp_contact_formulas *c,
                              long friction, bool against, const tp_field *field) {
  fmpz_mpoly_q_t tangent;
  fmpz_mpoly_q_init(tangent, field->ring);
  fmpz_mpoly_q_gen(tangent, friction, field->ring);
  tp_symbol_cone_edge(force->of, c->tx, c->ty, tangent, against, field);
  tp_symbol_moment(force->of, c->x, c->y, field);
  fmpz_mpoly_q_clear(tangent, field->ring);
}

/* The edges of the forces; false where one has no formula. */
static bool set_basis(tp_limit_formulas *f, const tp_reaction forces[2]) {
  for (int k = 0; k < 2; k++) {
    f->edges[k] = (tp_cone_edge){-1, !forces[k].against_slip};
    for (long p = 0; p < f->contacts.count; p++) {
      const tp_contact_formulas *c = f->contacts.items + p;
      if (c->known && c->facet == forces[k].facet && c->at_right_end == forces[k].at_right_end)
        f->edges[k].point = p;
    }
    if (f->edges[k].point < 0) return false;
    tp_contact_formulas_edge(f->basis + k, f->contacts.items + f->edges[k].point, f->friction,
                             f->edges[k].against, field_of(f));
  }
  return true;
}

/* The power of the weight on the twist is nothing at tan = -level / slope. The twist as it is
 * drives the block where its cosine is above zero at the scene's values; the callers settle the
 * sign. */
static void set_tilt(tp_limit_formulas *f) {
  const tp_weight_formulas *w = &f->weight;
  tp_symbol_cross(f->twist.of, f->basis[0].of, f->basis[1].of, field_of(f));
  tp_symbol_weight_power(f->cosine, f->sine, f->twist.of, w->w, w->x6, w->y6, field_of(f));
  fmpz_mpoly_q_neg(f->sine, f->sine, field_of(f)->ring);
}

tp_status tp_limit_formulas_init(tp_limit_formulas *f, const tp_model *model, tp_direction towards,
                                 long friction, const tp_reaction forces[2], tp_message *message) {
  *f = (tp_limit_formulas){.model = model, .towards = towards, .friction = friction};
  const tp_field *field = &model->symbols.field;
  if (!tp_contacts_formulas_init(&f->contacts, model, towards)) {
    return tp_fail_memory(message, "the formulas");
  }
  tp_weight_formulas_init(&f->weight, model, towards);
  for (int k = 0; k < 2; k++) tp_vector_formulas_init(f->basis + k, field);
  tp_vector_formulas_init(&f->twist, field);
  fmpz_mpoly_q_init(f->sine, field->ring);
  fmpz_mpoly_q_init(f->cosine, field->ring);
  if (set_basis(f, forces)) {
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
  tp_contacts_formulas_clear(&f->contacts, field);
  tp_weight_formulas_clear(&f->weight, field);
  for (int k = 0; k < 2; k++) tp_vector_formulas_clear(f->basis + k, field);
  tp_vector_formulas_clear(&f->twist, field);
  fmpz_mpoly_q_clear(f->sine, field->ring);
  fmpz_mpoly_q_clear(f->cosine, field->ring);
}

/* f_0 e_0 + f_1 e_1 = (tan, 1): f_0 = (tan e_1y - e_1x) / omega, f_1 = (e_0x - tan e_0y) / omega;
 * of parallel forces, which slide it, by the moment row instead of that along x: with G the lever
 * of the weight, G_x - G_y tan. */
void tp_limit_formulas_factors(fmpz_mpoly_q_t factors[2], const tp_limit_formulas *f) {
  const tp_field *field = field_of(f);
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  fmpz_mpoly_q_t along, up, first, second, below;
  fmpz_mpoly_q_init(along, ring);
  fmpz_mpoly_q_init(up, ring);
  fmpz_mpoly_q_init(first, ring);
  fmpz_mpoly_q_init(second, ring);
  fmpz_mpoly_q_init(below, ring);
  const fmpz_mpoly_q_struct *a = f->basis[0].of, *b = f->basis[1].of;
  const bool slides = fmpz_mpoly_q_is_zero(f->twist.of + 2, ring);
  tp_field_div(along, f->sine, f->cosine, field);
  fmpz_mpoly_q_one(up, ring);
  if (slides) { /* moment of the reaction: G_x - G_y tan */
    tp_field_mul(first, f->weight.y6, along, field);
    tp_field_sub(along, f->weight.x6, first, field);
    tp_field_div(along, along, f->weight.w, field);
  }
  const fmpz_mpoly_q_struct *a_row = slides ? a + 2 : a, *b_row = slides ? b + 2 : b;
  tp_formulas_determinant(below, a_row, a + 1, b_row, b + 1, field);
  tp_formulas_determinant(first, along, up, b_row, b + 1, field);
  tp_formulas_determinant(second, a_row, a + 1, along, up, field);
  tp_field_div(factors[0], first, below, field);
  tp_field_div(factors[1], second, below, field);
  fmpz_mpoly_q_clear(along, ring);
  fmpz_mpoly_q_clear(up, ring);
  fmpz_mpoly_q_clear(first, ring);
  fmpz_mpoly_q_clear(second, ring);
  fmpz_mpoly_q_clear(below, ring);
}
