/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each load's wrench against the same load spread over what it acts on, in rationals
 * (load_stage.h). */

#include "load_stage.h"
#include "random_numbers.h"
#include "suite.h"

#include <string.h>

enum { ROUNDS = 2000, REACH = 20, LINE_REACH = 60 };

static random_numbers state;

static void on_stages(void (*try)(load_stage *s)) {
  for (int k = 0; k < ROUNDS; k++) {
    load_stage s;
    load_stage_init(&s, &state);
    try(&s);
    load_stage_clear(&s);
  }
}

/* The weight hangs from the centroid, straight down. */
static void try_weight(load_stage *s) {
  fmpq *down = s->t, *none = s->t + 1;
  fmpq_neg(down, &s->weight);
  load_stage_add(s, none, down, &s->x, &s->y);
  tp_load_weight(&s->wrench, &s->setting);
  load_stage_check(s, "weight", &s->weight, REACH);
}

/* An earthquake pushes level towards down-dip, and lifts. */
static void try_seismic(load_stage *s) {
  tp_loads_description *d = &s->scene.loads;
  fmpq *push = s->t, *lift = s->t + 1, *force = s->t + 2;
  load_stage_draw(s, &d->horizontal, -3, 9);
  load_stage_draw(s, &d->vertical, -9, 9);
  fmpq_mul(push, d->horizontal.value, &s->weight);
  fmpq_neg(push, push);
  fmpq_mul(lift, d->vertical.value, &s->weight);
  load_stage_add(s, push, lift, &s->x, &s->y);
  tp_load_seismic(&s->wrench, &s->setting);
  fmpq_mul_si(force, &s->weight, 18);
  load_stage_check(s, "earthquake", force, REACH);
}

/* Water up to a height: the newtons that it presses with on a metre at the heel, and the height in
 * metres. */
static void draw_water(fmpq_t head, fmpq_t height, load_stage *s) {
  tp_water_description *water = &s->scene.loads.water;
  water->given = true;
  water->stays_level = draw_below(s->state, 2) == 1;
  load_stage_draw(s, &water->height, 0, 40);
  load_stage_draw(s, &water->unit_weight_kn_m3, 1, 90);
  fmpq_mul(height, water->height.value, s->scene.metres_per_unit);
  fmpq_mul(head, height, water->unit_weight_kn_m3.value);
  if (!water->stays_level) fmpq_mul(head, head, &s->cosine); /* its surface over the heel */
  fmpq_mul_si(head, head, 1000);
  fmpq_mul(head, head, &s->thickness);
}

/* Of a head that falls to nothing over a length: the force of the k-th point of Simpson's rule, and
 * its distance from where the head is whole. */
static void set_falling(fmpq_t force, fmpq_t away, const fmpq_t head, const fmpq_t length, int k) {
  fmpq_mul(away, head, length);
  fmpq_set_si(force, (2 - k) * simpson_sixths(k), 12);
  fmpq_mul(force, force, away);
  fmpq_mul_si(away, length, k);
  fmpq_div_2exp(away, away, 1);
}

/* Water behind the block presses on a face normal to the base at the heel, towards down-dip. A
 * level that stays wets the face farther up as the table tilts. */
static void try_water(load_stage *s) {
  fmpq *head = s->t, *length = s->t + 1, *force = s->t + 2, *y = s->t + 3, *none = s->t + 4;
  draw_water(head, length, s);
  if (s->scene.loads.water.stays_level) fmpq_div(length, length, &s->cosine);
  for (int k = 0; k < 3; k++) {
    set_falling(force, y, head, length, k);
    fmpq_add(y, y, &s->heel_y);
    fmpq_neg(force, force);
    load_stage_add_turning(s, force, none, &s->heel_x, y);
  }
  tp_load_water(&s->wrench, &s->setting);
  fmpq_mul(force, head, length);
  fmpq_mul_si(force, force, 12); /* before the cosine that cuts the head and the length */
  load_stage_check(s, "water", force, REACH + 40 * 12);
}

