/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moment of one load about a pivot as an exact sum of rationals times functions of the tilt
 * (docs/mechanics.md section 5), zero only where these rationals are or where they cancel at a tilt
 * with rational sine and cosine. */

#include "load/vanish.h"

#include "scene/anchor.h"

void tp_exact_setting_init(tp_exact_setting *s, const tp_scene *scene, bool mirrored) {
  *s = (tp_exact_setting){.scene = scene, .mirrored = mirrored};
  fmpq *const all[] = {s->x,     s->y,     s->heel_x,  s->heel_y,
                       s->toe_x, s->toe_y, s->pivot_x, s->pivot_y};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
}

void tp_exact_setting_clear(tp_exact_setting *s) {
  fmpq *const all[] = {s->x,     s->y,     s->heel_x,  s->heel_y,
                       s->toe_x, s->toe_y, s->pivot_x, s->pivot_y};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

/* A force up to a positive factor, where it acts, and a moment besides. */
typedef struct exact_force {
  fmpq fx[TP_BASIS], fy[TP_BASIS], couple[TP_BASIS];
  fmpq_t x, y;
} exact_force;

static void force_init(exact_force *f) {
  for (int k = 0; k < TP_BASIS; k++) {
    fmpq_init(f->fx + k);
    fmpq_init(f->fy + k);
    fmpq_init(f->couple + k);
  }
  fmpq_init(f->x);
  fmpq_init(f->y);
}

static void force_clear(exact_force *f) {
  for (int k = 0; k < TP_BASIS; k++) {
    fmpq_clear(f->fx + k);
    fmpq_clear(f->fy + k);
    fmpq_clear(f->couple + k);
  }
  fmpq_clear(f->x);
  fmpq_clear(f->y);
}

static void set_point(fmpq_t x, fmpq_t y, const tp_quantity *px, const tp_quantity *py,
                      const tp_exact_setting *s) {
  fmpq_mul(x, px->value, s->scene->metres_per_unit);
  fmpq_mul(y, py->value, s->scene->metres_per_unit);
  if (s->mirrored) fmpq_neg(x, x);
}

static void set_gravity(exact_force *f, tp_load_part part) {
  if (part != TP_WEIGHT_NORMAL) fmpq_set_si(f->fx + TP_SIN, -1, 1);
  if (part != TP_WEIGHT_PARALLEL) fmpq_set_si(f->fy + TP_COS, -1, 1);
}

static bool set_weight(exact_force *f, tp_load_part part, const tp_exact_setting *s) {
  fmpq_set(f->x, s->x);
  fmpq_set(f->y, s->y);
  set_gravity(f, part);
  return s->has_centroid;
}

static bool set_seismic(exact_force *f, const tp_exact_setting *s) {
  const tp_loads_description *d = &s->scene->loads;
  fmpq_set(f->x, s->x);
  fmpq_set(f->y, s->y);
  fmpq_neg(f->fx + TP_COS, d->horizontal.value);
  fmpq_set(f->fy + TP_SIN, d->horizontal.value);
  fmpq_set(f->fx + TP_SIN, d->vertical.value);
  fmpq_set(f->fy + TP_COS, d->vertical.value);
  return s->has_centroid;
}

/* Over the pressure of the water, as load/water.c has it. */
static bool set_water(exact_force *f, const tp_exact_setting *s) {
  const tp_water_description *water = &s->scene->loads.water;
  fmpq_set(f->x, s->heel_x);
  fmpq_set(f->y, s->heel_y);
  fmpq_set_si(f->fx + (water->stays_level ? TP_SEC : TP_COS), -1, 1);
  fmpq *couple = f->couple + (water->stays_level ? TP_SEC2 : TP_COS);
  fmpq_mul(couple, water->height.value, s->scene->metres_per_unit);
  fmpq_div_fmpz(couple, couple, (const fmpz[]){3});
  return true;
}

/* Of a block that goes up-dip, as load/water.c has it: at a third from the heel of the water along
 * the mean plane, normal to that. */
static void set_uplift_up_dip(exact_force *f, const tp_exact_setting *s) {
  const tp_base_description *base = &s->scene->base;
  const bool level = s->scene->loads.water.stays_level;
  fmpq_t sine, length;
  fmpq_init(sine);
  fmpq_init(length);
  fmpq_abs(sine, base->beyond_sine);
  fmpq_sub(f->x, s->heel_x, s->toe_x);
  fmpq_mul(length, f->x, base->beyond_cosine);
  fmpq_sub(f->y, s->toe_y, s->heel_y);
  fmpq_addmul(length, f->y, sine);
  fmpq_div_fmpz(length, length, (const fmpz[]){3});
  fmpq_set(f->x, s->toe_x);
  fmpq_addmul(f->x, length, base->beyond_cosine);
  fmpq_set(f->y, s->toe_y);
  fmpq_submul(f->y, length, sine);
  fmpq_set(f->fx + TP_ONE, sine);
  fmpq_set(f->fy + TP_ONE, base->beyond_cosine);
  fmpq *const both[2] = {f->fx, f->fy};
  for (int k = 0; k < 2 && !level; k++) {
    fmpq_mul(both[k] + TP_COS, both[k] + TP_ONE, base->beyond_cosine);
    fmpq_mul(both[k] + TP_SIN, both[k] + TP_ONE, sine);
    fmpq_zero(both[k] + TP_ONE);
  }
  fmpq_clear(sine);
  fmpq_clear(length);
}

static bool set_uplift(exact_force *f, const tp_exact_setting *s) {
  if (s->scene->loads.water.lifts_alone) {
    set_uplift_up_dip(f, s);
    return true;
  }
  fmpq_mul_si(f->x, s->heel_x, 2);
  fmpq_add(f->x, f->x, s->toe_x);
  fmpq_div_fmpz(f->x, f->x, (const fmpz[]){3});
  fmpq_one(f->fy + (s->scene->loads.water.stays_level ? TP_ONE : TP_COS));
  return true;
}

static bool set_pressure(exact_force *f, const tp_line_load *load, const tp_exact_setting *s) {
  fmpq_t dx, dy, share;
  fmpq_init(dx);
  fmpq_init(dy);
  fmpq_init(share);
  set_point(f->x, f->y, &load->x0, &load->y0, s);
  set_point(dx, dy, &load->x1, &load->y1, s);
  fmpq_sub(dx, dx, f->x);
  fmpq_sub(dy, dy, f->y);
  fmpq_add(share, load->first_kpa.value, load->last_kpa.value);
  const bool acts = !fmpq_is_zero(share);
  if (acts) {
    fmpq_div(share, load->last_kpa.value, share);
    fmpq_add_si(share, share, 1);
    fmpq_div_fmpz(share, share, (const fmpz[]){3});
    fmpq_addmul(f->x, share, dx);
    fmpq_addmul(f->y, share, dy);
    fmpq_neg(f->fx + TP_ONE, dy);
    fmpq_set(f->fy + TP_ONE, dx);
  }
  fmpq_clear(dx);
  fmpq_clear(dy);
  fmpq_clear(share);
  return acts;
}

/* All that sited water presses on as a couple about the origin and a force there, per thickness. */
static bool set_wet_lines(exact_force *f, const tp_wet_lines *lines, const tp_exact_setting *s) {
  tp_wet_lines_sum(f->fx + TP_ONE, f->fy + TP_ONE, f->couple + TP_ONE, lines,
                   s->scene->metres_per_unit, s->mirrored);
  return lines->count > 0;
}

static bool set_surcharge(exact_force *f, const tp_line_load *load, tp_load_part part,
                          const tp_exact_setting *s) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  set_point(f->x, f->y, &load->x0, &load->y0, s);
  set_point(x, y, &load->x1, &load->y1, s);
  fmpq_add(f->x, f->x, x);
  fmpq_add(f->y, f->y, y);
  fmpq_div_2exp(f->x, f->x, 1);
  fmpq_div_2exp(f->y, f->y, 1);
  set_gravity(f, part);
  fmpq_clear(x);
  fmpq_clear(y);
  return true;
}

