/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const random_unit random_units[UNITS] = {{"m", {1, 1}},       {"mm", {1, 1000}},
                                         {"cm", {1, 100}},    {"km", {1000, 1}},
                                         {"in", {127, 5000}}, {"ft", {381, 1250}}};

static void draw_star_block(random_scene *s, random_numbers *state) {
  const double radius = draw_once_in(state, 2) ? 4 : 1000;
  const long count = 3 + draw_below(state, radius < 5 ? 4 : 22);
  draw_star(&s->outline, count, radius, draw_once_in(state, 3) ? radius / 3 : radius, state);
  for (long k = 0; k < s->outline.count; k++) {
    s->outline.x[k] *= GRAIN;
    s->outline.y[k] *= GRAIN;
  }
}

/* A triangle in the left half and a rectangle in the right half of an upright body. */
static void draw_inside(random_scene *s, long width, long bottom, long height,
                        random_numbers *state) {
  const long w = width / GRAIN, h = height / GRAIN;
  if (draw_once_in(state, 4)) {
    polygon_add(&s->hole, w, bottom + 3 * h);
    polygon_add(&s->hole, 3 * w, bottom + 3 * h);
    polygon_add(&s->hole, 2 * w, bottom + 6 * h);
  }
  if (draw_once_in(state, 4)) {
    polygon_add(&s->part, 5 * w, bottom + 2 * h);
    polygon_add(&s->part, 7 * w, bottom + 2 * h);
    polygon_add(&s->part, 7 * w, bottom + 5 * h);
    polygon_add(&s->part, 5 * w, bottom + 5 * h);
    s->part_weight = 1 + draw_below(state, 50);
  }
}

/* The first `count` vertices of the outline, some of them lowered, the first one kept; sometimes it
 * goes on past the block, level or down. */
static void draw_profile(random_scene *s, long count, random_numbers *state) {
  const polygon *o = &s->outline;
  const bool lowers = draw_once_in(state, 2);
  if (draw_once_in(state, 3)) {
    polygon_add(&s->profile, o->x[0] - GRAIN * (1 + draw_below(state, 30)),
                o->y[0] - draw_below(state, 3 * GRAIN));
  }
  for (long k = 0; k < count; k++) {
    const bool lowered = lowers && k > 0 && draw_once_in(state, 3);
    polygon_add(&s->profile, o->x[k], o->y[k] - (lowered ? 1 + draw_below(state, 9) : 0));
  }
  if (draw_once_in(state, 3)) {
    polygon_add(&s->profile, o->x[count - 1] + GRAIN * (1 + draw_below(state, 30)),
                o->y[count - 1] - draw_below(state, 3 * GRAIN));
  }
}

/* An underside of `steps` facets, regular teeth or rough; above it a body that leans or stands
 * upright. A leaning side stays clear of the teeth below it while it moves by less than their width
 * over their depth. */
static void draw_body(random_scene *s, random_numbers *state) {
  const bool small = draw_once_in(state, 2), regular = draw_once_in(state, 2);
  const long steps = 1 + draw_below(state, draw_once_in(state, 250) ? 200 : small ? 3 : 9);
  const long width = GRAIN * (1 + draw_below(state, small ? 4 : 40));
  const long depth = GRAIN * draw_below(state, small ? 3 : 20), phase = draw_below(state, 2);
  const long height = GRAIN * (1 + draw_below(state, small ? 8 : 60 + 8 * steps));
  polygon *o = &s->outline;
  for (long k = 0, x = 0; k <= steps; k++) {
    const long low = regular ? (k + phase) % 2 * depth : draw_below(state, depth + 1);
    polygon_add(o, x, low);
    x += regular ? width : GRAIN * (1 + draw_below(state, width / GRAIN));
  }
  const long right = o->x[steps], room = depth > 0 ? (height + depth) / depth : 8;
  const long lean = draw_once_in(state, 2) ? 0 : draw_signed(state, GRAIN * room) / 2;
  polygon_add(o, right + lean, depth + height);
  polygon_add(o, lean, depth + height);
  if (lean == 0) draw_inside(s, right, depth, height, state);
  if (lean != 0 || draw_once_in(state, 3)) draw_profile(s, steps + 1, state);
}

