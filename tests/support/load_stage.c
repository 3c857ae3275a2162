/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "load_stage.h"
#include "random_numbers.h"

#include <check.h>
#include <string.h>

/* A whole number of eighths, which a ball holds. */
static void draw_ball(arb_t ball, fmpq_t value, load_stage *s, long least, long most) {
  fmpq_set_si(value, least + draw_below(s->state, most - least + 1), 8);
  arb_set_fmpq(ball, value, STAGE_BITS);
  ck_assert(arb_is_exact(ball));
}

void load_stage_draw(load_stage *s, tp_quantity *quantity, long least, long most) {
  quantity->given = true;
  fmpq_set_si(quantity->value, least + draw_below(s->state, most - least + 1),
              1 + (ulong)draw_below(s->state, 12));
}

enum { NUMBERS = 14 };

/* All that a stage owns but its scratch. */
static void list_numbers(fmpq *all[NUMBERS], load_stage *s) {
  tp_loads_description *d = &s->scene.loads;
  fmpq *const numbers[NUMBERS] = {d->horizontal.value,
                                  d->vertical.value,
                                  d->water.height.value,
                                  d->water.unit_weight_kn_m3.value,
                                  s->scene.metres_per_unit,
                                  &s->sine,
                                  &s->cosine,
                                  &s->weight,
                                  &s->x,
                                  &s->y,
                                  &s->toe_x,
                                  &s->heel_x,
                                  &s->heel_y,
                                  &s->thickness};
  memcpy(all, numbers, sizeof numbers);
}

void load_stage_init(load_stage *s, random_numbers *state) {
  memset(s, 0, sizeof *s);
  s->state = state;
  fmpq *all[NUMBERS];
  list_numbers(all, s);
  for (int k = 0; k < NUMBERS; k++) fmpq_init(all[k]);
  for (int k = 0; k < STAGE_SCRATCH; k++) fmpq_init(s->t + k);
  exact_point_init(&s->at);
  exact_wrench_init(&s->truth);
  tp_wrench_init(&s->wrench);
  fmpq_set_si(s->scene.metres_per_unit, 1 + draw_below(state, 3), 3 + (ulong)draw_below(state, 5));
  tp_load_setting_init(&s->setting, &s->scene, draw_below(state, 2) == 1, STAGE_BITS);
  draw_ball(s->setting.weight, &s->weight, s, 1, 800);
  draw_ball(s->setting.x, &s->x, s, -80, 80);
  draw_ball(s->setting.y, &s->y, s, -80, 80);
  draw_ball(s->setting.toe_x, &s->toe_x, s, -80, -1);
  draw_ball(s->setting.heel_x, &s->heel_x, s, 0, 80);
  draw_ball(s->setting.heel_y, &s->heel_y, s, -80, 80);
  draw_ball(s->setting.thickness, &s->thickness, s, 1, 80);
  /* sine 2 t / (1 + t^2) and cosine (1 - t^2) / (1 + t^2), t = top / 10: up to 84 degrees */
  const long top = draw_below(state, 19) - 9;
  fmpq_set_si(&s->sine, 20 * top, (ulong)(100 + top * top));
  fmpq_set_si(&s->cosine, 100 - top * top, (ulong)(100 + top * top));
}

void load_stage_clear(load_stage *s) {
  fmpq *all[NUMBERS];
  list_numbers(all, s);
  for (int k = 0; k < NUMBERS; k++) fmpq_clear(all[k]);
  for (int k = 0; k < STAGE_SCRATCH; k++) fmpq_clear(s->t + k);
  exact_point_clear(&s->at);
  exact_wrench_clear(&s->truth);
  tp_wrench_clear(&s->wrench);
  tp_load_setting_clear(&s->setting);
}

void load_stage_add(load_stage *s, const fmpq_t fx, const fmpq_t fy, const fmpq_t x,
                    const fmpq_t y) {
  exact_point at;
  exact_point_init(&at);
  exact_turn(&at, x, y, &s->cosine, &s->sine);
  exact_wrench_add(&s->truth, fx, fy, &at);
  exact_point_clear(&at);
}

void load_stage_add_turning(load_stage *s, const fmpq_t fx, const fmpq_t fy, const fmpq_t x,
                            const fmpq_t y) {
  exact_point force;
  exact_point_init(&force);
  exact_turn(&force, fx, fy, &s->cosine, &s->sine);
  load_stage_add(s, &force.x, &force.y, x, y);
  exact_point_clear(&force);
}

/* 2^(17 - bits) F r. Some 2^6 operations each round a number by 2^-bits of it that is at most 4 F
 * r, times 1 / cos^2 of the tilt, which is at most 2^7; and the same again for the turn: 2^(6 + 2 +
 * 7 + 1). One bit is left over. */
