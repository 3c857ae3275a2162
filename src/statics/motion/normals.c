/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of normal and slip velocity of the contact points in balls and in doubles, and the signs of
 * both on a twist, by doubles with a bound first; the points are sorted by normals_init.c. */

#include "motion/normals.h"

#include "number/ball.h"
#include "number/word.h"

#include <math.h>

double tp_normals_top(const arf_struct *middle, slong exponent) {
  enum { MOST = 2000 }; /* beyond the exponents of doubles, -1074 to 1024 */
  mp_srcptr limbs;
  mp_size_t count;
  if (arf_is_special(middle) || COEFF_IS_MPZ(ARF_EXP(middle))) return 0;
  ARF_GET_MPN_READONLY(limbs, count, middle);
  const slong own = ARF_EXP(middle) - exponent;
  if (own < -MOST / 2) return 0;
  const double size = ldexp((double)tp_word_top(limbs, count), (int)(own > MOST ? MOST : own) - 64);
  return ARF_SGNBIT(middle) ? -size : size;
}

void tp_normals_near(double near[3], const tp_vector *vector) {
  slong exponent = 0;
  bool any = false, told = true;
  for (int k = 0; k < 3; k++) {
    const arb_struct *own = vector->of + k;
    told = told && (arb_is_exact(own) || arb_rel_accuracy_bits(own) > 51);
    if (arf_is_special(arb_midref(own))) continue;
    told = told && !COEFF_IS_MPZ(ARF_EXP(arb_midref(own)));
    if (!any || ARF_EXP(arb_midref(own)) > exponent) exponent = ARF_EXP(arb_midref(own));
    any = true;
  }
  for (int k = 0; k < 3 && told; k++) {
    near[k] = tp_normals_top(arb_midref(vector->of + k), exponent);
    told = near[k] == 0 ? arb_is_zero(vector->of + k) != 0
                        : fabs(near[k]) > 1e-60 && fabs(near[k]) <= 1;
  }
  if (!told) near[0] = near[1] = near[2] = 0;
}

const fmpz *tp_normals_tx(const tp_normals *n, long point) {
  return &n->families[n->family_of[point]].tx;
}

const fmpz *tp_normals_ty(const tp_normals *n, long point) {
  return &n->families[n->family_of[point]].ty;
}

void tp_normals_set_h(tp_vector *h, const tp_normals *n, long normal) {
  const long point = n->order[n->items[normal].first];
  const arb_struct x = tp_cones_x(n->cones, point), y = tp_cones_y(n->cones, point);
  tp_ball_normal_row(h->of, &x, &y, tp_normals_tx(n, point), tp_normals_ty(n, point),
                     n->judge.precision);
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
  tp_vector h;
  arb_t power;
  tp_vector_init(&h);
  arb_init(power);
  tp_normals_set_h(&h, n, normal - n->items);
  tp_vector_dot(power, &h, twist, n->judge.precision);
  const int sign = tp_vector_judge(&n->judge, power, &h, twist);
  tp_vector_clear(&h);
  arb_clear(power);
  return sign;
}

static void set_slip(tp_vector *g, const tp_normals *n, long point) {
  const arb_struct x = tp_cones_x(n->cones, point), y = tp_cones_y(n->cones, point);
  tp_ball_slip_row(g->of, &x, &y, tp_normals_tx(n, point), tp_normals_ty(n, point),
                   n->judge.precision);
}

void tp_normals_slip_ball(arb_t along, const tp_normals *n, long point, const tp_vector *twist) {
  tp_vector g;
  tp_vector_init(&g);
  set_slip(&g, n, point);
  tp_vector_dot(along, &g, twist, n->judge.precision);
  tp_vector_clear(&g);
}

bool tp_normals_set_near(tp_near own[3], const double near[3]) {
  static const double error = 0x1p-49; /* the 2^-50 of tp_normals_near, or so */
  for (int k = 0; k < 3; k++) own[k] = (tp_near){near[k], fabs(near[k]) * error};
  return near[0] != 0 || near[1] != 0 || near[2] != 0;
}

void tp_normals_place_near(tp_near *x, tp_near *y, const tp_normals *n, long point) {
  const arb_struct own_x = tp_cones_x(n->cones, point), own_y = tp_cones_y(n->cones, point);
  *x = tp_ball_near(&own_x);
  *y = tp_ball_near(&own_y);
}

static int sign_of_slip(const tp_normals *n, long point, const double near[3]) {
  tp_near a[3];
  if (!tp_normals_set_near(a, near)) return 0;
  const tp_near tx = tp_near_whole(tp_normals_tx(n, point)),
                ty = tp_near_whole(tp_normals_ty(n, point));
  tp_near x, y, g[3];
  tp_normals_place_near(&x, &y, n, point);
  tp_near_slip_row(g, &x, &y, &tx, &ty);
  return tp_near_sign(tp_near_dot(g, a));
}

int tp_normals_slip(const tp_normals *n, long point, const tp_vector *twist, const double near[3]) {
  const int told = sign_of_slip(n, point, near);
  if (told != 0) return told;
  tp_vector g;
  arb_t along;
  tp_vector_init(&g);
  arb_init(along);
  set_slip(&g, n, point);
  tp_vector_dot(along, &g, twist, n->judge.precision);
  const int sign = tp_vector_judge(&n->judge, along, &g, twist);
  tp_vector_clear(&g);
  arb_clear(along);
  return sign;
}

void tp_normals_edge(tp_vector *force, const tp_normals *n, long point, bool against) {
  tp_ball_cone_edge(force->of, tp_normals_tx(n, point), tp_normals_ty(n, point),
                    tp_cones_friction(n->cones, point), against, n->judge.bits);
}

bool tp_normal_has_site(const tp_normals *n, const tp_normal *normal, long site) {
  for (long k = normal->first; k < normal->first + normal->count; k++) {
    if (n->cones->points[n->order[k]].site == site) return true;
  }
  return false;
}

void tp_normals_of_family(long ends[2], const tp_normals *n, long family) {
  const tp_contact_family *own = n->families + family;
  const tp_normal *last = n->items + own->first + own->count - 1;
  ends[0] = n->items[own->first].first;
  ends[1] = last->first + last->count;
}

int tp_normals_share_line(const tp_normals *n, long point, long end) {
  const tp_cones *cones = n->cones;
  if (n->family_of[point] != n->family_of[end]) return 0;
  if (cones->points[point].facet >= 0 && cones->points[point].facet == cones->points[end].facet) {
    return 1;
  }
  const arb_struct x0 = tp_cones_x(cones, point), x1 = tp_cones_x(cones, end);
  const arb_struct y0 = tp_cones_y(cones, point), y1 = tp_cones_y(cones, end);
  const long bits = n->judge.precision;
  arb_t across, part;
  arb_init(across);
  arb_init(part);
  arb_sub(part, &y1, &y0, bits);
  arb_mul_fmpz(across, part, tp_normals_tx(n, point), bits);
  const double log2_scale = fmax(tp_ball_log2_above(&y1), tp_ball_log2_above(&x1)) +
                            (double)fmpz_bits(tp_normals_tx(n, point)) +
                            (double)fmpz_bits(tp_normals_ty(n, point));
  arb_sub(part, &x1, &x0, bits);
  arb_submul_fmpz(across, part, tp_normals_ty(n, point), bits);
  const int sign = tp_judge_sign(&n->judge, across, log2_scale);
  arb_clear(across);
  arb_clear(part);
  return sign == TP_OPEN_SIGN ? TP_OPEN_SIGN : sign == 0;
}
