/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact points sorted into families and normal lines: by the exact order of t . q, doubles first
 * where they tell two apart. */

#include "motion/normals.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_normals_clear(tp_normals *n) {
  if (n->tx != NULL) {
    _fmpz_vec_clear(n->tx, n->cones->count);
    _fmpz_vec_clear(n->ty, n->cones->count);
  }
  free(n->items);
  free(n->families);
  free(n->order);
  free(n->same);
  free(n->family_of);
  free(n->normal_of);
  memset(n, 0, sizeof *n);
}

/* Where a point comes in the order: by axis, sense, t . q. */
typedef struct position {
  fmpz axis_x, axis_y; /* t times its sense */
  arb_t along;         /* t . q */
  long site, point;
} position;

/* What is sorted: most comparisons end within it. Of axes of short numbers, below 2^25, no two
 * slopes are closer than 2^-50 of themselves, so that in doubles one slope is one axis. */
typedef struct entry {
  double slope; /* of the axis, rounded: another one is another axis */
  double along; /* rounded */
  int sense;
  bool is_short;
  const position *at;
} entry;

static int whole_order(fmpz a, fmpz b) {
  if (COEFF_IS_MPZ(a) || COEFF_IS_MPZ(b)) return fmpz_cmp(&a, &b);
  return (a > b) - (a < b);
}

static int axis_order(const entry *a, const entry *b) {
  if (a->slope != b->slope) return a->slope < b->slope ? -1 : 1;
  const int order = whole_order(a->at->axis_x, b->at->axis_x);
  return order != 0 ? order : whole_order(a->at->axis_y, b->at->axis_y);
}

static int compare(const void *left, const void *right) {
  const entry *own = left, *other = right;
  const bool is_short = own->is_short && other->is_short;
  const int axis = is_short && own->slope == other->slope ? 0 : axis_order(own, other);
  if (axis != 0) return axis;
  if (own->sense != other->sense) return own->sense < other->sense ? -1 : 1;
  if (own->along != other->along) return own->along < other->along ? -1 : 1;
  const position *a = own->at, *b = other->at;
  const int along = arf_cmp(arb_midref(a->along), arb_midref(b->along));
  if (along != 0) return along;
  if (a->site != b->site) return a->site < b->site ? -1 : 1;
  return a->point < b->point ? -1 : a->point > b->point;
}

static int sense_of(const fmpz *tx, const fmpz *ty) {
  const int along = fmpz_sgn(tx);
  return along != 0 ? along : fmpz_sgn(ty);
}

static void set_direction(tp_normals *n, long point) {
  const tp_cones *cones = n->cones;
  if (point > 0 && fmpz_equal(cones->tx + point, cones->tx + point - 1) &&
      fmpz_equal(cones->ty + point, cones->ty + point - 1)) { /* both ends of a facet */
    fmpz_set(n->tx + point, n->tx + point - 1);
    fmpz_set(n->ty + point, n->ty + point - 1);
    return;
  }
  fmpz_t common;
  fmpz_init(common);
  fmpz_gcd(common, cones->tx + point, cones->ty + point);
  fmpz_divexact(n->tx + point, cones->tx + point, common);
  fmpz_divexact(n->ty + point, cones->ty + point, common);
  fmpz_clear(common);
}

/* Are the points of two neighbours in the order on one line? 1, 0, or TP_OPEN_SIGN. */
static int share_line(const position *a, const position *b, const tp_normals *n) {
  if (a->site == b->site) return 1;
  if (arb_is_exact(a->along) && arb_is_exact(b->along)) return arb_equal(a->along, b->along);
  arb_t gap;
  arb_init(gap);
  arb_sub(gap, a->along, b->along, n->judge.precision);
  tp_vector size;
  tp_vector_init(&size);
  arb_set(size.of, a->along);
  const int sign = tp_judge_sign(&n->judge, gap, tp_vector_log2_size(&size));
  tp_vector_clear(&size);
  arb_clear(gap);
  return sign == TP_OPEN_SIGN ? TP_OPEN_SIGN : sign == 0;
}

static void add_normal(tp_normals *n, const entry *e, long at) {
  const position *p = e->at;
  tp_normal *own = n->items + n->count++;
  *own = (tp_normal){.first = at, .count = 1, .family = n->family_count - 1};
  tp_vector h;
  tp_vector_init(&h);
  arb_set_fmpz(h.of, &p->axis_y);
  arb_set_fmpz(h.of + 1, &p->axis_x);
  arb_neg(h.of + (e->sense > 0 ? 0 : 1), h.of + (e->sense > 0 ? 0 : 1));
  arb_set(h.of + 2, p->along);
  tp_normals_near(own->near, &h);
  tp_vector_clear(&h);
}

