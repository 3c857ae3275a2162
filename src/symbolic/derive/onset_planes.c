/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Planes through pairs of rows with all others on one side at the scene's values, ordered by the
 * length of the formulas that they need. */

#include "derive/onset_planes.h"

#include "common/grow.h"

#include <stdlib.h>
#include <string.h>

void tp_onset_planes_clear(tp_onset_planes *p) {
  for (long k = 0; k < p->count; k++) {
    arb_clear(p->items[k].slope);
    arb_clear(p->items[k].level);
  }
  free(p->items);
  memset(p, 0, sizeof *p);
}

static tp_onset_plane *add_plane(tp_onset_planes *p) {
  tp_onset_plane *more = tp_grow(p->items, p->count, &p->room, sizeof *more);
  if (more == NULL) return NULL;
  p->items = more;
  tp_onset_plane *own = p->items + p->count++;
  *own = (tp_onset_plane){.turn = 1};
  arb_init(own->slope);
  arb_init(own->level);
  return own;
}

/* Forces through one point make the shortest formulas, the radius of gyration the longest. */
static double cost_of(const tp_onset_modes *m, const tp_onset_row *a, const tp_onset_row *b) {
  const tp_onset_row *rows[] = {a, b};
  double cost = 0;
  for (int k = 0; k < 2; k++) {
    if (rows[k]->is_ray) cost += m->twists.rays[rows[k]->ray].axis >= 0 ? 1 : 4;
  }
  const tp_cone_point *points = m->terms->cones.points;
  return cost > 0 || points[a->point].site == points[b->point].site ? cost : 2;
}

void tp_onset_plane_work(fmpz_mpoly_q_t slope, fmpz_mpoly_q_t level, const tp_onset_planes *p,
                         const tp_onset_plane *plane) {
  const tp_onset_terms *t = p->modes->terms;
  const tp_onset_mode *mode = p->modes->modes + plane->mode;
  if (mode->leaves) { /* n . w = t_y sin - t_x cos */
    fmpz_mpoly_q_set(slope, t->contacts.items[plane->i].ty, t->field->ring);
    fmpz_mpoly_q_neg(level, t->contacts.items[plane->i].tx, t->field->ring);
    return;
  }
  tp_vector_formulas h;
  tp_vector_formulas_init(&h, t->field);
  tp_symbol_cross(h.of, mode->rows[plane->i].row.of, mode->rows[plane->j].row.of, t->field);
  if (plane->turn < 0) tp_symbol_reverse(h.of, t->field);
  tp_onset_terms_work(slope, level, t, h.of);
  tp_vector_formulas_clear(&h, t->field);
}

/* The same at the values, without forming the formulas. */
static void set_work(tp_onset_plane *plane, const tp_onset_modes *m) {
  const tp_onset_terms *t = m->terms;
  const tp_onset_row *rows = m->modes[plane->mode].rows;
  tp_vector h;
  arb_t weight, x6, y6;
  tp_vector_init(&h);
  arb_init(weight);
  arb_init(x6);
  arb_init(y6);
  tp_field_evaluate_ball(weight, t->weight.w, t->values, t->field, t->bits);
  tp_field_evaluate_ball(x6, t->weight.x6, t->values, t->field, t->bits);
  tp_field_evaluate_ball(y6, t->weight.y6, t->values, t->field, t->bits);
  tp_vector_cross(&h, &rows[plane->i].at, &rows[plane->j].at, t->bits);
  if (plane->turn < 0) tp_vector_neg(&h);
  tp_ball_weight_power(plane->slope, plane->level, h.of, weight, x6, y6, t->bits);
  tp_vector_clear(&h);
  arb_clear(weight);
  arb_clear(x6);
  arb_clear(y6);
}

/* All other rows on one side: 1 or -1; 0 where all lie in it; by chance, or on both sides. */
static int side_of(const tp_onset_modes *m, const tp_onset_mode *mode, long i, long j) {
  int side = 0;
  for (long k = 0; k < mode->row_count; k++) {
    if (k == i || k == j) continue;
    const int own = tp_onset_rows_sign(m, mode->rows + i, mode->rows + j, mode->rows + k);
    if (own == TP_SIGN_BY_CHANCE || own * side < 0) return TP_SIGN_BY_CHANCE;
    if (own != 0) side = own;
  }
  return side;
}

/* Are they on one line for all values? Two rows span a plane where their product is something. */
static bool spans(const tp_onset_terms *t, const tp_onset_row *a, const tp_onset_row *b) {
  tp_vector h;
  tp_vector_init(&h);
  tp_vector_cross(&h, &a->at, &b->at, t->bits);
  bool something = false;
  for (int k = 0; k < 3; k++) something = something || !arb_contains_zero(h.of + k);
  tp_vector_clear(&h);
  return something;
}

static bool add_pair(tp_onset_planes *p, long mode, long i, long j) {
  const tp_onset_modes *m = p->modes;
  const tp_onset_mode *own = m->modes + mode;
  if (!spans(m->terms, own->rows + i, own->rows + j)) return true;
  const int side = side_of(m, own, i, j);
  if (side == TP_SIGN_BY_CHANCE) return true;
  for (int turn = 1; turn >= -1; turn -= 2) {
    if (side != 0 && turn != side) continue;
    tp_onset_plane *plane = add_plane(p);
    if (plane == NULL) return false;
    plane->mode = mode;
    plane->i = i;
    plane->j = j;
    plane->turn = turn;
    plane->flat = side == 0;
    plane->cost = cost_of(m, own->rows + i, own->rows + j);
    set_work(plane, m);
  }
  return true;
}