static void set_bound(mag_t bound, const fmpq_t force, long reach) {
  arb_t size;
  arb_init(size);
  arb_set_fmpq(size, force, 64);
  arb_mul_si(size, size, reach, 64);
  arb_get_mag(bound, size);
  mag_mul_2exp_si(bound, bound, 17 - STAGE_BITS);
  arb_clear(size);
}

void load_stage_check(const load_stage *s, const char *load, const fmpq_t force, long reach) {
  const tp_trig *const parts[] = {&s->wrench.x, &s->wrench.y, &s->wrench.moment};
  const fmpq *const truth[] = {&s->truth.x, &s->truth.y, &s->truth.moment};
  arb_struct *own = _arb_vec_init(3), *world = _arb_vec_init(3), *turn = _arb_vec_init(2);
  arb_struct *sine = turn, *cosine = turn + 1;
  arb_set_fmpq(sine, &s->sine, STAGE_BITS);
  arb_set_fmpq(cosine, &s->cosine, STAGE_BITS);
  for (int k = 0; k < 3; k++) tp_trig_evaluate(own + k, parts[k], sine, cosine, STAGE_BITS);
  arb_mul(world, own, cosine, STAGE_BITS);
  arb_submul(world, own + 1, sine, STAGE_BITS);
  arb_mul(world + 1, own, sine, STAGE_BITS);
  arb_addmul(world + 1, own + 1, cosine, STAGE_BITS);
  arb_swap(world + 2, own + 2);
  mag_t bound;
  mag_init(bound);
  set_bound(bound, force, reach);
  for (int k = 0; k < 3; k++) {
    ck_assert_msg(arb_contains_fmpq(world + k, truth[k]), "%s: component %d", load, k);
    ck_assert_msg(mag_cmp(arb_radref(world + k), bound) <= 0, "%s: component %d is wide", load, k);
  }
  mag_clear(bound);
  _arb_vec_clear(own, 3);
  _arb_vec_clear(world, 3);
  _arb_vec_clear(turn, 2);
}

long simpson_sixths(int k) {
  return k == 1 ? 4 : 1;
}

static void list_quantities(tp_quantity *all[6], tp_line_load *load) {
  tp_quantity *const quantities[6] = {&load->x0, &load->y0,        &load->x1,
                                      &load->y1, &load->first_kpa, &load->last_kpa};
  memcpy(all, quantities, sizeof quantities);
}

void stage_line_init(stage_line *line, load_stage *s) {
  static const long legs[][3] = {{3, 4, 5}, {-5, 12, 13}, {8, -15, 17},
                                 {0, 7, 7}, {-2, 0, 2},   {-20, -21, 29}};
  memset(line, 0, sizeof *line);
  tp_line_load *load = &line->load;
  tp_quantity *all[6];
  list_quantities(all, load);
  for (int k = 0; k < 6; k++) fmpq_init(all[k]->value);
  const long *leg = legs[draw_below(s->state, sizeof legs / sizeof legs[0])];
  line->dx = leg[0];
  line->dy = leg[1];
  line->length = leg[2];
  load_stage_draw(s, &load->x0, -40, 40);
  load_stage_draw(s, &load->y0, -40, 40);
  fmpq_add_si(load->x1.value, load->x0.value, line->dx);
  fmpq_add_si(load->y1.value, load->y0.value, line->dy);
  load_stage_draw(s, &load->first_kpa, 0, 30);
  load_stage_draw(s, &load->last_kpa, 0, 30);
  if (draw_below(s->state, 20) == 0) fmpq_zero(load->first_kpa.value);
  if (draw_below(s->state, 20) == 0) fmpq_zero(load->last_kpa.value);
}

void stage_line_clear(stage_line *line) {
  tp_quantity *all[6];
  list_quantities(all, &line->load);
  for (int k = 0; k < 6; k++) fmpq_clear(all[k]->value);
}

void stage_line_point(fmpq_t force, load_stage *s, const stage_line *line, int k) {
  fmpq_t part;
  fmpq_init(part);
  fmpq_set_si(part, k * line->dx, 2);
  fmpq_add(&s->at.x, part, line->load.x0.value);
  fmpq_set_si(part, k * line->dy, 2);
  fmpq_add(&s->at.y, part, line->load.y0.value);
  fmpq_mul(&s->at.x, &s->at.x, s->scene.metres_per_unit);
  fmpq_mul(&s->at.y, &s->at.y, s->scene.metres_per_unit);
  if (s->setting.mirrored) fmpq_neg(&s->at.x, &s->at.x);
  fmpq_mul_si(force, line->load.first_kpa.value, 2 - k);
  fmpq_mul_si(part, line->load.last_kpa.value, k);
  fmpq_add(force, force, part);
  fmpq_set_si(part, 1000 * simpson_sixths(k), 12);
  fmpq_mul(force, force, part);
  fmpq_mul(force, force, &s->thickness);
  fmpq_mul(force, force, s->scene.metres_per_unit);
  fmpq_clear(part);
}
