/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Columns of the contact forces: both edges n +- t tan(phi) of the friction cone at each contact
 * point, and the bounded shears and pulls of cohesion and bonds, each with its moment
 * (docs/mechanics.md section 6). */

#include "linear_program/cones.h"

#include "number/ball.h"
#include "number/word.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

bool tp_cones_init(tp_cones *cones, long count) {
  memset(cones, 0, sizeof *cones);
  const size_t room = (size_t)count + 1;
  cones->points = calloc(room, sizeof *cones->points);
  cones->whole_x = calloc(room, sizeof *cones->whole_x);
  cones->whole_y = calloc(room, sizeof *cones->whole_y);
  if (cones->points == NULL || cones->whole_x == NULL || cones->whole_y == NULL) {
    free(cones->points);
    free(cones->whole_x);
    free(cones->whole_y);
    cones->points = NULL;
    return false;
  }
  cones->count = count;
  cones->tx = _fmpz_vec_init(count);
  cones->ty = _fmpz_vec_init(count);
  arb_init(cones->friction);
  return true;
}

bool tp_cones_take_own(tp_cones *cones, long own_count) {
  cones->owns = calloc((size_t)cones->count + 1, sizeof *cones->owns);
  if (cones->owns == NULL) return false;
  cones->own_count = own_count;
  cones->own_friction = _arb_vec_init(own_count);
  return true;
}

bool tp_cones_take_lines(tp_cones *cones) {
  cones->lines = calloc((size_t)cones->count + 1, sizeof *cones->lines);
  for (long k = 0; k < cones->count && cones->lines != NULL; k++) {
    cones->lines[k] = cones->points[k].facet;
  }
  return cones->lines != NULL;
}

bool tp_cones_take_senses(tp_cones *cones) {
  cones->senses = calloc((size_t)cones->count + 1, sizeof *cones->senses);
  return cones->senses != NULL;
}

bool tp_cones_bears(const tp_cones *cones, long point, int slip) {
  return cones->senses == NULL || slip == 0 || cones->senses[point] != -slip;
}

bool tp_cones_allow(tp_cones *cones, long capacity_count) {
  cones->capacities = calloc((size_t)capacity_count + 1, sizeof *cones->capacities);
  if (cones->capacities == NULL) return false;
  cones->capacity_count = capacity_count;
  for (long k = 0; k < capacity_count; k++) {
    arb_init(cones->capacities[k].shear);
    arb_init(cones->capacities[k].pull);
  }
  return true;
}

void tp_cones_clear(tp_cones *cones) {
  if (cones->points == NULL) return;
  if (cones->x != NULL) {
    _arb_vec_clear(cones->x, cones->count);
    _arb_vec_clear(cones->y, cones->count);
  }
  _fmpz_vec_clear(cones->tx, cones->count);
  _fmpz_vec_clear(cones->ty, cones->count);
  arb_clear(cones->friction);
  if (cones->own_friction != NULL) _arb_vec_clear(cones->own_friction, cones->own_count);
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_clear(cones->capacities[k].shear);
    arb_clear(cones->capacities[k].pull);
  }
  free(cones->points);
  free(cones->whole_x);
  free(cones->whole_y);
  free(cones->owns);
  free(cones->senses);
  free(cones->lines);
  free(cones->capacities);
  memset(cones, 0, sizeof *cones);
}

/* ---- places ------------------------------------------------------------------------------------
 */

/* From doubles to balls, once one place is no whole number that a double holds. */
static void take_balls(tp_cones *cones) {
  cones->x = _arb_vec_init(cones->count);
  cones->y = _arb_vec_init(cones->count);
  for (long k = 0; k < cones->count; k++) {
    arb_set_d(cones->x + k, cones->whole_x[k]);
    arb_set_d(cones->y + k, cones->whole_y[k]);
  }
  free(cones->whole_x);
  free(cones->whole_y);
  cones->whole_x = cones->whole_y = NULL;
}

static bool is_whole(const arb_t ball) {
  return arb_is_int(ball) && arf_cmpabs_2exp_si(arb_midref(ball), DBL_MANT_DIG) <= 0;
}

void tp_cones_set_place(tp_cones *cones, long point, const arb_t x, const arb_t y) {
  if (cones->x == NULL && is_whole(x) && is_whole(y)) {
    cones->whole_x[point] = tp_ball_nearest(arb_midref(x));
    cones->whole_y[point] = tp_ball_nearest(arb_midref(y));
    return;
  }
  if (cones->x == NULL) take_balls(cones);
  arb_set(cones->x + point, x);
  arb_set(cones->y + point, y);
}

