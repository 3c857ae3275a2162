/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/cones.h"

#include <stdlib.h>
#include <string.h>

bool tp_cones_init(tp_cones *cones, long count, long allowance_count) {
  memset(cones, 0, sizeof *cones);
  cones->points = calloc((size_t)count + 1, sizeof *cones->points);
  cones->allowances = calloc((size_t)allowance_count + 1, sizeof *cones->allowances);
  if (cones->points == NULL || cones->allowances == NULL) {
    free(cones->points);
    free(cones->allowances);
    memset(cones, 0, sizeof *cones);
    return false;
  }
  cones->count = count;
  cones->allowance_count = allowance_count;
  cones->x = _arb_vec_init(count);
  cones->y = _arb_vec_init(count);
  cones->tx = _fmpz_vec_init(count);
  cones->ty = _fmpz_vec_init(count);
  arb_init(cones->friction);
  for (long k = 0; k < allowance_count; k++) {
    arb_init(cones->allowances[k].shear);
    arb_init(cones->allowances[k].pull);
  }
  return true;
}

void tp_cones_clear(tp_cones *cones) {
  if (cones->points == NULL) return;
  _arb_vec_clear(cones->x, cones->count);
  _arb_vec_clear(cones->y, cones->count);
  _fmpz_vec_clear(cones->tx, cones->count);
  _fmpz_vec_clear(cones->ty, cones->count);
  arb_clear(cones->friction);
  for (long k = 0; k < cones->allowance_count; k++) {
    arb_clear(cones->allowances[k].shear);
    arb_clear(cones->allowances[k].pull);
  }
  free(cones->points);
  free(cones->allowances);
  memset(cones, 0, sizeof *cones);
}

long tp_cones_column_count(const tp_cones *cones) {
  return 2 * cones->count + TP_ALLOWANCE_COLUMNS * cones->allowance_count;
}

bool tp_cones_is_edge(const tp_cones *cones, long column) {
  return column < 2 * cones->count;
}

/* Which of an allowance's columns: along t, against it, the pull. */
enum { ALONG, AGAINST, PULL };

static const tp_allowance *allowance_of(const tp_cones *cones, long column, int *kind) {
  const long own = column - 2 * cones->count;
  *kind = (int)(own % TP_ALLOWANCE_COLUMNS);
  return cones->allowances + own / TP_ALLOWANCE_COLUMNS;
}

long tp_cones_point_of(const tp_cones *cones, long column) {
  int kind = 0;
  return tp_cones_is_edge(cones, column) ? column / 2 : allowance_of(cones, column, &kind)->point;
}

/* n + s t tan(phi), n = (-t_y, t_x), for s = 1 or -1. */
static void set_edge(arb_ptr force, const tp_cones *cones, long point, bool against, long bits) {
  arb_mul_fmpz(force, cones->friction, cones->tx + point, bits);
  arb_mul_fmpz(force + 1, cones->friction, cones->ty + point, bits);
  if (against) {
    arb_neg(force, force);
    arb_neg(force + 1, force + 1);
  }
  arb_sub_fmpz(force, force, cones->ty + point, bits);
  arb_add_fmpz(force + 1, force + 1, cones->tx + point, bits);
}

static void set_allowance(arb_ptr force, const tp_cones *cones, long point, int kind) {
  const fmpz *tx = cones->tx + point, *ty = cones->ty + point;
  arb_set_fmpz(force, kind == PULL ? ty : tx);
  arb_set_fmpz(force + 1, kind == PULL ? tx : ty);
  if (kind == AGAINST) arb_neg(force, force);
  if (kind != ALONG) arb_neg(force + 1, force + 1);
}

/* moment = x f_y - y f_x */
static void set_moment(arb_ptr column, const arb_t x, const arb_t y, long bits) {
  arb_mul(column + 2, x, column + 1, bits);
  arb_submul(column + 2, y, column, bits);
}

void tp_cones_column(arb_ptr entries, const tp_cones *cones, long column, long bits) {
  const long point = tp_cones_point_of(cones, column);
  if (tp_cones_is_edge(cones, column)) {
    set_edge(entries, cones, point, column % 2 == 1, bits);
    set_moment(entries, cones->x + point, cones->y + point, bits);
    return;
  }
  int kind = 0;
  (void)allowance_of(cones, column, &kind);
  set_allowance(entries, cones, point, kind);
  if (kind != PULL) {
    set_moment(entries, cones->x + point, cones->y + point, bits);
    return;
  }
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_add(x, cones->x + point, cones->x + point + 1, bits);
  arb_add(y, cones->y + point, cones->y + point + 1, bits);
  arb_mul_2exp_si(x, x, -1);
  arb_mul_2exp_si(y, y, -1);
  set_moment(entries, x, y, bits);
  arb_clear(x);
  arb_clear(y);
}

void tp_cones_bound(arb_t most, const tp_cones *cones, long column) {
  int kind = 0;
  const tp_allowance *own = allowance_of(cones, column, &kind);
  arb_set(most, kind == PULL ? own->pull : own->shear);
}

bool tp_cones_are_parallel(const tp_cones *cones, long column, long other) {
  if (!tp_cones_is_edge(cones, column) || !tp_cones_is_edge(cones, other)) return false;
  const long a = column / 2, b = other / 2;
  if (column % 2 != other % 2 && !arb_is_zero(cones->friction)) return false;
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

bool tp_cones_share_site(const tp_cones *cones, long column, long other) {
  return tp_cones_is_edge(cones, column) && tp_cones_is_edge(cones, other) &&
         cones->points[column / 2].site == cones->points[other / 2].site;
}

/* Places that the line of a column passes through: one or two, none for a pull. */
static int sites_of(long sites[2], const tp_cones *cones, long column) {
  const long point = tp_cones_point_of(cones, column);
  sites[0] = cones->points[point].site;
  if (tp_cones_is_edge(cones, column)) return 1;
  int kind = 0;
  (void)allowance_of(cones, column, &kind);
  if (kind == PULL) return 0;
  sites[1] = cones->points[point + 1].site;
  return 2;
}

bool tp_cones_meet(long *site, const tp_cones *cones, long column, long other) {
  long own[2], others[2];
  const int count = sites_of(own, cones, column), of_other = sites_of(others, cones, other);
  int common = 0;
  for (int k = 0; k < count; k++) {
    for (int j = 0; j < of_other; j++) {
      if (own[k] != others[j]) continue;
      *site = own[k];
      common++;
    }
  }
  return common == 1; /* with two they are one line */
}