/* On a level foot from 0 to `foot`, wider above, to either side. */
static void draw_overhang(random_scene *s, random_numbers *state) {
  const long foot = GRAIN * (1 + draw_below(state, 6)), neck = GRAIN * (1 + draw_below(state, 5));
  const long left = GRAIN * draw_below(state, 5), right = GRAIN * (1 + draw_below(state, 5));
  const long top = neck + GRAIN * (1 + draw_below(state, 5));
  polygon *o = &s->outline;
  polygon_add(o, 0, 0);
  polygon_add(o, foot, 0);
  polygon_add(o, foot, neck);
  polygon_add(o, foot + right, neck);
  polygon_add(o, foot + right, top);
  polygon_add(o, -left, top);
  if (left > 0) polygon_add(o, -left, neck);
  if (left > 0) polygon_add(o, 0, neck);
  if (draw_once_in(state, 2)) draw_profile(s, 2, state);
}

/* Two pivots in one line with the centroid, both admissible where the block is tilted to the left:
 * a facet that falls to the right from the one, a level one to the right from the other, higher
 * one. The outline is its own mirror image in a point, which is its centroid then. Or almost in one
 * line: off it by one or two parts in 10^15, which doubles do not tell apart. */
static void draw_tied(random_scene *s, random_numbers *state) {
  const bool almost = draw_once_in(state, 2);
  const long grain = almost ? (long)GRAIN << 44 : GRAIN, off = almost ? draw_signed(state, 2) : 0;
  const long dx = grain * (2 + draw_below(state, 3)), dy = grain * (1 + draw_below(state, 4));
  const long times = 2 + draw_below(state, 3), drop = grain * (1 + dx / dy + draw_below(state, 3));
  const long right = 2 * times * dx, top = 2 * times * dy;
  const long chain[4][2] = {{0, 0}, {grain, -drop}, {dx, dy + off}, {dx + grain, dy + off}};
  for (int k = 0; k < 8; k++) {
    const long *p = chain[k % 4];
    polygon_add(&s->outline, k < 4 ? p[0] : right - p[0], k < 4 ? p[1] : top - p[1]);
  }
  polygon_add(&s->profile, 0, 0);
  polygon_add(&s->profile, grain, -drop);
  polygon_add(&s->profile, grain, -2 * drop);
  polygon_add(&s->profile, dx, -2 * drop);
  polygon_add(&s->profile, dx, dy + off);
  polygon_add(&s->profile, dx + grain, dy + off);
}

/* A length of about 1, of one of many kinds, or of very many digits. */
static void draw_factor(fmpq_t factor, random_numbers *state) {
  fmpz *top = fmpq_numref(factor), *below = fmpq_denref(factor);
  fmpz_one(top);
  fmpz_one(below);
  const unsigned long power = (unsigned long)draw_below(state, 19);
  switch (draw_below(state, 8)) {
  case 0:
    fmpz_ui_pow_ui(top, 10, power);
    break;
  case 1:
    fmpz_ui_pow_ui(below, 10, power);
    break;
  case 2:
    fmpz_set_ui(below, 3 + power);
    break;
  case 3:
    fmpz_set_ui(top, 1 + (draw(state) >> 34));
    fmpz_set_ui(below, 1 + (draw(state) >> 34));
    break;
  case 4:
    fmpz_ui_pow_ui(top, 7 + power, 40);
    fmpz_ui_pow_ui(below, 10, 40);
    break;
  default:
    break;
  }
  fmpq_canonicalise(factor);
}

static void draw_map(random_scene *s, random_numbers *state) {
  fmpq *n = s->numbers;
  draw_factor(n + XX, state);
  fmpq_set(n + YY, n + XX);
  if (draw_once_in(state, 3)) { /* an upright shear keeps a profile in order */
    fmpq_mul_si(n + YX, n + XX, draw_signed(state, 500));
    fmpq_div_2exp(n + YX, n + YX, 10);
  }
  if (draw_once_in(state, 4)) {
    for (int k = MOVE_X; k <= MOVE_Y; k++) {
      draw_factor(n + k, state);
      fmpq_mul_si(n + k, n + k, draw_signed(state, 1000000));
    }
  }
}