void tp_cones_set_whole(tp_cones *cones, long point, const fmpz_t x, const fmpz_t y) {
  const int64_t most = INT64_C(1) << DBL_MANT_DIG;
  const bool small = tp_word_is_small(x) && tp_word_is_small(y);
  if (cones->x == NULL && small && llabs(tp_word_get(x)) <= most && llabs(tp_word_get(y)) <= most) {
    cones->whole_x[point] = (double)tp_word_get(x);
    cones->whole_y[point] = (double)tp_word_get(y);
    return;
  }
  if (cones->x == NULL) take_balls(cones);
  arb_set_fmpz(cones->x + point, x);
  arb_set_fmpz(cones->y + point, y);
}

/* Two limbs at most, which a ball has within itself. */
static arb_struct borrowed(double whole) {
  arb_t ball;
  arb_init(ball);
  arb_set_d(ball, whole);
  return *ball;
}

arb_struct tp_cones_x(const tp_cones *cones, long point) {
  return cones->x != NULL ? cones->x[point] : borrowed(cones->whole_x[point]);
}

arb_struct tp_cones_y(const tp_cones *cones, long point) {
  return cones->x != NULL ? cones->y[point] : borrowed(cones->whole_y[point]);
}

bool tp_cones_to_double(double *value, const arb_t ball) {
  if (!arb_is_exact(ball) || arf_bits(arb_midref(ball)) > DBL_MANT_DIG ||
      arf_cmpabs_2exp_si(arb_midref(ball), DBL_MANT_DIG) > 0) {
    return false;
  }
  *value = tp_ball_nearest(arb_midref(ball));
  return true;
}

bool tp_cones_in_double(double *x, double *y, const tp_cones *cones, long point) {
  if (cones->x != NULL) {
    return tp_cones_to_double(x, cones->x + point) && tp_cones_to_double(y, cones->y + point);
  }
  *x = cones->whole_x[point];
  *y = cones->whole_y[point];
  return true;
}

bool tp_cones_places_are_exact(const tp_cones *cones) {
  for (long k = 0; k < cones->count && cones->x != NULL; k++) {
    if (!arb_is_exact(cones->x + k) || !arb_is_exact(cones->y + k)) return false;
  }
  return true;
}

/* ---- columns -----------------------------------------------------------------------------------
 */

long tp_cones_column_count(const tp_cones *cones) {
  return 2 * cones->count + TP_CAPACITY_COLUMNS * cones->capacity_count;
}

bool tp_cones_is_edge(const tp_cones *cones, long column) {
  return column < 2 * cones->count;
}

/* Which of an capacity's columns: along t, against it, the pull. */
enum { ALONG, AGAINST, PULL };

static const tp_capacity *capacity_of(const tp_cones *cones, long column, int *kind) {
  const long own = column - 2 * cones->count;
  *kind = (int)(own % TP_CAPACITY_COLUMNS);
  return cones->capacities + own / TP_CAPACITY_COLUMNS;
}

long tp_cones_point_of(const tp_cones *cones, long column) {
  int kind = 0;
  return tp_cones_is_edge(cones, column) ? column / 2 : capacity_of(cones, column, &kind)->point;
}

long tp_cones_own(const tp_cones *cones, long point) {
  return cones->owns != NULL ? cones->owns[point] : 0;
}

arb_srcptr tp_cones_friction(const tp_cones *cones, long point) {
  const long own = tp_cones_own(cones, point);
  return own == 0 ? cones->friction : cones->own_friction + own - 1;
}

bool tp_cones_are_exact(const tp_cones *cones) {
  bool exact = arb_is_exact(cones->friction) != 0;
  for (long k = 0; k < cones->own_count && exact; k++) {
    exact = arb_is_exact(cones->own_friction + k) != 0;
  }
  return exact;
}

static void set_capacity(arb_ptr force, const tp_cones *cones, long point, int kind) {
  const fmpz *tx = cones->tx + point, *ty = cones->ty + point;
  arb_set_fmpz(force, kind == PULL ? ty : tx);
  arb_set_fmpz(force + 1, kind == PULL ? tx : ty);
  if (kind == AGAINST) arb_neg(force, force);
  if (kind != ALONG) arb_neg(force + 1, force + 1);
}

void tp_cones_middle(arb_t x, arb_t y, const tp_cones *cones, long point, long bits) {
  const arb_struct x0 = tp_cones_x(cones, point), x1 = tp_cones_x(cones, point + 1);
  const arb_struct y0 = tp_cones_y(cones, point), y1 = tp_cones_y(cones, point + 1);
  arb_add(x, &x0, &x1, bits);
  arb_add(y, &y0, &y1, bits);
  arb_mul_2exp_si(x, x, -1);
  arb_mul_2exp_si(y, y, -1);
}

