/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Seen from above a point p is (p . e, p . f), where e is across up and f = up x e: stretched along
 * f by |up|, which changes neither hull nor turns. The hull by Andrew's chains (1979). */

#include "solid_tilt/support.h"

#include <stdlib.h>

/* ---- heights -----------------------------------------------------------------------------------
 */

static void dot(fmpz_t product, const fmpz *a, const fmpz *b) {
  fmpz_mul(product, a, b);
  fmpz_addmul(product, a + 1, b + 1);
  fmpz_addmul(product, a + 2, b + 2);
}

bool tp_heights_above_init(tp_heights_above *above, const tp_surface *surface, const fmpz up[3],
                           const tp_map_frame *frame) {
  *above = (tp_heights_above){.surface = surface};
  above->heights = calloc((size_t)surface->vertex_count, sizeof *above->heights);
  if (above->heights == NULL) return false;
  long lowest = 0;
  for (long v = 0; v < surface->vertex_count; v++) {
    dot(above->heights + v, up, surface->whole + 3 * v);
    if (fmpz_cmp(above->heights + v, above->heights + lowest) < 0) lowest = v;
  }
  fmpz_t least;
  fmpz_init_set(least, above->heights + lowest);
  for (long v = 0; v < surface->vertex_count; v++) {
    fmpz_sub(above->heights + v, above->heights + v, least);
  }
  fmpz_clear(least);
  fmpz_init(above->square);
  dot(above->square, up, up);
  tp_rest_plane_across(&above->plane, up, lowest);
  tp_map_frame_init(&above->frame, above->plane.near_up);
  if (frame != NULL) above->frame = *frame;
  return true;
}

void tp_heights_above_clear(tp_heights_above *above) {
  for (long v = 0; v < above->surface->vertex_count; v++) fmpz_clear(above->heights + v);
  free(above->heights);
  fmpz_clear(above->square);
  tp_rest_plane_clear(&above->plane);
}

double tp_heights_above_most(const tp_heights_above *above) {
  const fmpz *most = above->heights;
  for (long v = 1; v < above->surface->vertex_count; v++) {
    if (fmpz_cmp(above->heights + v, most) > 0) most = above->heights + v;
  }
  fmpq_t square;
  fmpq_init(square);
  fmpz_mul(fmpq_numref(square), most, most);
  fmpz_mul(fmpq_denref(square), above->surface->divisor, above->surface->divisor);
  fmpz_mul(fmpq_denref(square), fmpq_denref(square), above->square);
  fmpq_canonicalise(square);
  const double height = sqrt(fmpq_get_d(square));
  fmpq_clear(square);
  return height;
}

/* The greatest height of a band: heights h are whole, so that h / (|up| D) <= band where h is at
 * most the whole root of (band D |up|)^2. */
static void set_limit(fmpz_t limit, const tp_heights_above *above, const fmpq_t band) {
  fmpz_t bottom;
  fmpz_init(bottom);
  fmpz_mul(limit, fmpq_numref(band), above->surface->divisor);
  fmpz_mul(limit, limit, limit);
  fmpz_mul(limit, limit, above->square);
  fmpz_mul(bottom, fmpq_denref(band), fmpq_denref(band));
  fmpz_fdiv_q(limit, limit, bottom);
  fmpz_sqrt(limit, limit);
  fmpz_clear(bottom);
}

/* ---- the hull seen from above ------------------------------------------------------------------
 */

typedef struct seen {
  fmpz x, y;    /* to be divided by */
  fmpz *weight; /* where it is not NULL */
  int vertex;
} seen;

static void set_axes(fmpz *e, fmpz *f, const fmpz *up) {
  int least = 0;
  for (int k = 1; k < 3; k++) {
    if (fmpz_cmpabs(up + k, up + least) < 0) least = k;
  }
  const int i = (least + 1) % 3, j = (least + 2) % 3;
  fmpz_zero(e + least); /* e: the axis of the least component x up */
  fmpz_neg(e + i, up + j);
  fmpz_set(e + j, up + i);
  for (int k = 0; k < 3; k++) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    fmpz_mul(f + k, up + a, e + b);
    fmpz_submul(f + k, up + b, e + a);
  }
}