/* From 0 to `most` degrees: whole, or any number of sevenths. */
static void draw_angle(fmpq_t angle, long most, random_numbers *state) {
  const bool whole = draw_once_in(state, 2);
  fmpq_set_si(angle, draw_below(state, whole ? most + 1 : 7 * most), whole ? 1 : 7);
}

/* A ring may close by its first vertex once more, but not have it twice elsewhere. */
static void drop_closing(polygon *p) {
  const long last = p->count - 1;
  if (last > 0 && p->x[last] == p->x[0] && p->y[last] == p->y[0]) p->count--;
}

void random_scene_draw(random_scene *s, random_numbers *state) {
  memset(s, 0, sizeof *s);
  for (int k = 0; k < NUMBERS; k++) fmpq_init(s->numbers + k);
  for (int k = 0; k < EFFECT_NUMBERS; k++) fmpq_init(s->effects.numbers + k);
  const long kind = draw_below(state, 8);
  if (kind == 0) draw_star_block(s, state);
  if (kind == 1) draw_overhang(s, state);
  if (kind == 2) draw_tied(s, state);
  if (kind > 2) draw_body(s, state);
  drop_closing(&s->outline);
  draw_map(s, state);
  s->unit = (int)draw_below(state, UNITS);
  s->beyond_stated = s->profile.count == 0 && draw_once_in(state, 2);
  for (int k = BEYOND_LEFT; k <= BEYOND_RIGHT && s->beyond_stated; k++) {
    fmpq_mul_si(s->numbers + k, s->numbers + XX, draw_below(state, 3) * draw_below(state, 100));
  }
  s->has_friction = !draw_once_in(state, 8);
  s->has_tilt = !draw_once_in(state, 4);
  draw_angle(s->numbers + FRICTION, 89, state);
  draw_angle(s->numbers + TILT, 90, state);
  const long degenerate = draw_below(state, 8);
  if (degenerate < 3) fmpq_set_si(s->numbers + TILT, 45 * degenerate, 1);
  if (degenerate == 3) fmpq_set(s->numbers + TILT, s->numbers + FRICTION);
  if (draw_once_in(state, 8)) fmpq_set_si(s->numbers + FRICTION, 45, 1);
}

void random_scene_copy(random_scene *copy, const random_scene *s) {
  *copy = *s;
  for (int k = 0; k < NUMBERS; k++) {
    fmpq_init(copy->numbers + k);
    fmpq_set(copy->numbers + k, s->numbers + k);
  }
  for (int k = 0; k < EFFECT_NUMBERS; k++) {
    fmpq_init(copy->effects.numbers + k);
    fmpq_set(copy->effects.numbers + k, s->effects.numbers + k);
  }
}

void random_scene_clear(random_scene *s) {
  for (int k = 0; k < NUMBERS; k++) fmpq_clear(s->numbers + k);
  for (int k = 0; k < EFFECT_NUMBERS; k++) fmpq_clear(s->effects.numbers + k);
}

static void map_row(fmpq_t result, const fmpq *by_x, const fmpq *by_y, const fmpq *move, long x,
                    long y) {
  fmpq_t term;
  fmpq_init(term);
  fmpq_mul_si(result, by_x, x);
  fmpq_mul_si(term, by_y, y);
  fmpq_add(result, result, term);
  fmpq_add(result, result, move);
  fmpq_clear(term);
}

void random_scene_map(fmpq_t x, fmpq_t y, const random_scene *s, long from_x, long from_y) {
  const fmpq *n = s->numbers;
  map_row(x, n + XX, n + XY, n + MOVE_X, from_x, from_y);
  map_row(y, n + YX, n + YY, n + MOVE_Y, from_x, from_y);
}

void random_scene_vertex(fmpq_t x, fmpq_t y, const random_scene *s, const polygon *ring, long k) {
  random_scene_map(x, y, s, ring->x[k], ring->y[k]);
}
