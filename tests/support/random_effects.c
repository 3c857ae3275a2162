/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_contact.h"
#include "random_scenes.h"

#include <math.h>
#include <stdlib.h>

/* The number times a share of `steps` steps, not zero. */
static void draw_share(fmpq_t share, const fmpq *of, long steps, random_numbers *state) {
  fmpq_set(share, of);
  fmpq_mul_si(share, share, 1 + draw_below(state, steps));
  fmpz_mul_si(fmpq_denref(share), fmpq_denref(share), steps);
  fmpq_canonicalise(share);
}

static void set_point(random_effects *e, int at, const polygon *p, long k) {
  e->x[at] = p->x[k];
  e->y[at] = p->y[k];
}

/* Height and width of the outline, in scene lengths. */
static void sizes_of(fmpq_t width, fmpq_t height, const random_scene *s) {
  const polygon *o = &s->outline;
  long least[2] = {o->x[0], o->y[0]}, most[2] = {o->x[0], o->y[0]};
  for (long k = 1; k < o->count; k++) {
    least[0] = o->x[k] < least[0] ? o->x[k] : least[0];
    least[1] = o->y[k] < least[1] ? o->y[k] : least[1];
    most[0] = o->x[k] > most[0] ? o->x[k] : most[0];
    most[1] = o->y[k] > most[1] ? o->y[k] : most[1];
  }
  fmpq_mul_si(width, s->numbers + XX, most[0] - least[0]);
  fmpq_mul_si(height, s->numbers + YY, most[1] - least[1]);
}

static double edge_length(const polygon *o, long k) {
  const long next = (k + 1) % o->count;
  return hypot((double)(o->x[next] - o->x[k]), (double)(o->y[next] - o->y[k]));
}

/* Of radii that mostly fit the edges beside them. */
static void draw_corners(random_scene *s, random_numbers *state) {
  random_effects *e = &s->effects;
  const polygon *o = &s->outline;
  e->paper_model = draw_once_in(state, 3);
  e->corners = 1 + (int)draw_below(state, CORNERS_MOST);
  for (int c = 0; c < e->corners; c++) {
    const long k = draw_below(state, o->count);
    const double least = fmin(edge_length(o, k), edge_length(o, (k + o->count - 1) % o->count));
    fmpq *radius = e->numbers + RADII + c;
    e->places[c] = (random_place)draw_below(state, 4);
    if (e->places[c] > AT_VERTEX) e->places[c] = AT_VERTEX;
    set_point(e, AT_CORNERS + c, o, k);
    fmpq_mul_si(radius, s->numbers + XX, lround(least) * (1 + draw_below(state, 16)));
    fmpq_div_2exp(radius, radius, 5);
  }
}

/* Edges that run to the left, which are above the block, bent out or in. */
static void draw_arcs(random_scene *s, random_numbers *state) {
  random_effects *e = &s->effects;
  const polygon *o = &s->outline;
  const long first = draw_below(state, o->count);
  for (long i = 0; i < o->count && e->arcs < ARCS_MOST; i++) {
    const long k = (first + i) % o->count, next = (k + 1) % o->count;
    if (o->x[next] >= o->x[k] || !draw_once_in(state, 2)) continue;
    const int bulge = (int)draw_signed(state, 12);
    if (bulge == 0) continue;
    set_point(e, AT_ARCS + 2 * e->arcs, o, k);
    set_point(e, AT_ARCS + 2 * e->arcs + 1, o, next);
    e->bulges[e->arcs++] = bulge;
  }
}

static void draw_line(random_scene *s, int at, random_numbers *state) {
  const polygon *o = &s->outline;
  const long k = draw_below(state, o->count), next = (k + 1) % o->count;
  random_effects *e = &s->effects;
  set_point(e, at, o, k);
  set_point(e, at + 1, o, next);
  const long dx = o->x[next] - o->x[k], dy = o->y[next] - o->y[k];
  if (dx % 2 == 0 && dy % 2 == 0 && draw_once_in(state, 2)) {
    e->x[at] += dx / 2;
    e->y[at] += dy / 2;
  }
}

static void draw_water(random_scene *s, const fmpq *height, random_numbers *state) {
  random_effects *e = &s->effects;
  fmpq *n = e->numbers;
  e->water = true;
  e->uplift = draw_once_in(state, 2);
  e->stays_level = draw_once_in(state, 2);
  draw_share(n + WATER_HEIGHT, height, 5, state);
  if (draw_once_in(state, 3)) fmpq_div_2exp(n + WATER_HEIGHT, n + WATER_HEIGHT, 2);
  fmpq_set_si(n + WATER_WEIGHT, 981, 100);
  if (draw_once_in(state, 3)) fmpq_set_si(n + WATER_WEIGHT, 1 + draw_below(state, 26), 1);
}