/* (to - from) of one axis, times both weights. */
static void set_way(fmpz_t way, const seen *a, const fmpz_t from, const seen *b, const fmpz_t to) {
  if (a->weight == NULL) {
    fmpz_sub(way, to, from);
  } else {
    fmpz_mul(way, to, a->weight);
    fmpz_submul(way, from, b->weight);
  }
}

static int compare(const void *one, const void *other) {
  const seen *a = one, *b = other;
  if (a->weight == NULL) {
    const int order = fmpz_cmp(&a->x, &b->x);
    return order != 0 ? order : fmpz_cmp(&a->y, &b->y);
  }
  fmpz_t way;
  fmpz_init(way);
  set_way(way, b, &b->x, a, &a->x);
  if (fmpz_is_zero(way)) set_way(way, b, &b->y, a, &a->y);
  const int order = fmpz_sgn(way);
  fmpz_clear(way);
  return order;
}

/* Does the way from a by b to c turn left? */
static bool turns_left(const seen *a, const seen *b, const seen *c, fmpz r[3]) {
  set_way(r, a, &a->x, b, &b->x);
  set_way(r + 1, a, &a->y, c, &c->y);
  fmpz_mul(r + 2, r, r + 1);
  set_way(r, a, &a->y, b, &b->y);
  set_way(r + 1, a, &a->x, c, &c->x);
  fmpz_submul(r + 2, r, r + 1);
  return fmpz_sgn(r + 2) > 0;
}

/* Of sorted points; `corners` has room for one more than twice their number. */
static long chain(int *corners, const seen *points, long count) {
  fmpz r[3];
  long kept = 0;
  for (int k = 0; k < 3; k++) fmpz_init(r + k);
  for (int way = 0; way < 2; way++) {
    const long first = kept;
    for (long n = 0; n < count; n++) {
      const long k = way == 0 ? n : count - 1 - n;
      if (kept > first && compare(points + corners[kept - 1], points + k) == 0) continue;
      while (kept > first + 1 &&
             !turns_left(points + corners[kept - 2], points + corners[kept - 1], points + k, r)) {
        kept--;
      }
      corners[kept++] = (int)k;
    }
    if (kept > first + 1) kept--; /* the last is the first of the other way */
  }
  for (int k = 0; k < 3; k++) fmpz_clear(r + k);
  const bool is_point = kept == 2 && compare(points + corners[0], points + corners[1]) == 0;
  if (is_point) kept = 1;
  for (long k = 0; k < kept; k++) corners[k] = points[corners[k]].vertex;
  return kept;
}

static void see(seen *points, const tp_heights_above *above, const fmpz_t limit) {
  const tp_surface *s = above->surface;
  fmpz axes[6];
  long found = 0;
  for (int k = 0; k < 6; k++) fmpz_init(axes + k);
  set_axes(axes, axes + 3, above->plane.up);
  for (int v = 0; v < s->vertex_count; v++) {
    if (fmpz_cmp(above->heights + v, limit) > 0) continue;
    seen *own = points + found++;
    dot(&own->x, axes, s->whole + 3L * v);
    dot(&own->y, axes + 3, s->whole + 3L * v);
    own->weight = s->weights != NULL ? s->weights + v : NULL;
    own->vertex = v;
  }
  for (int k = 0; k < 6; k++) fmpz_clear(axes + k);
}

bool tp_solid_support_init(tp_solid_support *support, const tp_heights_above *above,
                           const fmpq_t band) {
  fmpz_t limit;
  fmpz_init(limit);
  set_limit(limit, above, band);
  *support = (tp_solid_support){.count = 0};
  for (long v = 0; v < above->surface->vertex_count; v++) {
    support->touching += fmpz_cmp(above->heights + v, limit) <= 0;
  }
  const size_t count = (size_t)support->touching;
  seen *points = calloc(count, sizeof *points);
  support->corners = malloc((2 * count + 1) * sizeof *support->corners);
  const bool done = points != NULL && support->corners != NULL;
  if (done) {
    see(points, above, limit);
    qsort(points, count, sizeof *points, compare);
    support->count = chain(support->corners, points, support->touching);
  }
  for (size_t k = 0; points != NULL && k < count; k++) {
    fmpz_clear(&points[k].x);
    fmpz_clear(&points[k].y);
  }
  free(points);
  fmpz_clear(limit);
  return done;
}

void tp_solid_support_clear(tp_solid_support *support) {
  free(support->corners);
  *support = (tp_solid_support){.count = 0};
}
