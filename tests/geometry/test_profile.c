/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The base of a toothed block goes on as the teeth do, as far as it is told to: its points are
 * those of the endless zigzag, in rationals. A profile that is none is refused. */

#include "base/profile.h"
#include "random_numbers.h"
#include "suite.h"

#include <string.h>

enum { ROUNDS = 3000 };

static random_numbers state;

static void draw_positive(fmpq_t value, long most) {
  fmpq_set_si(value, 1 + draw_below(&state, most), 1 + (ulong)draw_below(&state, 5));
}

/* Now and then a whole number of widths, or nothing. */
static void draw_beyond(tp_quantity *beyond, const fmpq_t width) {
  const long which = draw_below(&state, 4);
  fmpq_init(beyond->value);
  if (which == 0) return;
  draw_positive(beyond->value, 12);
  if (which == 1) fmpq_mul_si(beyond->value, width, 1 + draw_below(&state, 4));
}

static void scene_init(tp_scene *scene) {
  memset(scene, 0, sizeof *scene);
  tp_teeth *teeth = &scene->block.teeth;
  scene->block.form = TP_OUTLINE_TEETH;
  scene->base.mated = true;
  fmpq_init(teeth->width);
  fmpq_init(teeth->height);
  fmpq_init(teeth->depth);
  teeth->count = 1 + draw_below(&state, 5);
  teeth->left_end_valley = draw_below(&state, 2) == 0;
  draw_positive(teeth->width, 6);
  draw_positive(teeth->height, 9);
  draw_positive(teeth->depth, 4);
  draw_beyond(&scene->base.beyond_left, teeth->width);
  draw_beyond(&scene->base.beyond_right, teeth->width);
}

static void scene_clear(tp_scene *scene) {
  fmpq_clear(scene->block.teeth.width);
  fmpq_clear(scene->block.teeth.height);
  fmpq_clear(scene->block.teeth.depth);
  fmpq_clear(scene->base.beyond_left.value);
  fmpq_clear(scene->base.beyond_right.value);
}

/* The height of the endless zigzag: with x = (2 k + r) widths, 0 <= r < 2, it is |1 - r| depths
 * where the joint at 0 is high, 1 - |1 - r| where it is low. True where x is a joint. */
static bool zigzag(fmpq_t y, const tp_teeth *teeth, const fmpq_t x) {
  fmpq_t r;
  fmpz_t whole;
  fmpq_init(r);
  fmpz_init(whole);
  fmpq_div(r, x, teeth->width);
  const bool joint = fmpz_is_one(fmpq_denref(r));
  fmpq_div_2exp(r, r, 1);
  fmpz_fdiv_q(whole, fmpq_numref(r), fmpq_denref(r));
  fmpq_sub_fmpz(r, r, whole);
  fmpq_mul_2exp(r, r, 1);
  fmpq_sub_si(r, r, 1);
  fmpq_abs(y, r);
  if (teeth->left_end_valley) fmpq_sub_si(y, y, 1);
  fmpq_abs(y, y);
  fmpq_mul(y, y, teeth->depth);
  fmpq_clear(r);
  fmpz_clear(whole);
  return joint;
}

/* From its first point to its last one each is a joint but perhaps these two, and neighbours are
 * one width apart at most, so that no joint is left out. */
static void check_profile(const tp_base *base, const tp_scene *scene) {
  const tp_teeth *teeth = &scene->block.teeth;
  const tp_polyline *ring = &base->ring;
  fmpq_t y, step;
  fmpq_init(y);
  fmpq_init(step);
  ck_assert_int_eq(ring->count, base->edge_count + 3);
  for (long k = 0; k <= base->edge_count; k++) {
    const bool joint = zigzag(y, teeth, ring->x + k);
    ck_assert(joint || k == 0 || k == base->edge_count);
    ck_assert(fmpq_equal(y, ring->y + k));
    if (k == 0) continue;
    fmpq_sub(step, ring->x + k, ring->x + k - 1);
    ck_assert(fmpq_sgn(step) > 0 && fmpq_cmp(step, teeth->width) <= 0);
  }
  fmpq_neg(y, ring->x);
  ck_assert(fmpq_equal(y, scene->base.beyond_left.value));
  fmpq_mul_si(y, teeth->width, teeth->count);
  fmpq_add(y, y, scene->base.beyond_right.value);
  ck_assert(fmpq_equal(y, ring->x + base->edge_count));
  fmpq_clear(y);
  fmpq_clear(step);
}