static void draw_loads(random_scene *s, const fmpq *width, const fmpq *height,
                       random_numbers *state) {
  random_effects *e = &s->effects;
  fmpq *n = e->numbers;
  fmpq_t stress, force; /* of the block's own weight */
  fmpq_init(stress);
  fmpq_init(force);
  fmpq_mul(stress, height, &random_units[s->unit].metres);
  fmpq_mul_si(stress, stress, BLOCK_WEIGHT);
  fmpq_mul(force, width, &random_units[s->unit].metres);
  fmpq_mul(force, force, stress);
  if (draw_once_in(state, 3)) {
    e->seismic = true;
    fmpq_set_si(n + HORIZONTAL, draw_below(state, 8), 16);
    fmpq_set_si(n + VERTICAL, draw_signed(state, 4), 16);
    fmpq_canonicalise(n + HORIZONTAL);
    fmpq_canonicalise(n + VERTICAL);
  }
  if (draw_once_in(state, 3)) draw_water(s, height, state);
  e->pressures = draw_once_in(state, 4) ? 1 + (int)draw_below(state, LINES_MOST) : 0;
  e->surcharges = draw_once_in(state, 4) ? 1 + (int)draw_below(state, LINES_MOST) : 0;
  e->anchors = draw_once_in(state, 3) ? 1 + (int)draw_below(state, ANCHORS_MOST) : 0;
  for (int k = 0; k < LINES_MOST; k++) {
    draw_line(s, AT_PRESSURES + 2 * k, state);
    draw_line(s, AT_SURCHARGES + 2 * k, state);
    for (int end = 0; end < 2; end++) draw_share(n + STRESSES + 2 * k + end, stress, 7, state);
    draw_share(n + SURCHARGES + k, stress, 7, state);
  }
  for (int k = 0; k < ANCHORS_MOST; k++) {
    set_point(e, AT_ANCHORS + k, &s->outline, draw_below(state, s->outline.count));
    draw_share(n + FORCES + k, force, 9, state);
    fmpq_set_si(n + DIRECTIONS + k, draw_signed(state, 12) * 15, 1);
    e->passive[k] = draw_once_in(state, 2);
  }
  for (int k = BOND; k <= COHESION; k++) {
    if (!draw_once_in(state, 3)) continue;
    draw_share(n + k, stress, 9, state);
    if (draw_once_in(state, 6)) fmpq_div_2exp(n + k, n + k, (ulong)draw_below(state, 60));
  }
  fmpq_clear(stress);
  fmpq_clear(force);
}

static void draw_law(random_scene *s, const fmpq *height, random_numbers *state) {
  random_effects *e = &s->effects;
  fmpq *n = e->numbers;
  e->law = (random_law)(1 + draw_below(state, 4));
  fmpq_set_si(n + ROUGHNESS, draw_below(state, 30), 1);
  fmpq_set_si(n + JRC, draw_below(state, 41), 2);
  fmpq_canonicalise(n + JRC);
  fmpq_set_si(n + TEST_ANGLE, 40 + draw_below(state, 50), 1);
  fmpq_mul(n + STRENGTH, height, &random_units[s->unit].metres); /* kPa: 26 to 10^5 of its weight */
  fmpq_mul_si(n + STRENGTH, n + STRENGTH, BLOCK_WEIGHT * (1 + draw_below(state, 4000)));
  draw_share(n + TEST_STRESS, n + STRENGTH, 1000, state);
  fmpq_set_si(s->numbers + FRICTION, 10 + draw_below(state, 30), 1);
}

void random_effects_draw(random_scene *s, random_numbers *state) {
  random_effects *e = &s->effects;
  fmpq_t width, height;
  fmpq_init(width);
  fmpq_init(height);
  if (draw_once_in(state, 4)) random_contact_draw_wall(s, state);
  if (draw_once_in(state, 4)) random_contact_draw_kinks(s, state);
  sizes_of(width, height, s);
  fmpq_set_si(e->numbers + THICKNESS, 1 + draw_below(state, 20), 4);
  fmpq_div(e->numbers + THICKNESS, e->numbers + THICKNESS, &random_units[s->unit].metres);
  e->towards = (random_towards)draw_below(state, 3);
  if (draw_once_in(state, 16)) {
    e->ellipse = true;
    s->hole.count = s->part.count = s->profile.count = 0;
    fmpq_set(e->numbers + ELLIPSE_WIDTH, width);
    fmpq_set(e->numbers + ELLIPSE_HEIGHT, height);
    draw_share(e->numbers + ELLIPSE_FLAT, width, 9, state);
  }
  if (draw_once_in(state, 2)) draw_loads(s, width, height, state);
  if (draw_once_in(state, 6)) draw_law(s, height, state);
  if (e->ellipse) {
    e->pressures = e->surcharges = 0;
  } else {
    if (draw_once_in(state, 3)) draw_corners(s, state);
    if (draw_once_in(state, 6)) draw_arcs(s, state);
    if (s->profile.count == 0 && draw_once_in(state, 5)) {
      const long k = draw_below(state, s->outline.count);
      e->has_between = true;
      set_point(e, AT_BETWEEN, &s->outline, k);
      set_point(e, AT_BETWEEN + 1, &s->outline, (k + 1 + draw_below(state, 2)) % s->outline.count);
    }
  }
  fmpq_clear(width);
  fmpq_clear(height);
  random_site_draw(s, state);
}

