/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Polygon around the cut ellipse, its tangents at rational points, and the closed moments scaled by
 * the half-axes and moved from the centre (docs/mechanics.md section 4). */

#include "block/ellipse.h"

#include "block/region.h"

/* Right of the flat the ellipse lies above the line of slope flat height / (2 width^2) < its
 * tangent there, (height / width) tan b with tan b > flat / width. */
static void set_slope(fmpq_t slope, const tp_ellipse *e) {
  fmpq_mul(slope, e->flat.value, e->height.value);
  fmpq_div(slope, slope, e->width.value);
  fmpq_div(slope, slope, e->width.value);
  fmpq_div_2exp(slope, slope, 1);
}

bool tp_ellipse_hull(tp_polyline *outline, const tp_ellipse *e, tp_mark mark) {
  fmpq_t flat, side, low, zero;
  fmpq_init(flat);
  fmpq_init(side);
  fmpq_init(low);
  fmpq_init(zero);
  fmpq_div_2exp(flat, e->flat.value, 1);
  fmpq_div_2exp(side, e->width.value, 1);
  set_slope(low, e);
  fmpq_sub(zero, side, flat);
  fmpq_mul(low, low, zero);
  fmpq_zero(zero);
  bool done = true;
  for (int k = 0; k < 3 && done; k++) { /* flat, side and top, to the right */
    const fmpq *x = k == 0 ? flat : side, *y = k == 0 ? zero : k == 1 ? low : e->height.value;
    done = tp_polyline_append(outline, x, y, mark);
  }
  fmpq_neg(flat, flat);
  fmpq_neg(side, side);
  for (int k = 2; k >= 0 && done; k--) {
    const fmpq *x = k == 0 ? flat : side, *y = k == 0 ? zero : k == 1 ? low : e->height.value;
    done = tp_polyline_append(outline, x, y, mark);
  }
  fmpq_clear(flat);
  fmpq_clear(side);
  fmpq_clear(low);
  fmpq_clear(zero);
  return done;
}

/* Area, int Y, int X^2 and int Y^2 of the unit circle less the piece below the flat, and cos b. */
typedef struct cut_circle {
  arb_t area, y, xx, yy, cosine;
} cut_circle;

static void cut_circle_init(cut_circle *c, const tp_ellipse *e, long bits) {
  arb_t sine, angle, multiple;
  fmpq_t share;
  arb_init(sine);
  arb_init(angle);
  arb_init(multiple);
  fmpq_init(share);
  arb_init(c->area);
  arb_init(c->y);
  arb_init(c->xx);
  arb_init(c->yy);
  arb_init(c->cosine);
  fmpq_div(share, e->flat.value, e->width.value);
  arb_set_fmpq(sine, share, bits);
  arb_asin(angle, sine, bits);
  arb_cos(c->cosine, angle, bits);
  arb_const_pi(c->area, bits);
  arb_mul_2exp_si(c->xx, c->area, -2);
  arb_set(c->yy, c->xx);
  arb_sub(c->area, c->area, angle, bits);
  arb_addmul(c->area, sine, c->cosine, bits);
  arb_pow_ui(c->y, sine, 3, bits);
  arb_mul_2exp_si(c->y, c->y, 1);
  arb_div_ui(c->y, c->y, 3, bits);
  arb_mul_2exp_si(multiple, angle, -2);
  arb_sub(c->xx, c->xx, multiple, bits);
  arb_sub(c->yy, c->yy, multiple, bits);
  arb_mul_2exp_si(multiple, angle, 2);
  arb_sin(multiple, multiple, bits);
  arb_mul_2exp_si(multiple, multiple, -4);
  arb_add(c->yy, c->yy, multiple, bits);
  arb_div_ui(multiple, multiple, 3, bits);
  arb_sub(c->xx, c->xx, multiple, bits);
  arb_mul_2exp_si(multiple, angle, 1);
  arb_sin(multiple, multiple, bits);
  arb_div_ui(multiple, multiple, 6, bits);
  arb_add(c->xx, c->xx, multiple, bits);
  arb_clear(sine);
  arb_clear(angle);
  arb_clear(multiple);
  fmpq_clear(share);
}

static void cut_circle_clear(cut_circle *c) {
  arb_clear(c->area);
  arb_clear(c->y);
  arb_clear(c->xx);
  arb_clear(c->yy);
  arb_clear(c->cosine);
}

/* Half a length in lattice units. */
static void half_axis(arb_t value, const fmpq_t length, const tp_lattice *lattice,
                      const fmpq_t metres_per_unit, long bits) {
  fmpq_t units;
  fmpq_init(units);
  fmpq_mul(units, length, metres_per_unit);
  fmpq_div(units, units, lattice->step_m);
  fmpq_div_2exp(units, units, 1);
  arb_set_fmpq(value, units, bits);
  fmpq_clear(units);
}

