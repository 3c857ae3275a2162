/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_truth.h"

#include <stdio.h>

enum { BITS = 512 };

/* Area, and area and both first moments times density over that of the block; in metres. */
typedef struct moments {
  fmpq_t area, weight, x, y;
} moments;

/* An arm of the weight about a point, (sine, cosine) of its critical angle times its length. */
typedef struct arm {
  fmpq_t x, y;
} arm;

static void to_metres(fmpq_t x, fmpq_t y, const random_scene *s) {
  fmpq_mul(x, x, &random_units[s->unit].metres);
  fmpq_mul(y, y, &random_units[s->unit].metres);
}

/* One triangle of the fan: its area times the mean of its corners. */
static void add_triangle(moments *ring, const fmpq x[3], const fmpq y[3]) {
  fmpq n[6];
  for (int k = 0; k < 6; k++) fmpq_init(n + k);
  for (int k = 0; k < 2; k++) {
    fmpq_sub(n + k, x + 1 + k, x);
    fmpq_sub(n + 2 + k, y + 1 + k, y);
  }
  fmpq_mul(n + 4, n, n + 3);
  fmpq_submul(n + 4, n + 1, n + 2);
  fmpq_div_2exp(n + 4, n + 4, 1);
  fmpq_add(ring->area, ring->area, n + 4);
  fmpq_div_fmpz(n + 4, n + 4, (const fmpz[]){3});
  for (int k = 0; k < 3; k++) {
    fmpq_addmul(ring->x, n + 4, x + k);
    fmpq_addmul(ring->y, n + 4, y + k);
  }
  for (int k = 0; k < 6; k++) fmpq_clear(n + k);
}

/* The ring with this density, relative to the block's; its size whichever way it runs. */
static void add_ring(moments *m, const random_scene *s, const polygon *ring, const fmpq_t density,
                     int area_sign) {
  fmpq x[3], y[3];
  moments own;
  fmpq_init(own.area);
  fmpq_init(own.x);
  fmpq_init(own.y);
  for (int k = 0; k < 3; k++) {
    fmpq_init(x + k);
    fmpq_init(y + k);
  }
  for (long k = 0; k < ring->count; k++) {
    const int at = k < 2 ? (int)k : 2;
    if (k > 2) {
      fmpq_swap(x + 1, x + 2);
      fmpq_swap(y + 1, y + 2);
    }
    random_scene_vertex(x + at, y + at, s, ring, k);
    to_metres(x + at, y + at, s);
    if (k > 1) add_triangle(&own, x, y);
  }
  if (fmpq_sgn(own.area) < 0) {
    fmpq_neg(own.area, own.area);
    fmpq_neg(own.x, own.x);
    fmpq_neg(own.y, own.y);
  }
  fmpq_addmul(m->weight, density, own.area);
  fmpq_addmul(m->x, density, own.x);
  fmpq_addmul(m->y, density, own.y);
  if (area_sign > 0) fmpq_add(m->area, m->area, own.area);
  if (area_sign < 0) fmpq_sub(m->area, m->area, own.area);
  for (int k = 0; k < 3; k++) {
    fmpq_clear(x + k);
    fmpq_clear(y + k);
  }
  fmpq_clear(own.area);
  fmpq_clear(own.x);
  fmpq_clear(own.y);
}

static void moments_init(moments *m, const random_scene *s) {
  fmpq_t density;
  fmpq_init(density);
  fmpq_init(m->area);
  fmpq_init(m->weight);
  fmpq_init(m->x);
  fmpq_init(m->y);
  fmpq_one(density);
  add_ring(m, s, &s->outline, density, 1);
  fmpq_neg(density, density);
  add_ring(m, s, &s->hole, density, -1);
  fmpq_set_si(density, s->part_weight - BLOCK_WEIGHT, BLOCK_WEIGHT);
  add_ring(m, s, &s->part, density, 0);
  fmpq_div(m->x, m->x, m->weight); /* the centroid */
  fmpq_div(m->y, m->y, m->weight);
  fmpq_clear(density);
}

static void moments_clear(moments *m) {
  fmpq_clear(m->area);
  fmpq_clear(m->weight);
  fmpq_clear(m->x);
  fmpq_clear(m->y);
}

static bool holds(tp_bounded number, const fmpq_t truth) {
  arb_t ball;
  arb_init(ball);
  arf_set_d(arb_midref(ball), number.value);
  mag_set_d(arb_radref(ball), number.error);
  const bool contains = arb_contains_fmpq(ball, truth) != 0;
  arb_clear(ball);
  return contains;
}