/* The block's teeth are the mated edges; the rock reaches down by more than the block is high. */
static void check_mating(const tp_base *base, const tp_scene *scene) {
  const tp_polyline *ring = &base->ring;
  fmpq_t height;
  fmpq_init(height);
  ck_assert(base->mated);
  ck_assert_int_eq(base->mated_count, scene->block.teeth.count);
  ck_assert(fmpq_is_zero(ring->x + base->mated_first));
  fmpq_add(height, scene->block.teeth.height, scene->block.teeth.depth);
  fmpq_neg(height, height);
  for (long k = base->edge_count + 1; k < ring->count; k++) {
    ck_assert(fmpq_cmp(ring->y + k, height) <= 0);
    ck_assert(
        fmpq_equal(ring->x + k, ring->x + (k == base->edge_count + 1 ? base->edge_count : 0)));
  }
  fmpq_clear(height);
}

START_TEST(teeth_go_on_past_the_block) {
  state = random_numbers_from(121);
  for (int round = 0; round < ROUNDS; round++) {
    tp_scene scene;
    tp_section section;
    tp_base base;
    tp_message message = {.text = ""};
    scene_init(&scene);
    ck_assert_int_eq(tp_section_init(&section, &scene.block, &message), TP_OK);
    ck_assert_int_eq(tp_base_init(&base, &scene, &section, &message), TP_OK);
    check_profile(&base, &scene);
    check_mating(&base, &scene);
    tp_base_clear(&base);
    tp_section_clear(&section);
    scene_clear(&scene);
  }
}
END_TEST

static void append(tp_polyline *line, const long point[2]) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_set_si(x, point[0], 1);
  fmpq_set_si(y, point[1], 1);
  ck_assert(tp_polyline_append(line, x, y, (tp_mark){0}));
  fmpq_clear(x);
  fmpq_clear(y);
}

/* A profile runs from left to right, has a width, and no step up to either end; steps elsewhere,
 * and steps down to an end, are rock. */
START_TEST(profiles_that_are_none_are_refused) {
  static const struct {
    long count, points[4][2];
    const char *message; /* NULL: it is one */
  } cases[] = {
      {1, {{0, 0}}, "at least two points"},
      {2, {{0, 0}, {0, 5}}, "no width"},
      {3, {{0, 0}, {3, 0}, {2, 1}}, "point 3 lies left of point 2"},
      {3, {{0, 5}, {0, 0}, {3, 0}}, "begins with an upright step"},
      {3, {{0, 0}, {3, 0}, {3, 4}}, "ends with an upright step"},
      {3, {{0, 0}, {0, 5}, {3, 0}}, NULL},
      {3, {{0, 0}, {3, 4}, {3, 0}}, NULL},
      {4, {{0, 0}, {2, 0}, {2, 3}, {5, 3}}, NULL},
  };
  static const long block[3][2] = {{0, 9}, {4, 9}, {2, 12}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_scene scene = {0};
    tp_polyline ring = {0};
    tp_base base;
    tp_message message = {.text = ""};
    const tp_section section = {.ring_count = 1, .rings = &ring};
    for (int j = 0; j < 3; j++) append(&ring, block[j]);
    for (long j = 0; j < cases[k].count; j++) append(&scene.base.profile, cases[k].points[j]);
    const tp_status status = tp_base_init(&base, &scene, &section, &message);
    ck_assert_int_eq(status, cases[k].message == NULL ? TP_OK : TP_BAD_INPUT);
    if (cases[k].message != NULL) ck_assert_ptr_nonnull(strstr(message.text, cases[k].message));
    tp_base_clear(&base);
    tp_polyline_clear(&scene.base.profile);
    tp_polyline_clear(&ring);
  }
}
END_TEST

SUITE(profile) {
  Suite *suite = suite_create("profile");
  TCase *cases = tcase_create("profile");
  tcase_set_timeout(cases, 60);
  tcase_add_test(cases, teeth_go_on_past_the_block);
  tcase_add_test(cases, profiles_that_are_none_are_refused);
  suite_add_tcase(suite, cases);
  return suite;
}
