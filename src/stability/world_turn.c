/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/world_turn.h"

#include "block/section.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

/* Binary digits to which the root k and the dip are cut (stability/world.h): a share of 2^-256 is
 * below 1e-77, and a scene of the world may be asked for TP_WORLD_DIGITS, 60. */
enum { CUT_BITS = 256 };

void tp_turn_init(tp_turn *turn) {
  fmpq *const all[] = {turn->dip_deg, turn->x, turn->y, turn->cosine, turn->sine};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
  turn->rises = 0;
}

void tp_turn_clear(tp_turn *turn) {
  fmpq *const all[] = {turn->dip_deg, turn->x, turn->y, turn->cosine, turn->sine};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

void tp_turn_set(tp_turn *w, const fmpq_t u, const fmpq_t v) {
  fmpz_t p, q, square, root, rest;
  fmpz_init(p);
  fmpz_init(q);
  fmpz_init(square);
  fmpz_init(root);
  fmpz_init(rest);
  fmpq_div(w->cosine, v, u); /* q / p in lowest terms */
  fmpz_set(q, fmpq_numref(w->cosine));
  fmpz_set(p, fmpq_denref(w->cosine));
  fmpz_mul(square, p, p);
  fmpz_addmul(square, q, q);
  fmpz_sqrtrem(root, rest, square);
  unsigned long cut = 0;
  if (!fmpz_is_zero(rest)) {
    cut = CUT_BITS;
    fmpz_mul_2exp(square, square, 2 * cut);
    fmpz_sqrt(root, square);
  }
  fmpq_set_fmpz_frac(w->cosine, p, root);
  fmpq_set_fmpz_frac(w->sine, q, root);
  fmpq_mul_2exp(w->cosine, w->cosine, cut);
  fmpq_mul_2exp(w->sine, w->sine, cut);
  w->rises = fmpz_sgn(q);
  arb_t x, y;
  arf_t above;
  arb_init(x);
  arb_init(y);
  arf_init(above);
  fmpz_abs(q, q);
  arb_set_fmpz(x, p);
  arb_set_fmpz(y, q);
  tp_ball_atan2_degrees(y, y, x, 2 * CUT_BITS);
  arb_mul_2exp_si(y, y, CUT_BITS);
  arb_get_ubound_arf(above, y, 4 * CUT_BITS);
  arf_get_fmpz(fmpq_numref(w->dip_deg), above, ARF_RND_CEIL);
  fmpz_one(fmpq_denref(w->dip_deg));
  fmpq_div_2exp(w->dip_deg, w->dip_deg, CUT_BITS);
  arb_clear(x);
  arb_clear(y);
  arf_clear(above);
  fmpz_clear(p);
  fmpz_clear(q);
  fmpz_clear(square);
  fmpz_clear(root);
  fmpz_clear(rest);
}

/* The point about which it turns stays: x' = x0 + c (x - x0) + s (y - y0). */
static void turn_point(fmpq_t x, fmpq_t y, const tp_turn *w) {
  fmpq_t dx, dy;
  fmpq_init(dx);
  fmpq_init(dy);
  fmpq_sub(dx, x, w->x);
  fmpq_sub(dy, y, w->y);
  fmpq_mul(x, w->cosine, dx);
  fmpq_addmul(x, w->sine, dy);
  fmpq_add(x, x, w->x);
  fmpq_mul(y, w->cosine, dy);
  fmpq_submul(y, w->sine, dx);
  fmpq_add(y, y, w->y);
  fmpq_clear(dx);
  fmpq_clear(dy);
}

static bool turn_line(tp_polyline *turned, const tp_polyline *line, const tp_turn *w) {
  if (!tp_polyline_copy(turned, line)) return false;
  for (long k = 0; k < turned->count; k++) turn_point(turned->x + k, turned->y + k, w);
  return true;
}

/* Quantities of a copy: their values become its own. */
static void turn_quantities(tp_quantity *x, tp_quantity *y, const tp_turn *w) {
  const fmpq held_x = *x->value, held_y = *y->value; /* the scene's */
  fmpq_init(x->value);
  fmpq_init(y->value);
  fmpq_set(x->value, &held_x);
  fmpq_set(y->value, &held_y);
  if (x->given) turn_point(x->value, y->value, w);
}

static void clear_quantities(tp_quantity *x, tp_quantity *y) {
  fmpq_clear(x->value);
  fmpq_clear(y->value);
}

/* A copy of an array; NULL where memory is exhausted. */
static void *copied(const void *items, long count, size_t size) {
  void *copy = malloc((size_t)count * size + 1);
  if (copy != NULL && count > 0) memcpy(copy, items, (size_t)count * size);
  return copy;
}

void tp_turned_reset(tp_scene *copy) {
  tp_block_description *block = &copy->block;
  block->outline = copy->base.between = copy->base.profile = (tp_polyline){0};
  block->holes = NULL;
  block->parts = NULL;
  block->arcs = NULL;
  block->rounded.corners = NULL;
  copy->loads.pressures = copy->loads.surcharges = NULL;
  copy->loads.anchors = NULL;
  copy->base.below.given = copy->base.left_of.given = copy->base.right_of.given = false;
}

static bool turn_rings(tp_scene *turned, const tp_turn *w, const tp_block_description *own) {
  tp_block_description *block = &turned->block;
  bool done = turn_line(&block->outline, &own->outline, w);
  block->holes = calloc((size_t)own->hole_count + 1, sizeof *block->holes);
  block->parts = copied(own->parts, own->part_count, sizeof *block->parts);
  for (long k = 0; k < own->part_count && block->parts != NULL; k++) {
    block->parts[k].outline = (tp_polyline){0};
  }
  if (block->holes == NULL || block->parts == NULL) return false;
  for (long k = 0; k < own->hole_count && done; k++) {
    done = turn_line(block->holes + k, own->holes + k, w);
  }
  for (long k = 0; k < own->part_count && done; k++) {
    done = turn_line(&block->parts[k].outline, &own->parts[k].outline, w);
  }
  return done;
}

static bool turn_curves(tp_scene *turned, const tp_turn *w, const tp_block_description *own) {
  tp_block_description *block = &turned->block;
  block->arcs = copied(own->arcs, own->arc_count, sizeof *block->arcs);
  if (block->arcs == NULL) return false;
  for (long k = 0; k < own->arc_count; k++) {
    turn_quantities(&block->arcs[k].x, &block->arcs[k].y, w);
    turn_quantities(&block->arcs[k].through_x, &block->arcs[k].through_y, w);
  }
  block->rounded.corners =
      copied(own->rounded.corners, own->rounded.count, sizeof *block->rounded.corners);
  if (block->rounded.corners == NULL) return false;
  for (long k = 0; k < own->rounded.count; k++) {
    turn_quantities(&block->rounded.corners[k].x, &block->rounded.corners[k].y, w);
  }
  return true;
}

static tp_line_load *turn_lines(const tp_line_load *own, long count, const tp_turn *w) {
  tp_line_load *loads = copied(own, count, sizeof *loads);
  for (long k = 0; k < count && loads != NULL; k++) {
    turn_quantities(&loads[k].x0, &loads[k].y0, w);
    turn_quantities(&loads[k].x1, &loads[k].y1, w);
  }
  return loads;
}

/* An anchor's direction is measured from x, which is now the mean plane. */
static bool turn_loads(tp_scene *turned, const tp_turn *w, const tp_loads_description *own) {
  tp_loads_description *loads = &turned->loads;
  loads->pressures = turn_lines(own->pressures, own->pressure_count, w);
  loads->surcharges = turn_lines(own->surcharges, own->surcharge_count, w);
  loads->anchors = copied(own->anchors, own->anchor_count, sizeof *loads->anchors);
  if (loads->pressures == NULL || loads->surcharges == NULL || loads->anchors == NULL) return false;
  for (long k = 0; k < own->anchor_count; k++) {
    tp_anchor_description *a = loads->anchors + k;
    turn_quantities(&a->x, &a->y, w);
    fmpq_init(a->direction_deg.value);
    if (w->rises > 0) {
      fmpq_sub(a->direction_deg.value, own->anchors[k].direction_deg.value, w->dip_deg);
    } else {
      fmpq_add(a->direction_deg.value, own->anchors[k].direction_deg.value, w->dip_deg);
    }
  }
  return true;
}

/* The ends by their turned coordinates: vertices of the ring that the section has. */
static bool turn_ends(tp_scene *turned, const tp_turn *w, const tp_scene *scene, long first,
                      long last) {
  tp_section section;
  tp_message message;
  tp_polyline *between = &turned->base.between;
  if (tp_section_init(&section, &scene->block, &message) != TP_OK) return false;
  const tp_polyline *ring = section.rings;
  const long ends[2] = {first, last};
  bool done = true;
  between->file = ring->file;
  between->mark = ring->mark;
  for (int k = 0; k < 2 && done; k++) {
    done = tp_polyline_append(between, ring->x + ends[k], ring->y + ends[k], ring->marks[ends[k]]);
    if (done) turn_point(between->x + k, between->y + k, w);
  }
  tp_section_clear(&section);
  return done;
}

bool tp_turn_scene(tp_scene *turned, const tp_turn *w, const tp_scene *scene, bool keeps_ends,
                   long first, long last) {
  return turn_rings(turned, w, &scene->block) && turn_curves(turned, w, &scene->block) &&
         turn_line(&turned->base.profile, &scene->base.profile, w) &&
         turn_loads(turned, w, &scene->loads) &&
         (!keeps_ends || turn_ends(turned, w, scene, first, last));
}

static void clear_lines(tp_line_load *loads, long count) {
  for (long k = 0; k < count && loads != NULL; k++) {
    clear_quantities(&loads[k].x0, &loads[k].y0);
    clear_quantities(&loads[k].x1, &loads[k].y1);
  }
  free(loads);
}

void tp_turned_clear(tp_scene *turned) {
  tp_block_description *block = &turned->block;
  tp_loads_description *loads = &turned->loads;
  tp_polyline_clear(&block->outline);
  tp_polyline_clear(&turned->base.between);
  tp_polyline_clear(&turned->base.profile);
  for (long k = 0; k < block->hole_count && block->holes != NULL; k++) {
    tp_polyline_clear(block->holes + k);
  }
  for (long k = 0; k < block->part_count && block->parts != NULL; k++) {
    tp_polyline_clear(&block->parts[k].outline);
  }
  for (long k = 0; k < block->arc_count && block->arcs != NULL; k++) {
    clear_quantities(&block->arcs[k].x, &block->arcs[k].y);
    clear_quantities(&block->arcs[k].through_x, &block->arcs[k].through_y);
  }
  for (long k = 0; k < block->rounded.count && block->rounded.corners != NULL; k++) {
    clear_quantities(&block->rounded.corners[k].x, &block->rounded.corners[k].y);
  }
  clear_lines(loads->pressures, loads->pressure_count);
  clear_lines(loads->surcharges, loads->surcharge_count);
  for (long k = 0; k < loads->anchor_count && loads->anchors != NULL; k++) {
    clear_quantities(&loads->anchors[k].x, &loads->anchors[k].y);
    fmpq_clear(loads->anchors[k].direction_deg.value);
  }
  free(block->holes);
  free(block->parts);
  free(block->arcs);
  free(block->rounded.corners);
  free(loads->anchors);
}