void tp_cones_column(arb_ptr entries, const tp_cones *cones, long column, long bits) {
  const long point = tp_cones_point_of(cones, column);
  const arb_struct at_x = tp_cones_x(cones, point), at_y = tp_cones_y(cones, point);
  if (tp_cones_is_edge(cones, column)) {
    tp_ball_cone_edge(entries, cones->tx + point, cones->ty + point,
                      tp_cones_friction(cones, point), column % 2 == 1, bits);
    tp_ball_moment(entries, &at_x, &at_y, bits);
    return;
  }
  int kind = 0;
  (void)capacity_of(cones, column, &kind);
  set_capacity(entries, cones, point, kind);
  if (kind != PULL) {
    tp_ball_moment(entries, &at_x, &at_y, bits);
    return;
  }
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_cones_middle(x, y, cones, point, bits);
  tp_ball_moment(entries, x, y, bits);
  arb_clear(x);
  arb_clear(y);
}

void tp_cones_bound(arb_t most, const tp_cones *cones, long column) {
  int kind = 0;
  const tp_capacity *own = capacity_of(cones, column, &kind);
  arb_set(most, kind == PULL ? own->pull : own->shear);
}

/* Are the facets of two points, with the same side of them free? */
static bool faces_are_parallel(const tp_cones *cones, long a, long b) {
  fmpz_t cross;
  fmpz_init(cross);
  fmpz_mul(cross, cones->tx + a, cones->ty + b);
  fmpz_submul(cross, cones->ty + a, cones->tx + b);
  const bool parallel = fmpz_is_zero(cross) != 0;
  fmpz_mul(cross, cones->tx + a, cones->tx + b);
  fmpz_addmul(cross, cones->ty + a, cones->ty + b);
  const bool same = fmpz_sgn(cross) > 0;
  fmpz_clear(cross);
  return parallel && same;
}

bool tp_cones_are_parallel(const tp_cones *cones, long column, long other) {
  if (!tp_cones_is_edge(cones, column) || !tp_cones_is_edge(cones, other)) return false;
  const long a = column / 2, b = other / 2;
  if (tp_cones_own(cones, a) != tp_cones_own(cones, b)) return false;
  if (column % 2 != other % 2 && !arb_is_zero(tp_cones_friction(cones, a))) return false;
  return faces_are_parallel(cones, a, b);
}

bool tp_cones_slip_unevenly(const tp_cones *cones, long column, long other) {
  if (!tp_cones_is_edge(cones, column) || !tp_cones_is_edge(cones, other)) return false;
  const long a = column / 2, b = other / 2;
  if (tp_cones_own(cones, a) == tp_cones_own(cones, b)) return false;
  const bool smooth = arb_is_zero(tp_cones_friction(cones, a)) != 0 ||
                      arb_is_zero(tp_cones_friction(cones, b)) != 0;
  return (column % 2 == other % 2 || smooth) && faces_are_parallel(cones, a, b);
}

bool tp_cones_share_site(const tp_cones *cones, long column, long other) {
  return tp_cones_is_edge(cones, column) && tp_cones_is_edge(cones, other) &&
         cones->points[column / 2].site == cones->points[other / 2].site;
}

bool tp_cones_is_shear(const tp_cones *cones, long column) {
  int kind = ALONG;
  if (tp_cones_is_edge(cones, column)) return false;
  (void)capacity_of(cones, column, &kind);
  return kind != PULL;
}

static long line_of(const tp_cones *cones, long point) {
  return cones->lines != NULL ? cones->lines[point] : cones->points[point].facet;
}

/* Does a sheared line pass through the point? */
static bool passes(const tp_cones *cones, long line, long site) {
  for (long k = 0; k < cones->count; k++) {
    if (line_of(cones, k) == line && cones->points[k].site == site) return true;
  }
  return false;
}

/* Lines that differ have one point in common at most. */
static bool lines_meet(long *site, const tp_cones *cones, long line, long other) {
  for (long k = 0; k < cones->count && line != other; k++) {
    *site = cones->points[k].site;
    if (line_of(cones, k) == line && passes(cones, other, *site)) return true;
  }
  return false;
}

bool tp_cones_meet(long *site, const tp_cones *cones, long column, long other) {
  const long point = tp_cones_point_of(cones, column),
             other_point = tp_cones_point_of(cones, other);
  const tp_cone_point *own = cones->points + point, *others = cones->points + other_point;
  const bool shear = tp_cones_is_shear(cones, column),
             other_shear = tp_cones_is_shear(cones, other);
  if (shear && other_shear)
    return lines_meet(site, cones, line_of(cones, point), line_of(cones, other_point));
  if (shear && tp_cones_is_edge(cones, other)) {
    *site = others->site;
    return passes(cones, line_of(cones, point), *site);
  }
  if (!tp_cones_is_edge(cones, column)) return false;
  *site = own->site;
  if (other_shear) return passes(cones, line_of(cones, other_point), *site);
  return tp_cones_is_edge(cones, other) && others->site == *site;
}