static bool holds_angle(tp_bounded number, const arm *a) {
  arb_t x, y, angle, ball;
  arb_init(x);
  arb_init(y);
  arb_init(angle);
  arb_init(ball);
  arb_set_fmpq(x, a->x, BITS);
  arb_set_fmpq(y, a->y, BITS);
  arb_atan2(angle, x, y, BITS);
  arb_const_pi(x, BITS);
  arb_div(angle, angle, x, BITS);
  arb_mul_ui(angle, angle, 180, BITS);
  arf_set_d(arb_midref(ball), number.value);
  mag_set_d(arb_radref(ball), number.error);
  const bool meets = arb_overlaps(ball, angle) != 0;
  arb_clear(x);
  arb_clear(y);
  arb_clear(angle);
  arb_clear(ball);
  return meets;
}

/* A vertex that lies where the pivot is said to lie, with the critical angle that it is said to
 * have. */
static bool find_pivot(arm *found, const tp_pivot *pivot, const random_scene *s, const moments *m,
                       tp_direction towards) {
  const polygon *const rings[] = {&s->outline, &s->profile};
  fmpq_t x, y;
  bool is_found = false;
  fmpq_init(x);
  fmpq_init(y);
  for (int i = 0; i < 2 && !is_found; i++) {
    for (long k = 0; k < rings[i]->count && !is_found; k++) {
      random_scene_vertex(x, y, s, rings[i], k);
      to_metres(x, y, s);
      if (!holds(pivot->x_m, x) || !holds(pivot->y_m, y)) continue;
      fmpq_sub(found->x, m->x, x);
      fmpq_sub(found->y, m->y, y);
      if (towards == TP_TOWARDS_RIGHT) fmpq_neg(found->x, found->x);
      is_found = holds_angle(pivot->critical_angle_deg, found);
    }
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return is_found;
}

/* Which half of the circle from -180 to 180 degrees: [-180, 0) or [0, 180]. */
static int half(const arm *a) {
  return fmpq_sgn(a->x) < 0 ? 0 : 1;
}

/* Sign of the difference of two critical angles: sin(a - b) = a_x b_y - a_y b_x in one half. */
static int compare(const arm *a, const arm *b) {
  if (half(a) != half(b)) return half(a) - half(b);
  fmpq_t cross;
  fmpq_init(cross);
  fmpq_mul(cross, a->x, b->y);
  fmpq_submul(cross, a->y, b->x);
  const int sign = fmpq_sgn(cross);
  fmpq_clear(cross);
  if (sign == 0 && fmpq_sgn(a->y) != fmpq_sgn(b->y)) return fmpq_sgn(b->y); /* 0 and 180 degrees */
  return sign;
}

static const char *judge_case(const tp_case *own, const random_scene *s, const moments *m) {
  const char *wrong = NULL;
  arm *arms = flint_calloc(own->pivot_count + 1, sizeof *arms);
  for (size_t k = 0; k < own->pivot_count; k++) {
    fmpq_init(arms[k].x);
    fmpq_init(arms[k].y);
    if (!find_pivot(arms + k, own->pivots + k, s, m, own->towards)) wrong = "a pivot";
  }
  bool tie = false;
  for (size_t k = 0; k < own->pivot_count && wrong == NULL; k++) {
    if (!own->pivots[k].admissible) continue;
    if (!own->has_toppling_pivot) wrong = "an admissible pivot does not govern";
    const int side = compare(arms + k, arms + own->toppling_pivot);
    if (side < 0) wrong = "another pivot governs";
    tie = tie || (side == 0 && k != own->toppling_pivot);
  }
  if (wrong == NULL && own->has_toppling_pivot && tie != own->toppling_tie) wrong = "tie of pivots";
  for (size_t k = 0; k < own->pivot_count; k++) {
    fmpq_clear(arms[k].x);
    fmpq_clear(arms[k].y);
  }
  flint_free(arms);
  return wrong;
}

bool solution_is_true(char why[256], const tp_solution *solution, const random_scene *scene) {
  moments m;
  moments_init(&m, scene);
  const char *wrong = NULL;
  if (!holds(solution->block.area_m2, m.area)) wrong = "area";
  if (!holds(solution->block.centroid_x_m, m.x)) wrong = "centroid x";
  if (!holds(solution->block.centroid_y_m, m.y)) wrong = "centroid y";
  for (size_t k = 0; k < solution->case_count && wrong == NULL; k++) {
    wrong = judge_case(solution->cases + k, scene, &m);
  }
  moments_clear(&m);
  if (wrong != NULL) snprintf(why, 256, "not the truth: %s", wrong);
  return wrong == NULL;
}
