/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of each range of gaps the last point. */

#include "assemblage/interior_start.h"

#include "assemblage/force_program.h"

#include <stdlib.h>
#include <string.h>

static const double least_gaps[TP_KEPT_POINTS] = {1e-1, 1e-2, 1e-3, 1e-4, 2e-6};

static void clear_point(tp_kept_point *p) {
  free(p->x);
  free(p->z);
  free(p->w);
  free(p->y);
  *p = (tp_kept_point){.gap = 0};
}

void tp_interior_start_clear(tp_interior_start *start) {
  for (int k = 0; k < TP_KEPT_POINTS; k++) clear_point(start->points + k);
  *start = (tp_interior_start){.n = 0};
}

/* Where a limit moves by a share of itself as x does by as much. */
static const tp_kept_point *nearest(const tp_interior_start *start, double at) {
  static const double wider = 2;
  const tp_kept_point *found = NULL;
  for (int k = 0; k < TP_KEPT_POINTS; k++) {
    const tp_kept_point *own = start->points + k;
    if (own->gap > 0 && own->gap >= wider * fabs(at - own->at)) found = own;
  }
  return found;
}

bool tp_interior_begin(tp_interior *s, tp_interior_start *start, double at) {
  if (start->n != s->n || start->rows != s->p->rows || start->bounded != s->bounded) return false;
  const tp_kept_point *own = nearest(start, at);
  if (own == NULL) return false;
  for (long k = 0; k <= s->n; k++) {
    const bool bounded = tp_interior_is_bounded(s, k);
    s->x[k] = bounded ? own->x[k] * s->most[k] : own->x[k];
    s->z[k] = own->z[k];
    if (bounded) s->w[k] = own->w[k];
  }
  memcpy(s->y, own->y, (size_t)s->p->rows * sizeof *s->y);
  return true;
}

static double *room(long count) {
  return malloc(((size_t)count + 1) * sizeof(double));
}

static bool make_point(tp_kept_point *p, const tp_interior *s) {
  if (p->x != NULL) return true;
  const long n = s->n, rows = s->p->rows;
  *p = (tp_kept_point){
      .x = room(n), .z = room(n), .w = room(s->bounded > 0 ? n : 0), .y = room(rows)};
  if (p->x != NULL && p->z != NULL && p->w != NULL && p->y != NULL) return true;
  clear_point(p);
  return false;
}

bool tp_interior_keep(tp_interior_start *start, const tp_interior *s, double gap, double at) {
  int level = TP_KEPT_POINTS - 1;
  while (level > 0 && gap >= least_gaps[level - 1]) level--;
  if (!(gap >= least_gaps[level] && gap <= 1)) return true;
  if (start->n != s->n || start->rows != s->p->rows || start->bounded != s->bounded) {
    tp_interior_start_clear(start);
    start->n = s->n;
    start->rows = s->p->rows;
    start->bounded = s->bounded;
  }
  tp_kept_point *own = start->points + level;
  if (!make_point(own, s)) return false;
  own->gap = gap;
  own->at = at;
  for (long k = 0; k <= s->n; k++) {
    own->x[k] = tp_interior_is_bounded(s, k) ? s->x[k] / s->most[k] : s->x[k];
    own->z[k] = s->z[k];
    if (s->bounded > 0) own->w[k] = s->w[k];
  }
  memcpy(own->y, s->y, (size_t)s->p->rows * sizeof *own->y);
  return true;
}