static bool add_leaving(tp_onset_planes *p, long mode) {
  const tp_onset_modes *m = p->modes;
  const tp_onset_terms *t = m->terms;
  for (long k = 0; k < m->twists.face_count; k++) {
    tp_onset_plane *plane = add_plane(p);
    if (plane == NULL) return false;
    plane->mode = mode;
    plane->i = m->normals.order[m->normals.items[m->twists.faces[k].normal].first];
    tp_field_evaluate_ball(plane->slope, t->contacts.items[plane->i].ty, t->values, t->field,
                           t->bits);
    tp_field_evaluate_ball(plane->level, t->contacts.items[plane->i].tx, t->values, t->field,
                           t->bits);
    arb_neg(plane->level, plane->level);
  }
  return true;
}

static int by_cost(const void *left, const void *right) {
  const tp_onset_plane *a = left, *b = right;
  if (a->mode != b->mode) return a->mode < b->mode ? -1 : 1;
  if (a->cost != b->cost) return a->cost < b->cost ? -1 : 1;
  if (a->i != b->i) return a->i < b->i ? -1 : 1;
  if (a->j != b->j) return a->j < b->j ? -1 : 1;
  return (a->turn < b->turn) - (a->turn > b->turn);
}

bool tp_onset_planes_init(tp_onset_planes *p, const tp_onset_modes *modes) {
  memset(p, 0, sizeof *p);
  p->modes = modes;
  bool done = true;
  for (long m = 0; m < modes->count && done; m++) {
    const tp_onset_mode *mode = modes->modes + m;
    if (mode->leaves) done = add_leaving(p, m);
    for (long i = 0; i < mode->spanning && done; i++) {
      for (long j = i + 1; j < mode->spanning && done; j++) done = add_pair(p, m, i, j);
    }
  }
  if (done) {
    qsort(p->items, (size_t)p->count, sizeof *p->items, by_cost);
  } else {
    tp_onset_planes_clear(p);
  }
  return done;
}

/* Does h turn, or move, the block as the row's ray does? Then h . M r is its energy, above zero. */
static bool is_energy(const tp_onset_modes *m, const tp_onset_mode *mode,
                      const tp_onset_plane *plane, const tp_onset_row *row) {
  if (!row->is_ray) return false;
  const tp_field *field = m->terms->field;
  tp_vector_formulas h, cross;
  tp_vector_formulas_init(&h, field);
  tp_vector_formulas_init(&cross, field);
  tp_symbol_cross(h.of, mode->rows[plane->i].row.of, mode->rows[plane->j].row.of, field);
  tp_symbol_cross(cross.of, h.of, m->rays[row->ray].of, field);
  bool parallel = true;
  for (int k = 0; k < 3; k++) {
    parallel = parallel && fmpz_mpoly_q_is_zero(cross.of + k, field->ring);
  }
  tp_vector_formulas_clear(&h, field);
  tp_vector_formulas_clear(&cross, field);
  return parallel;
}

static void add_side(tp_conditions *conditions, const tp_onset_planes *p,
                     const tp_onset_plane *plane, long row) {
  const tp_onset_modes *m = p->modes;
  const tp_onset_mode *mode = m->modes + plane->mode;
  const tp_onset_row *other = mode->rows + row;
  if (is_energy(m, mode, plane, other)) return;
  fmpz_mpoly_q_t value;
  fmpz_mpoly_q_init(value, m->terms->field->ring);
  tp_onset_rows_determinant(value, m, mode->rows + plane->i, mode->rows + plane->j, other);
  tp_conditions_add(conditions, value);
  fmpz_mpoly_q_clear(value, m->terms->field->ring);
}

void tp_onset_plane_conditions(tp_conditions *conditions, const tp_onset_planes *p,
                               const tp_onset_plane *plane) {
  const tp_onset_mode *mode = p->modes->modes + plane->mode;
  if (mode->leaves || plane->flat) return;
  for (long k = 0; k < mode->row_count; k++) {
    if (k != plane->i && k != plane->j) add_side(conditions, p, plane, k);
  }
}

void tp_onset_plane_solid(tp_conditions *conditions, const tp_onset_planes *p,
                          const tp_onset_plane *plane) {
  const tp_onset_mode *mode = p->modes->modes + plane->mode;
  const long before = conditions->count;
  long best = -1, least = 0;
  for (long k = 0; k < mode->row_count; k++) {
    if (k == plane->i || k == plane->j) continue;
    const int sign =
        tp_onset_rows_sign(p->modes, mode->rows + plane->i, mode->rows + plane->j, mode->rows + k);
    if (sign != plane->turn) continue;
    add_side(conditions, p, plane, k);
    const long length = tp_conditions_length(conditions, before);
    tp_conditions_forget(conditions, before);
    if (best >= 0 && length >= least) continue;
    best = k;
    least = length;
  }
  if (best >= 0) add_side(conditions, p, plane, best);
}
