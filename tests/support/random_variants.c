/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_variants.h"
#include "random_turn.h"

/* By less than the scene's size, to where doubles hold no coordinate. */
static bool nudge(random_scene *s, relation *r, random_numbers *state) {
  if (s->effects.ellipse) return false;
  fmpq_t by;
  fmpq_init(by);
  for (int axis = 0; axis < 2; axis++) {
    fmpq_set_si(by, draw_signed(state, 30), 3 + 4 * (ulong)draw_below(state, 2));
    fmpq_mul(by, by, s->numbers + YY);
    fmpq_add(s->numbers + MOVE_X + axis, s->numbers + MOVE_X + axis, by);
    fmpq_mul(r->numbers + SHIFT_X + axis, by, &random_units[s->unit].metres);
  }
  fmpq_clear(by);
  return true;
}

/* Far off on one axis or both: by up to 10^40 lengths, or many digits of one. */
static bool move(random_scene *s, relation *r, random_numbers *state) {
  if (s->effects.ellipse) return false;
  fmpq_t by;
  fmpq_init(by);
  for (int axis = 0; axis < 2; axis++) {
    fmpz_ui_pow_ui(fmpq_numref(by), 10, (ulong)draw_below(state, 41));
    fmpz_set_ui(fmpq_denref(by), 1 + draw(state) % 1000);
    fmpq_canonicalise(by);
    fmpq_mul_si(by, by, draw_signed(state, 9));
    fmpq_add(s->numbers + MOVE_X + axis, s->numbers + MOVE_X + axis, by);
    fmpq_mul(r->numbers + SHIFT_X + axis, by, &random_units[s->unit].metres);
  }
  fmpq_clear(by);
  return true;
}

static void multiply_lengths(random_scene *s, const fmpq *factor) {
  for (int k = 0; k < MAP_NUMBERS; k++) fmpq_mul(s->numbers + k, s->numbers + k, factor);
  for (int k = BEYOND_LEFT; k <= BEYOND_RIGHT; k++) {
    fmpq_mul(s->numbers + k, s->numbers + k, factor);
  }
  random_effects_lengthen(&s->effects, factor);
}

void random_scene_make_even(random_scene *s) {
  for (int k = BEYOND_LEFT; k <= BEYOND_RIGHT; k++) {
    fmpq_div(s->numbers + k, s->numbers + k, s->numbers + XX);
  }
  for (int k = XX; k < MAP_NUMBERS; k++) {
    fmpq_set_si(s->numbers + k, k == XX || k == YY ? 1 : 0, 1);
  }
  random_scene_double(s, 1);
}

void random_scene_double(random_scene *s, int power) {
  fmpq_t factor;
  fmpq_init(factor);
  fmpq_set_si(factor, 1, 1);
  fmpq_mul_2exp(factor, factor, (ulong)power);
  multiply_lengths(s, factor);
  fmpq_clear(factor);
}

static bool scale_by(random_scene *s, relation *r, const fmpq *factor) {
  multiply_lengths(s, factor);
  random_effects_load_more(&s->effects, factor);
  fmpq_set(r->numbers + MAP_XX, factor);
  fmpq_set(r->numbers + MAP_YY, factor);
  fmpq_set(r->numbers + LENGTH, factor);
  return true;
}

static bool scale(random_scene *s, relation *r, random_numbers *state) {
  fmpq_t factor;
  fmpq_init(factor);
  fmpq_set_si(factor, 1 + draw_below(state, 1000000), (ulong)(1 + draw_below(state, 1000000)));
  (void)scale_by(s, r, factor);
  fmpq_clear(factor);
  return true;
}

static bool scale_by_ten(random_scene *s, relation *r, random_numbers *state) {
  fmpq_t factor;
  fmpq_init(factor);
  fmpz_one(fmpq_denref(factor));
  fmpz_ui_pow_ui(fmpq_numref(factor), 10, (ulong)draw_below(state, 30));
  if (draw_once_in(state, 2)) fmpq_inv(factor, factor);
  (void)scale_by(s, r, factor);
  fmpq_clear(factor);
  return true;
}

static bool scale_by_two(random_scene *s, relation *r, random_numbers *state) {
  fmpq_t factor;
  fmpq_init(factor);
  fmpq_set_si(factor, 1, 1);
  fmpq_mul_2exp(factor, factor, (ulong)draw_below(state, 100));
  if (draw_once_in(state, 2)) fmpq_inv(factor, factor);
  (void)scale_by(s, r, factor);
  fmpq_clear(factor);
  return true;
}

/* The same lengths, in another unit. */
static bool change_unit(random_scene *s, relation *r, random_numbers *state) {
  (void)r;
  fmpq_t factor;
  fmpq_init(factor);
  const int unit = (s->unit + 1 + (int)draw_below(state, UNITS - 1)) % UNITS;
  fmpq_div(factor, &random_units[s->unit].metres, &random_units[unit].metres);
  multiply_lengths(s, factor);
  fmpq_mul(s->effects.numbers + THICKNESS, s->effects.numbers + THICKNESS, factor);
  fmpq_mul(s->effects.numbers + SPACING, s->effects.numbers + SPACING, factor);
  s->unit = unit;
  fmpq_clear(factor);
  return true;
}

static void reverse(polygon *p) {
  for (long k = 0; k < p->count / 2; k++) {
    const long other = p->count - 1 - k, x = p->x[k], y = p->y[k];
    p->x[k] = p->x[other];
    p->y[k] = p->y[other];
    p->x[other] = x;
    p->y[other] = y;
  }
}