/* Times the root of 2 where it pulls askew, at 45 degrees; at any other direction its tangent is
 * irrational, and it turns nothing about the point where it acts alone. */
static bool set_anchor(exact_force *f, const tp_anchor_description *anchor, long row,
                       const tp_exact_setting *s) {
  static const int eighths[8][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                    {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  fmpq_t turns;
  fmpz_t k;
  fmpq_init(turns);
  fmpz_init(k);
  tp_quantity x, y;
  fmpq_init(x.value);
  fmpq_init(y.value);
  tp_anchor_point(x.value, y.value, anchor, row);
  set_point(f->x, f->y, &x, &y, s);
  fmpq_clear(x.value);
  fmpq_clear(y.value);
  tp_anchor_direction(turns, s->scene, anchor);
  fmpq_div_fmpz(turns, turns, (const fmpz[]){45});
  const bool rational = fmpz_is_one(fmpq_denref(turns)) != 0;
  const ulong eighth = rational ? fmpz_fdiv_ui(fmpq_numref(turns), 8) : 0;
  fmpq_set_si(f->fx + TP_ONE, (s->mirrored ? -1 : 1) * eighths[eighth][0], 1);
  fmpq_set_si(f->fy + TP_ONE, eighths[eighth][1], 1);
  const bool at_pivot = fmpq_equal(f->x, s->pivot_x) && fmpq_equal(f->y, s->pivot_y);
  fmpq_clear(turns);
  fmpz_clear(k);
  return rational || at_pivot;
}

static bool set_force(exact_force *f, const tp_load *load, tp_load_part part,
                      const tp_exact_setting *s) {
  switch (load->kind) {
  case TP_LOAD_WEIGHT:
    return set_weight(f, part, s);
  case TP_LOAD_SEISMIC:
    return set_seismic(f, s);
  case TP_LOAD_WATER:
    return s->wetted != NULL ? set_wet_lines(f, &s->wetted->faces, s) : set_water(f, s);
  case TP_LOAD_UPLIFT:
    return s->wetted != NULL ? set_wet_lines(f, &s->wetted->joint, s) : set_uplift(f, s);
  case TP_LOAD_ICE:
    return set_wet_lines(f, &s->wetted->ice, s);
  case TP_LOAD_PRESSURE:
  case TP_LOAD_SUPPORT:
    return set_pressure(f, load->line, s);
  case TP_LOAD_SURCHARGE:
    return set_surcharge(f, load->line, part, s);
  case TP_LOAD_ANCHOR:
    return set_anchor(f, load->anchor, load->row, s);
  }
  return false;
}

/* M + (r - P) x F into the couple. */
static void take_about_pivot(exact_force *f, const tp_exact_setting *s) {
  fmpq_sub(f->x, f->x, s->pivot_x);
  fmpq_sub(f->y, f->y, s->pivot_y);
  for (int k = 0; k < TP_BASIS; k++) {
    fmpq_addmul(f->couple + k, f->x, f->fy + k);
    fmpq_submul(f->couple + k, f->y, f->fx + k);
  }
}

/* Where sine and cosine are rational, or alike: what becomes of each function of the tilt, up to
 * one factor, and the one that is zero there. */
static const struct {
  long degrees;
  int times[TP_BASIS], zero;
} rational[] = {
    {0, {1, 0, 1, 1, 1}, TP_SIN}, {90, {0, 1, 1, 0, 0}, TP_COS}, {-90, {0, -1, 1, 0, 0}, TP_COS},
    {45, {1, 1, 0, 0, 0}, -1},    {-45, {1, -1, 0, 0, 0}, -1},   {60, {0, 0, 0, 1, 2}, -1},
    {-60, {0, 0, 0, 1, 2}, -1},
};

/* NULL: at every tilt. */
static bool cancels(const fmpq *moment, const fmpq *tilt_deg) {
  static const int nothing[TP_BASIS] = {0};
  const int *times = nothing;
  int zero_there = -1;
  for (size_t k = 0; k < sizeof rational / sizeof rational[0]; k++) {
    if (tilt_deg == NULL || fmpq_cmp_si(tilt_deg, rational[k].degrees) != 0) continue;
    times = rational[k].times;
    zero_there = rational[k].zero;
  }
  fmpq_t sum, term;
  fmpq_init(sum);
  fmpq_init(term);
  bool zero = true;
  for (int k = 0; k < TP_BASIS; k++) {
    fmpq_mul_si(term, moment + k, times[k]);
    fmpq_add(sum, sum, term);
    if (times[k] == 0 && k != zero_there) zero = zero && fmpq_is_zero(moment + k);
  }
  zero = zero && fmpq_is_zero(sum);
  fmpq_clear(sum);
  fmpq_clear(term);
  return zero;
}

bool tp_load_vanishes(const tp_load *load, tp_load_part part, const tp_exact_setting *s,
                      const fmpq *tilt_deg) {
  exact_force f;
  force_init(&f);
  bool zero = set_force(&f, load, part, s);
  if (zero) {
    take_about_pivot(&f, s);
    zero = cancels(f.couple, tilt_deg);
  }
  force_clear(&f);
  return zero;
}
