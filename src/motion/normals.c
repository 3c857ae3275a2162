/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/normals.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_normals_clear(tp_normals *n) {
  for (long k = 0; k < n->count; k++) tp_vector_clear(&n->items[k].h);
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

/* A point as it is sorted: by axis, sense, t . q. */
typedef struct entry {
  const fmpz *tx, *ty;
  fmpz axis_x, axis_y; /* t times its sense */
  int sense;
  arb_t along; /* t . q */
  long site, point;
} entry;

static int axis_order(const entry *a, const entry *b) {
  const int order = fmpz_cmp(&a->axis_x, &b->axis_x);
  return order != 0 ? order : fmpz_cmp(&a->axis_y, &b->axis_y);
}

static int compare(const void *left, const void *right) {
  const entry *a = left, *b = right;
  const int axis = axis_order(a, b);
  if (axis != 0) return axis;
  if (a->sense != b->sense) return a->sense < b->sense ? -1 : 1;
  const int along = arf_cmp(arb_midref(a->along), arb_midref(b->along));
  if (along != 0) return along;
  if (a->site != b->site) return a->site < b->site ? -1 : 1;
  return a->point < b->point ? -1 : a->point > b->point;
}

static int sense_of(const fmpz *tx, const fmpz *ty) {
  const int along = fmpz_sgn(tx);
  return along != 0 ? along : fmpz_sgn(ty);
}

/* t . q */
static void set_along(arb_t along, const tp_normals *n, long point) {
  const tp_cones *cones = n->cones;
  arb_mul_fmpz(along, cones->x + point, n->tx + point, n->judge.precision);
  arb_addmul_fmpz(along, cones->y + point, n->ty + point, n->judge.precision);
}

static void set_direction(tp_normals *n, long point) {
  const tp_cones *cones = n->cones;
  fmpz_t common;
  fmpz_init(common);
  fmpz_gcd(common, cones->tx + point, cones->ty + point);
  fmpz_divexact(n->tx + point, cones->tx + point, common);
  fmpz_divexact(n->ty + point, cones->ty + point, common);
  fmpz_clear(common);
}

/* The exponent of the largest entry. */
static void largest_exponent(fmpz_t exponent, const tp_vector *vector) {
  bool any = false;
  for (int k = 0; k < 3; k++) {
    const arf_struct *own = arb_midref(vector->of + k);
    if (arf_is_special(own) || (any && fmpz_cmp(ARF_EXPREF(own), exponent) <= 0)) continue;
    fmpz_set(exponent, ARF_EXPREF(own));
    any = true;
  }
  fmpz_neg(exponent, exponent);
}

void tp_normals_near(double near[3], const tp_vector *vector) {
  fmpz_t exponent;
  arf_t scaled;
  fmpz_init(exponent);
  arf_init(scaled);
  largest_exponent(exponent, vector);
  for (int k = 0; k < 3; k++) {
    arf_mul_2exp_fmpz(scaled, arb_midref(vector->of + k), exponent);
    near[k] = arf_get_d(scaled, ARF_RND_NEAR);
  }
  fmpz_clear(exponent);
  arf_clear(scaled);
  for (int k = 0; k < 3; k++) {
    const bool told = arb_is_exact(vector->of + k) || arb_rel_accuracy_bits(vector->of + k) > 51;
    const bool fits = near[k] == 0 ? arb_is_zero(vector->of + k) != 0
                                   : fabs(near[k]) > 1e-60 && fabs(near[k]) <= 1;
    if (told && fits) continue;
    near[0] = near[1] = near[2] = 0;
    return;
  }
}

/* Are the points of two neighbours in the order on one line? 1, 0, or 2 where open. */
static int share_line(const entry *a, const entry *b, const tp_normals *n) {
  if (a->site == b->site) return 1;
  arb_t gap;
  arb_init(gap);
  arb_sub(gap, a->along, b->along, n->judge.precision);
  tp_vector size;
  tp_vector_init(&size);
  arb_set(size.of, a->along);
  const int sign = tp_judge_sign(&n->judge, gap, tp_vector_log2_size(&size));
  tp_vector_clear(&size);
  arb_clear(gap);
  return sign == 2 ? 2 : sign == 0;
}

static void add_normal(tp_normals *n, const entry *e, long at) {
  tp_normal *own = n->items + n->count++;
  *own = (tp_normal){.first = at, .count = 1, .family = n->family_count - 1};
  tp_vector_init(&own->h);
  arb_set_fmpz(own->h.of, e->ty);
  arb_neg(own->h.of, own->h.of);
  arb_set_fmpz(own->h.of + 1, e->tx);
  arb_set(own->h.of + 2, e->along);
  tp_normals_near(own->near, &own->h);
}

static tp_motion_outcome gather(tp_normals *n, const entry *entries) {
  for (long k = 0; k < n->cones->count; k++) {
    const entry *e = entries + k, *before = k > 0 ? entries + k - 1 : NULL;
    n->order[k] = e->point;
    const bool same_axis = before != NULL && axis_order(before, e) == 0;
    const bool same_family = same_axis && before->sense == e->sense;
    const int same_line = same_family ? share_line(before, e, n) : 0;
    if (same_line == 2) return TP_MOTION_OPEN;
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
    n->family_of[e->point] = n->family_count - 1;
    n->normal_of[e->point] = n->count - 1;
    const bool same_site = same_line && before->site == e->site;
    n->same[e->point] = same_site ? n->same[before->point] : e->point;
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

tp_motion_outcome tp_normals_init(tp_normals *n, const tp_cones *cones, const tp_judge *judge) {
  memset(n, 0, sizeof *n);
  n->cones = cones;
  n->judge = *judge;
  n->judge.precision = is_exact(cones) ? ARF_PREC_EXACT : judge->bits;
  entry *entries = calloc((size_t)cones->count + 1, sizeof *entries);
  if (entries == NULL || !make_room(n, cones)) {
    free(entries);
    tp_normals_clear(n);
    return TP_MOTION_OUT_OF_MEMORY;
  }
  for (long k = 0; k < cones->count; k++) {
    set_direction(n, k);
    entries[k] = (entry){.tx = n->tx + k,
                         .ty = n->ty + k,
                         .sense = sense_of(n->tx + k, n->ty + k),
                         .site = cones->points[k].site,
                         .point = k};
    fmpz_init(&entries[k].axis_x);
    fmpz_init(&entries[k].axis_y);
    fmpz_mul_si(&entries[k].axis_x, n->tx + k, entries[k].sense);
    fmpz_mul_si(&entries[k].axis_y, n->ty + k, entries[k].sense);
    arb_init(entries[k].along);
    set_along(entries[k].along, n, k);
  }
  qsort(entries, (size_t)cones->count, sizeof *entries, compare);
  const tp_motion_outcome outcome = gather(n, entries);
  for (long k = 0; k < cones->count; k++) {
    fmpz_clear(&entries[k].axis_x);
    fmpz_clear(&entries[k].axis_y);
    arb_clear(entries[k].along);
  }
  free(entries);
  if (outcome != TP_MOTION_PROVEN) tp_normals_clear(n);
  return outcome;
}

/* In doubles each entry is off by 2^-50 of itself at most, so that products are by 2^-48 and their
 * sum by less than 2^-47 of the sum of their sizes. */
static int sign_of_near(const double a[3], const double b[3]) {
  const double x = a[0] * b[0], y = a[1] * b[1], z = a[2] * b[2];
  const double bound = (fabs(x) + fabs(y) + fabs(z)) * 0x1p-47, sum = x + y + z;
  return sum > bound ? 1 : sum < -bound ? -1 : 0;
}

int tp_normal_sign(const tp_normals *n, const tp_normal *normal, const tp_vector *twist,
                   const double near[3], long site) {
  const int told = sign_of_near(normal->near, near);
  if (told != 0) return told;
  if (site >= 0 && tp_normal_has_site(n, normal, site)) return 0;
  arb_t power;
  arb_init(power);
  tp_vector_dot(power, &normal->h, twist, n->judge.precision);
  const int sign =
      tp_judge_sign(&n->judge, power, tp_vector_log2_size(&normal->h) + tp_vector_log2_size(twist));
  arb_clear(power);
  return sign;
}

static void set_slip(tp_vector *g, const tp_normals *n, long point) {
  arb_set_fmpz(g->of, n->tx + point);
  arb_set_fmpz(g->of + 1, n->ty + point);
  arb_mul_fmpz(g->of + 2, n->cones->x + point, n->ty + point, n->judge.precision);
  arb_submul_fmpz(g->of + 2, n->cones->y + point, n->tx + point, n->judge.precision);
}

void tp_normals_slip_ball(arb_t along, const tp_normals *n, long point, const tp_vector *twist) {
  tp_vector g;
  tp_vector_init(&g);
  set_slip(&g, n, point);
  tp_vector_dot(along, &g, twist, n->judge.precision);
  tp_vector_clear(&g);
}

int tp_normals_slip(const tp_normals *n, long point, const tp_vector *twist) {
  tp_vector g;
  arb_t along;
  tp_vector_init(&g);
  arb_init(along);
  set_slip(&g, n, point);
  tp_vector_dot(along, &g, twist, n->judge.precision);
  const int sign =
      tp_judge_sign(&n->judge, along, tp_vector_log2_size(&g) + tp_vector_log2_size(twist));
  tp_vector_clear(&g);
  arb_clear(along);
  return sign;
}

void tp_normals_edge(tp_vector *force, const tp_normals *n, long point, bool against) {
  const fmpz *tx = n->tx + point, *ty = n->ty + point;
  const long bits = n->judge.bits;
  arb_mul_fmpz(force->of, n->cones->friction, tx, bits);
  arb_mul_fmpz(force->of + 1, n->cones->friction, ty, bits);
  if (against) {
    arb_neg(force->of, force->of);
    arb_neg(force->of + 1, force->of + 1);
  }
  arb_sub_fmpz(force->of, force->of, ty, bits);
  arb_add_fmpz(force->of + 1, force->of + 1, tx, bits);
}

bool tp_normal_has_site(const tp_normals *n, const tp_normal *normal, long site) {
  for (long k = normal->first; k < normal->first + normal->count; k++) {
    if (n->cones->points[n->order[k]].site == site) return true;
  }
  return false;
}