bool random_effects_allow(const random_effects *e) {
  return !fmpq_is_zero(e->numbers + BOND) || !fmpq_is_zero(e->numbers + COHESION);
}

bool random_effects_load(const random_effects *e) {
  return e->seismic || e->water || e->pressures > 0 || e->surcharges > 0 || e->anchors > 0 ||
         random_effects_allow(e);
}

bool random_effects_turn(const random_effects *e) {
  bool turns = e->law == LAW_NONE && !random_effects_load(e) && !e->ellipse && !e->slope;
  for (int k = 0; k < e->corners; k++) turns = turns && e->places[k] == AT_VERTEX;
  return turns;
}

static bool is_edge(const random_effects *e, int at, const long from[2], const long to[2]) {
  return e->x[at] == from[0] && e->y[at] == from[1] && e->x[at + 1] == to[0] &&
         e->y[at + 1] == to[1];
}

/* Does the point at `at` lie on the line through the edge, between its ends? */
static bool touches(const random_effects *e, int at, const long from[2], const long to[2]) {
  const __int128 dx = to[0] - from[0], dy = to[1] - from[1];
  const __int128 px = e->x[at] - from[0], py = e->y[at] - from[1];
  const __int128 along = dx * px + dy * py;
  return dx * py == dy * px && along >= 0 && along <= dx * dx + dy * dy;
}

bool random_effects_need_edge(const random_effects *e, const long from[2], const long to[2]) {
  for (int k = 0; k < e->arcs; k++) {
    if (is_edge(e, AT_ARCS + 2 * k, from, to) || is_edge(e, AT_ARCS + 2 * k, to, from)) return true;
  }
  for (int k = 0; k < 2 * LINES_MOST; k++) {
    const int lines = k < LINES_MOST ? e->pressures : e->surcharges;
    const int at = (k < LINES_MOST ? AT_PRESSURES : AT_SURCHARGES) + 2 * (k % LINES_MOST);
    if (k % LINES_MOST < lines && touches(e, at, from, to) && touches(e, at + 1, from, to)) {
      return true;
    }
  }
  return false;
}

static void swap_points(random_effects *e, int one, int other) {
  const long x = e->x[one], y = e->y[one];
  e->x[one] = e->x[other];
  e->y[one] = e->y[other];
  e->x[other] = x;
  e->y[other] = y;
}

/* The scene's map mirrors the points; lines then run the other way about the block. */
void random_effects_mirror(random_effects *e) {
  for (int k = 0; k < CORNERS_MOST; k++) {
    if (e->places[k] != AT_VERTEX) {
      e->places[k] = e->places[k] == AT_LEFT_END ? AT_RIGHT_END : AT_LEFT_END;
    }
  }
  for (int k = 0; k < LINES_MOST; k++) {
    swap_points(e, AT_PRESSURES + 2 * k, AT_PRESSURES + 2 * k + 1);
    swap_points(e, AT_SURCHARGES + 2 * k, AT_SURCHARGES + 2 * k + 1);
    fmpq_swap(e->numbers + STRESSES + 2 * k, e->numbers + STRESSES + 2 * k + 1);
  }
  swap_points(e, AT_BETWEEN, AT_BETWEEN + 1);
  for (int k = DIRECTIONS; k < DIRECTIONS + ANCHORS_MOST; k++) {
    fmpq_neg(e->numbers + k, e->numbers + k);
    fmpq_add_si(e->numbers + k, e->numbers + k, 180);
  }
  if (e->towards != TOWARDS_BOTH) {
    e->towards = e->towards == TOWARDS_LEFT ? TOWARDS_RIGHT : TOWARDS_LEFT;
  }
}

void random_effects_lengthen(random_effects *e, const fmpq *factor) {
  for (int k = RADII; k < STRESSES; k++) fmpq_mul(e->numbers + k, e->numbers + k, factor);
}

void random_effects_load_more(random_effects *e, const fmpq *factor) {
  for (int k = STRESSES; k < PLAIN_NUMBERS; k++) fmpq_mul(e->numbers + k, e->numbers + k, factor);
  for (int k = FORCES; k < PLAIN_NUMBERS; k++) fmpq_mul(e->numbers + k, e->numbers + k, factor);
}