/* Left for right. The outline is then clockwise. */
static bool mirror(random_scene *s, relation *r, random_numbers *state) {
  (void)state;
  static const int mirrored[] = {XX, XY, MOVE_X};
  for (size_t k = 0; k < sizeof mirrored / sizeof *mirrored; k++) {
    fmpq_neg(s->numbers + mirrored[k], s->numbers + mirrored[k]);
  }
  fmpq_swap(s->numbers + BEYOND_LEFT, s->numbers + BEYOND_RIGHT);
  reverse(&s->profile);
  random_effects_mirror(&s->effects);
  fmpq_set_si(r->numbers + MAP_XX, -1, 1);
  r->mirrored = true;
  return true;
}

static bool repeats_the_one_before(const polygon *p, long k) {
  const long before = (k + p->count - 1) % p->count;
  return p->x[k] == p->x[before] && p->y[k] == p->y[before];
}

/* A ring may close by its first vertex once more, but not repeat another. */
static bool renumber(random_scene *s, relation *r, random_numbers *state) {
  (void)r;
  polygon *rings[] = {&s->outline, &s->hole, &s->part};
  for (size_t i = 0; i < sizeof rings / sizeof *rings; i++) {
    const polygon old = *rings[i];
    long first = old.count > 0 ? draw_below(state, old.count) : 0;
    while (first > 0 && repeats_the_one_before(&old, first)) first--;
    for (long k = 0; k < old.count; k++) {
      rings[i]->x[k] = old.x[(first + k) % old.count];
      rings[i]->y[k] = old.y[(first + k) % old.count];
    }
    if (draw_once_in(state, 2)) reverse(rings[i]);
  }
  return true;
}

/* Twice as large before a map of half the size, with the middles of some edges as vertices. */
static void subdivide(polygon *p, const random_effects *e, bool closed, random_numbers *state) {
  const polygon old = *p;
  p->count = 0;
  for (long k = 0; k < old.count; k++) {
    const long next = (k + 1) % old.count;
    polygon_add(p, 2 * old.x[k], 2 * old.y[k]);
    if (draw_once_in(state, 2) && (closed || next > 0) &&
        !random_effects_need_edge(e, (const long[]){old.x[k], old.y[k]},
                                  (const long[]){old.x[next], old.y[next]})) {
      polygon_add(p, old.x[k] + old.x[next], old.y[k] + old.y[next]);
    }
  }
}

static bool add_vertices(random_scene *s, relation *r, random_numbers *state) {
  random_effects *e = &s->effects;
  if (e->ellipse || e->corners > 0) return false; /* a rounding must fit the pieces of its edges */
  subdivide(&s->outline, e, true, state);
  subdivide(&s->hole, e, true, state);
  subdivide(&s->part, e, true, state);
  subdivide(&s->profile, e, false, state);
  for (int k = 0; k < EFFECT_POINTS; k++) {
    e->x[k] *= 2;
    e->y[k] *= 2;
  }
  for (int k = XX; k <= YY; k++) fmpq_div_2exp(s->numbers + k, s->numbers + k, 1);
  r->more_vertices = true;
  return true;
}

/* (b - a) x ((x, y) - a) */
static __int128 cross(const polygon *p, long a, long b, long x, long y) {
  return (__int128)(p->x[b] - p->x[a]) * (y - p->y[a]) -
         (__int128)(p->y[b] - p->y[a]) * (x - p->x[a]);
}

/* Is the triangle of three vertices that follow each other inside, with no other vertex in it? */
static bool is_ear(const polygon *p, const long corner[3]) {
  if (cross(p, corner[0], corner[1], p->x[corner[2]], p->y[corner[2]]) <= 0) return false;
  for (long k = 0; k < p->count; k++) {
    bool inside = true, is_corner = false;
    for (int i = 0; i < 3; i++) {
      inside = inside && cross(p, corner[i], corner[(i + 1) % 3], p->x[k], p->y[k]) >= 0;
      is_corner = is_corner || k == corner[i];
    }
    if (inside && !is_corner) return false;
  }
  return true;
}

/* A part of the block's own density: an ear of the outline. */
static bool part_out(random_scene *s, relation *r, random_numbers *state) {
  (void)r;
  const polygon *o = &s->outline;
  if (s->part.count > 0 || s->hole.count > 0 || s->effects.ellipse || s->effects.arcs > 0 ||
      s->effects.corners > 0) {
    return false;
  }
  const long first = draw_below(state, o->count);
  for (long k = 0; k < o->count; k++) {
    const long corner[3] = {(first + k) % o->count, (first + k + 1) % o->count,
                            (first + k + 2) % o->count};
    if (!is_ear(o, corner)) continue;
    for (int i = 0; i < 3; i++) polygon_add(&s->part, o->x[corner[i]], o->y[corner[i]]);
    s->part_weight = BLOCK_WEIGHT;
    return true;
  }
  return false;
}

const random_variant random_variants[VARIANTS] = {
    {"moved", move},
    {"nudged", nudge},
    {"scaled", scale},
    {"scaled by a power of ten", scale_by_ten},
    {"scaled by a power of two", scale_by_two},
    {"in another unit", change_unit},
    {"mirrored", mirror},
    {"renumbered", renumber},
    {"with vertices on its edges", add_vertices},
    {"with a part of the same density", part_out},
    {"turned with its base", random_turn},
};
