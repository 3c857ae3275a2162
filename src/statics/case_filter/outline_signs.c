/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which signs tell the contact of a block that varies (outline_map.h): those alone that depend on
 * what varies, and are not zero in the scene at hand. What is zero there has to stay so by what the
 * points are made of: on one level or upright line, or in one place. */

#include "case_filter/outline_signs.h"

static void add_sign(tp_outline_mapping *m, tp_map_sign_kind kind, const int of[4], int sign) {
  tp_outline_map *map = m->map;
  m->fits = m->fits && sign != 0 && map->sign_count < TP_MAP_SIGNS;
  if (!m->fits) return;
  tp_map_sign *own = map->signs + map->sign_count++;
  *own = (tp_map_sign){.kind = kind, .sign = (signed char)sign};
  for (int k = 0; k < 4; k++) own->of[k] = (unsigned char)of[k];
}

/* Of two points: one that does not depend on what varies needs no look. */
static void add_order(tp_outline_mapping *m, tp_map_sign_kind kind, int i, int j) {
  tp_affine f, part;
  fmpq_t value;
  tp_affine_init(&f);
  tp_affine_init(&part);
  fmpq_init(value);
  if (kind != TP_SIGN_Y) tp_affine_sub(&f, m->x + i, m->x + j);
  if (kind != TP_SIGN_X) tp_affine_sub(&part, m->y + i, m->y + j);
  if (kind == TP_SIGN_DIFFERENCE) {
    tp_affine_sub(&f, &f, &part);
  } else {
    tp_affine_add(&f, &f, &part);
  }
  tp_affine_value(value, &f, m->variables);
  if (!tp_affine_is_constant(&f)) add_sign(m, kind, (int[4]){i, j, 0, 0}, fmpq_sgn(value));
  tp_affine_clear(&f);
  tp_affine_clear(&part);
  fmpq_clear(value);
}

static bool all_constant(const tp_outline_mapping *m, const int *of, int count) {
  bool constant = true;
  for (int k = 0; k < count; k++) {
    constant =
        constant && tp_affine_is_constant(m->x + of[k]) && tp_affine_is_constant(m->y + of[k]);
  }
  return constant;
}

/* (b - a) x (d - c), or the product by components, as the scene has it. */
static int sign_of(const tp_outline_mapping *m, int a, int b, int c, int d, bool across) {
  fmpq_t ux, uy, vx, vy;
  fmpq_init(ux);
  fmpq_init(uy);
  fmpq_init(vx);
  fmpq_init(vy);
  fmpq_sub(ux, m->own_x + b, m->own_x + a);
  fmpq_sub(uy, m->own_y + b, m->own_y + a);
  fmpq_sub(vx, m->own_x + d, m->own_x + c);
  fmpq_sub(vy, m->own_y + d, m->own_y + c);
  if (across) {
    fmpq_mul(ux, ux, vy);
    fmpq_submul(ux, uy, vx);
  } else {
    fmpq_mul(ux, ux, vx);
    fmpq_addmul(ux, uy, vy);
  }
  const int sign = fmpq_sgn(ux);
  fmpq_clear(ux);
  fmpq_clear(uy);
  fmpq_clear(vx);
  fmpq_clear(vy);
  return sign;
}

/* Do three points lie on one level or one upright line, or two in one place, whatever varies? */
static bool stay_on_line(const tp_outline_mapping *m, const int of[3]) {
  bool level = true, upright = true, same = false;
  for (int k = 0; k < 3; k++) {
    const int a = of[k], b = of[(k + 1) % 3];
    const bool x = tp_affine_equal(m->x + a, m->x + b), y = tp_affine_equal(m->y + a, m->y + b);
    level = level && y;
    upright = upright && x;
    same = same || (x && y);
  }
  return level || upright || same;
}

static void add_turns(tp_outline_mapping *m, int i, int j) {
  for (int k = j + 1; k < m->map->point_count; k++) {
    const int of[4] = {i, j, k, 0};
    if (all_constant(m, of, 3) || stay_on_line(m, of)) continue;
    add_sign(m, TP_SIGN_TURN, of, sign_of(m, i, j, i, k, true));
  }
}

/* Which pivots are admissible (problem/admissible.c): of each contact point against each facet.
 */
static void add_admissible(tp_outline_mapping *m, tp_direction towards) {
  for (int k = 0; k < m->plan->point_count; k++) {
    const tp_mapped_point *f = m->map->points + k;
    const bool second = k > 0 && m->plan->points[k - 1].facet == m->plan->points[k].facet;
    const bool last =
        k + 1 == m->plan->point_count || m->plan->points[k + 1].facet != m->plan->points[k].facet;
    if ((towards == TP_TOWARDS_LEFT ? second : !last) || f->from < 0) continue;
    for (int p = 0; p < m->plan->point_count; p++) {
      const int of[4] = {m->map->points[p].vertex, f->vertex, f->from, f->to};
      if (of[0] == of[1] || all_constant(m, of, 4)) continue;
      add_sign(m, TP_SIGN_ALONG, of, sign_of(m, of[0], of[1], of[2], of[3], false));
    }
  }
}

void tp_outline_mapping_add_signs(tp_outline_mapping *m, tp_direction towards) {
  const tp_scene *scene = m->problem->scene;
  const bool finds_ends = scene->block.form == TP_OUTLINE_VERTICES &&
                          scene->base.between.count == 0 && !scene->base.whole;
  for (int i = 0; i < m->map->point_count; i++) {
    for (int j = i + 1; j < m->map->point_count; j++) {
      add_order(m, TP_SIGN_X, i, j);
      add_order(m, TP_SIGN_Y, i, j);
      if (finds_ends) add_order(m, TP_SIGN_SUM, i, j);
      if (finds_ends) add_order(m, TP_SIGN_DIFFERENCE, i, j);
      add_turns(m, i, j);
    }
  }
  add_admissible(m, towards);
}