/* sum = moment, moved by the centre: int (p + P)(q + Q) = own + p_c int Q + q_c int P + p_c q_c
 * area */
static void second_moment(arb_t sum, const arb_t own, const arb_t p, const arb_t first_q,
                          const arb_t q, const arb_t first_p, const arb_t area, long bits) {
  arb_t product;
  arb_init(product);
  arb_set(sum, own);
  arb_addmul(sum, p, first_q, bits);
  arb_addmul(sum, q, first_p, bits);
  arb_mul(product, p, q, bits);
  arb_addmul(sum, product, area, bits);
  arb_clear(product);
}

/* Moments about the centre in the axes of the block. */
typedef struct turned_moments {
  arb_t x, y, xx, yy, xy;
} turned_moments;

static void turned_moments_clear(turned_moments *m) {
  arb_struct *const all[] = {m->x, m->y, m->xx, m->yy, m->xy};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) arb_clear(all[k]);
}

/* Those moments, and the centre, which lies at (0, y) along the ellipse's own axes. */
static void turn(turned_moments *m, arb_t x, arb_t y, const cut_circle *c, const tp_ellipse *e,
                 long bits) {
  arb_struct *const all[] = {m->x, m->y, m->xx, m->yy, m->xy};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) arb_init(all[k]);
  arb_zero(x);
  arb_set(m->y, c->y);
  arb_set(m->xx, c->xx);
  arb_set(m->yy, c->yy);
  if (e->cosine == NULL) return;
  arb_t cosine, sine, square;
  arb_init(cosine);
  arb_init(sine);
  arb_init(square);
  arb_set_fmpq(cosine, e->cosine, bits);
  arb_set_fmpq(sine, e->sine, bits);
  arb_mul(x, sine, y, bits);
  arb_mul(y, cosine, y, bits);
  arb_mul(m->x, sine, c->y, bits);
  arb_mul(m->y, cosine, c->y, bits);
  arb_sub(m->xy, c->yy, c->xx, bits);
  arb_mul(m->xy, m->xy, cosine, bits);
  arb_mul(m->xy, m->xy, sine, bits);
  arb_mul(square, cosine, cosine, bits);
  arb_mul(m->xx, square, c->xx, bits);
  arb_mul(m->yy, square, c->yy, bits);
  arb_mul(square, sine, sine, bits);
  arb_addmul(m->xx, square, c->yy, bits);
  arb_addmul(m->yy, square, c->xx, bits);
  arb_clear(cosine);
  arb_clear(sine);
  arb_clear(square);
}

void tp_ellipse_sums(arb_struct sums[TP_SUM_COUNT], const tp_ellipse *e, const tp_lattice *lattice,
                     const fmpq_t metres_per_unit, long bits) {
  cut_circle c;
  tp_region region;
  turned_moments m;
  arb_t a, b, x, y;
  cut_circle_init(&c, e, bits);
  tp_region_init(&region);
  arb_init(a);
  arb_init(b);
  arb_init(x);
  arb_init(y);
  half_axis(a, e->width.value, lattice, metres_per_unit, bits);
  half_axis(b, e->height.value, lattice, metres_per_unit, bits);
  /* the centre, in lattice units from the local origin */
  arb_mul(y, b, c.cosine, bits);
  arb_mul(c.area, c.area, a, bits);
  arb_mul(c.area, c.area, b, bits);
  arb_mul(c.y, c.y, a, bits);
  arb_mul(c.y, c.y, b, bits);
  arb_mul(c.y, c.y, b, bits);
  for (int k = 0; k < 3; k++) arb_mul(c.xx, c.xx, a, bits);
  arb_mul(c.xx, c.xx, b, bits);
  for (int k = 0; k < 3; k++) arb_mul(c.yy, c.yy, b, bits);
  arb_mul(c.yy, c.yy, a, bits);
  turn(&m, x, y, &c, e, bits);
  arb_sub_fmpz(x, x, lattice->origin_x, bits);
  arb_sub_fmpz(y, y, lattice->origin_y, bits);
  arb_struct *of = region.of;
  arb_set(of, c.area);
  arb_mul(of + 1, c.area, x, bits);
  arb_add(of + 1, of + 1, m.x, bits);
  arb_mul(of + 2, c.area, y, bits);
  arb_add(of + 2, of + 2, m.y, bits);
  second_moment(of + 3, m.xx, x, m.x, x, m.x, c.area, bits);
  second_moment(of + 4, m.yy, y, m.y, y, m.y, c.area, bits);
  second_moment(of + 5, m.xy, x, m.y, y, m.x, c.area, bits);
  tp_region_sums(sums, &region, bits);
  turned_moments_clear(&m);
  cut_circle_clear(&c);
  tp_region_clear(&region);
  arb_clear(a);
  arb_clear(b);
  arb_clear(x);
  arb_clear(y);
}