static tp_motion_outcome gather(tp_normals *n, const entry *entries) {
  for (long k = 0; k < n->cones->count; k++) {
    const entry *e = entries + k, *before = k > 0 ? entries + k - 1 : NULL;
    const long point = e->at->point;
    n->order[k] = point;
    const bool same_axis = before != NULL && axis_order(before, e) == 0;
    const bool same_family = same_axis && before->sense == e->sense;
    const int same_line = same_family ? share_line(before->at, e->at, n) : 0;
    if (same_line == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (!same_family) {
      const long axis = n->family_count == 0 ? 0 : n->families[n->family_count - 1].axis;
      n->families[n->family_count++] =
          (tp_contact_family){.first = n->count,
                              .axis = same_axis || before == NULL ? axis : axis + 1,
                              .sense = e->sense};
    }
    if (same_line) {
      n->items[n->count - 1].count++;
    } else {
      n->families[n->family_count - 1].count++;
      add_normal(n, e, k);
    }
    n->family_of[point] = n->family_count - 1;
    n->normal_of[point] = n->count - 1;
    const bool same_site = same_line && before->at->site == e->at->site;
    n->same[point] = same_site ? n->same[before->at->point] : point;
  }
  return TP_MOTION_PROVEN;
}

static bool make_room(tp_normals *n, const tp_cones *cones) {
  const size_t room = (size_t)cones->count + 1;
  n->order = calloc(room, sizeof *n->order);
  n->same = calloc(room, sizeof *n->same);
  n->normal_of = calloc(room, sizeof *n->normal_of);
  n->family_of = calloc(room, sizeof *n->family_of);
  n->items = calloc(room, sizeof *n->items);
  n->families = calloc(room, sizeof *n->families);
  if (n->order == NULL || n->same == NULL || n->family_of == NULL || n->normal_of == NULL ||
      n->items == NULL || n->families == NULL) {
    return false;
  }
  n->tx = _fmpz_vec_init(cones->count);
  n->ty = _fmpz_vec_init(cones->count);
  return true;
}

static bool is_exact(const tp_cones *cones) {
  for (long k = 0; k < cones->count; k++) {
    if (!arb_is_exact(cones->x + k) || !arb_is_exact(cones->y + k)) return false;
  }
  return true;
}

static double slope_of(const position *p) {
  if (fmpz_is_zero(&p->axis_x)) return INFINITY;
  slong along, up;
  const double x = fmpz_get_d_2exp(&along, &p->axis_x), y = fmpz_get_d_2exp(&up, &p->axis_y);
  const slong most = 2000; /* beyond the exponents of doubles */
  const slong shift = up - along;
  return ldexp(y / x, (int)(shift > most ? most : shift < -most ? -most : shift));
}

static bool is_short(const fmpz *number) {
  return fmpz_bits(number) <= 25;
}

static void set_entry(entry *e, position *p, const tp_normals *n, long point) {
  const fmpz *tx = n->tx + point, *ty = n->ty + point;
  const int sense = sense_of(tx, ty);
  *p = (position){.site = n->cones->points[point].site, .point = point};
  fmpz_mul_si(&p->axis_x, tx, sense);
  fmpz_mul_si(&p->axis_y, ty, sense);
  arb_init(p->along);
  tp_normals_set_along(p->along, n, point);
  *e = (entry){.slope = slope_of(p),
               .along = tp_normals_top(arb_midref(p->along), 0),
               .sense = sense,
               .is_short = is_short(tx) && is_short(ty),
               .at = p};
}

static tp_motion_outcome sort(tp_normals *n, entry *entries, position *positions) {
  const long count = n->cones->count;
  for (long k = 0; k < count; k++) {
    set_direction(n, k);
    set_entry(entries + k, positions + k, n, k);
  }
  qsort(entries, (size_t)count, sizeof *entries, compare);
  const tp_motion_outcome outcome = gather(n, entries);
  for (long k = 0; k < count; k++) {
    fmpz_clear(&positions[k].axis_x);
    fmpz_clear(&positions[k].axis_y);
    arb_clear(positions[k].along);
  }
  return outcome;
}

tp_motion_outcome tp_normals_init(tp_normals *n, const tp_cones *cones, const tp_judge *judge) {
  memset(n, 0, sizeof *n);
  n->cones = cones;
  n->judge = *judge;
  n->judge.precision = is_exact(cones) ? ARF_PREC_EXACT : judge->bits;
  entry *entries = calloc((size_t)cones->count + 1, sizeof *entries);
  position *positions = calloc((size_t)cones->count + 1, sizeof *positions);
  const bool room = entries != NULL && positions != NULL && make_room(n, cones);
  const tp_motion_outcome outcome = room ? sort(n, entries, positions) : TP_MOTION_OUT_OF_MEMORY;
  free(entries);
  free(positions);
  if (outcome != TP_MOTION_PROVEN) tp_normals_clear(n);
  return outcome;
}