/* Under the block the head falls from the heel to nothing at the toe, and lifts normal to the base.
 */
static void try_uplift(load_stage *s) {
  fmpq *head = s->t, *length = s->t + 1, *force = s->t + 2, *x = s->t + 3, *none = s->t + 4;
  draw_water(head, length, s);
  fmpq_sub(length, &s->heel_x, &s->toe_x);
  for (int k = 0; k < 3; k++) {
    set_falling(force, x, head, length, k);
    fmpq_sub(x, &s->heel_x, x);
    load_stage_add_turning(s, none, force, x, &s->heel_y);
  }
  tp_load_uplift(&s->wrench, &s->setting);
  fmpq_mul(force, head, length);
  fmpq_mul_si(force, force, 12);
  load_stage_check(s, "uplift", force, REACH);
}

/* The most that a line bears: 30 kPa on the 29 lengths and 10 m that there are at most. */
static void set_line_force(fmpq_t force) {
  fmpq_set_si(force, 30000L * 29 * 10, 1);
}

/* A pressure pushes at each point of its line to the left of the line; to the right in the mirror
 * image that a block is seen in when it is tilted to the right. */
static void try_pressure(load_stage *s) {
  stage_line line;
  fmpq *fx = s->t, *fy = s->t + 1, *force = s->t + 2;
  stage_line_init(&line, s);
  for (int k = 0; k < 3; k++) {
    stage_line_point(force, s, &line, k);
    fmpq_mul_si(fx, force, s->setting.mirrored ? line.dy : -line.dy);
    fmpq_mul_si(fy, force, line.dx);
    load_stage_add_turning(s, fx, fy, &s->at.x, &s->at.y);
  }
  tp_load_pressure(&s->wrench, &line.load, &s->setting);
  set_line_force(force);
  load_stage_check(s, "pressure", force, LINE_REACH);
  stage_line_clear(&line);
}

/* A surcharge weighs alike on each point of its line, by the line's length and not by what of it is
 * level. */
static void try_surcharge(load_stage *s) {
  stage_line line;
  fmpq *force = s->t, *none = s->t + 1;
  stage_line_init(&line, s);
  fmpq_set(line.load.last_kpa.value, line.load.first_kpa.value);
  for (int k = 0; k < 3; k++) {
    stage_line_point(force, s, &line, k);
    fmpq_mul_si(force, force, -line.length);
    load_stage_add(s, none, force, &s->at.x, &s->at.y);
  }
  tp_load_surcharge(&s->wrench, &line.load, &s->setting);
  set_line_force(force);
  load_stage_check(s, "surcharge", force, LINE_REACH);
  stage_line_clear(&line);
}

START_TEST(weight_hangs_from_the_centroid) {
  on_stages(try_weight);
}
END_TEST

START_TEST(earthquake_pushes_level_and_lifts) {
  on_stages(try_seismic);
}
END_TEST

START_TEST(water_presses_on_the_face_behind) {
  on_stages(try_water);
}
END_TEST

START_TEST(uplift_falls_from_heel_to_toe) {
  on_stages(try_uplift);
}
END_TEST

START_TEST(pressure_pushes_into_the_block) {
  on_stages(try_pressure);
}
END_TEST

START_TEST(surcharge_weighs_on_its_line) {
  on_stages(try_surcharge);
}
END_TEST

SUITE(load) {
  state = random_numbers_from(51);
  Suite *suite = suite_create("load");
  TCase *cases = tcase_create("load");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, weight_hangs_from_the_centroid);
  tcase_add_test(cases, earthquake_pushes_level_and_lifts);
  tcase_add_test(cases, water_presses_on_the_face_behind);
  tcase_add_test(cases, uplift_falls_from_heel_to_toe);
  tcase_add_test(cases, pressure_pushes_into_the_block);
  tcase_add_test(cases, surcharge_weighs_on_its_line);
  suite_add_tcase(suite, cases);
  return suite;
}
