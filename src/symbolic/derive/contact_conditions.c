/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Conditions on the ends of the default contact: sums and differences of symbolic coordinates, as
 * the supporting lines at 45 degrees of base/underside.h have them. */

#include "derive/contact_conditions.h"

#include "derive/field_work.h"

static bool is_default(const tp_scene *scene) {
  const tp_base_description *base = &scene->base;
  return scene->block.form == TP_OUTLINE_VERTICES && base->mated && !base->whole &&
         base->between.count == 0 && !base->below.given && !base->left_of.given &&
         !base->right_of.given;
}

/* The lowest of the vertices farthest to a side. */
static long end_of_chain(const tp_polyline *line, bool right) {
  long best = 0;
  for (long k = 1; k < line->count; k++) {
    const int side = fmpq_cmp(line->x + k, line->x + best);
    if ((right ? side > 0 : side < 0) || (side == 0 && fmpq_cmp(line->y + k, line->y + best) < 0)) {
      best = k;
    }
  }
  return best;
}

/* x + y of both, or of the right end -x + y. */
static void set_gap(fmpz_mpoly_q_t gap, const tp_model *m, long vertex, long end, bool right) {
  const tp_field *field = &m->symbols.field;
  const tp_symbolic_chain *ring = m->symbols.rings;
  fmpz_mpoly_q_t dx;
  fmpz_mpoly_q_init(dx, field->ring);
  tp_field_sub(dx, ring->x + vertex, ring->x + end, field);
  if (right) fmpz_mpoly_q_neg(dx, dx, field->ring);
  tp_field_sub(gap, ring->y + vertex, ring->y + end, field);
  tp_field_add(gap, gap, dx, field);
  fmpz_mpoly_q_clear(dx, field->ring);
}

/* Of the underside as a whole, from `first` to `last`. */
static bool keep_end(tp_conditions *conditions, const tp_model *m, long first, long last,
                     bool right) {
  const tp_contact *contact = &m->problem.contact;
  const tp_polyline *line = m->problem.section.rings;
  const long end = contact->points[right ? contact->point_count - 1 : 0].point;
  if (end >= line->count) return true;
  bool told = true;
  fmpz_mpoly_q_t gap;
  arb_t ball;
  fmpz_mpoly_q_init(gap, m->symbols.field.ring);
  arb_init(ball);
  for (long k = first;; k = k + 1 == line->count ? 0 : k + 1) {
    if (k != end) {
      set_gap(gap, m, k, end, right);
      tp_field_evaluate_ball(ball, gap, conditions->at, conditions->field, conditions->bits);
      const bool alike =
          arb_contains_zero(ball) && !fmpz_mpoly_q_is_zero(gap, conditions->field->ring);
      if (alike) told = false;
      if (alike) tp_conditions_add_above(conditions, gap); /* the end is the outermost */
      if (!alike) tp_conditions_add(conditions, gap);
    }
    if (k == last) break;
  }
  fmpz_mpoly_q_clear(gap, m->symbols.field.ring);
  arb_clear(ball);
  return told;
}

bool tp_contact_conditions(tp_conditions *conditions, const tp_model *m) {
  if (!is_default(m->problem.scene)) return true;
  const tp_polyline *line = m->problem.section.rings;
  const long first = end_of_chain(line, false), last = end_of_chain(line, true);
  const bool left = keep_end(conditions, m, first, last, false);
  const bool right = keep_end(conditions, m, first, last, true);
  return left && right;
}
