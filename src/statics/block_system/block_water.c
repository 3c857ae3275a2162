/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Problem: what water below a level or a surface does to many blocks.
 *
 * At a depth z below the water, measured vertically as the blocks lie, the pressure is g z: in
 * every joint, on both sides of it, and on faces that touch nothing. Of one edge of a block the
 * pieces that are contacts are joints and the others faces; on each the depth is linear between the
 * bends of the surface (load/water_stand.h), so that all pressures and their sums are rationals.
 * They stay as they are on the blocks when those are tilted, as of one block (docs/loads.md).
 *
 * Faces: water stands where the surface says; what it holds a block by may be gone. So on a face
 * steeper than 45 degrees it presses, unless the scene says `faces: both`, only where that drives
 * the block to the side that the case goes to. On flat ones, upwards and downwards, it always does.
 *
 * Exact but for the direction of the vertical, which is rounded to 256 binary digits. Holes are
 * dry, and corners bear no pressure. Cost: an edge of a block times the contacts of that block. */

#include "block_system/block_loads.h"

#include "block_system/edge_pieces.h"
#include "block_system/resultant.h"
#include "load/water_stand.h"
#include "number/ball.h"

enum { BITS = 128 };

typedef struct wetting {
  const tp_placed_blocks *blocks;
  bool left;  /* the side that the case goes to */
  bool omits; /* something that it would hold */
  tp_lie lie;
  tp_polyline surface; /* laid; empty: a level */
  tp_water_stand stand;
  fmpq_t unit_kpa;            /* the pressure of a unit of depth */
  tp_edge_pieces pieces;      /* that touch another block */
  tp_polyline chain, world;   /* two points of an edge; the latter across and up */
  tp_wet_lines joints, faces; /* of a block */
} wetting;

/* ---- the water ---------------------------------------------------------------------------------
 */

static void add_extent(fmpq_t least, fmpq_t greatest, bool *any, const wetting *w, long block) {
  const tp_polyline *ring = w->blocks->sections[block].rings;
  fmpq_t across, up;
  fmpq_init(across);
  fmpq_init(up);
  for (long k = 0; k < ring->count; k++) {
    tp_lie_of(across, up, &w->lie, ring->x + k, ring->y + k);
    if (!*any || fmpq_cmp(across, least) < 0) fmpq_set(least, across);
    if (!*any || fmpq_cmp(across, greatest) > 0) fmpq_set(greatest, across);
    *any = true;
  }
  fmpq_clear(across);
  fmpq_clear(up);
}

static tp_status lay_surface(wetting *w, tp_message *message) {
  const tp_assemblage *a = w->blocks->assemblage;
  fmpq_t least, greatest;
  bool any = false;
  fmpq_init(least);
  fmpq_init(greatest);
  for (long k = 0; k < a->count; k++) {
    if (a->blocks[k].number >= 0) add_extent(least, greatest, &any, w, k);
  }
  const tp_status status = tp_water_surface_lay(&w->surface, &w->blocks->scene->loads.water.surface,
                                                &w->lie, least, greatest, message);
  fmpq_clear(least);
  fmpq_clear(greatest);
  return status;
}

static tp_status find_stand(wetting *w, tp_message *message) {
  const tp_scene *scene = w->blocks->scene;
  const tp_water_description *water = &scene->loads.water;
  tp_scene_lie(&w->lie, scene, w->left);
  fmpq_mul(w->unit_kpa, water->unit_weight_kn_m3.value, scene->metres_per_unit);
  fmpq_set(w->stand.level, water->level.value);
  if (water->surface.count == 0) return TP_OK;
  w->stand.surface = &w->surface;
  return lay_surface(w, message);
}

/* ---- what it presses on ------------------------------------------------------------------------
 */

/* The k-th of the two points of the chain, at a share of an edge of the ring. */
static void set_point(wetting *w, int k, const tp_polyline *ring, long edge, const fmpq_t share) {
  const long next = edge + 1 == ring->count ? 0 : edge + 1;
  fmpq_sub(w->chain.x + k, ring->x + next, ring->x + edge);
  fmpq_mul(w->chain.x + k, w->chain.x + k, share);
  fmpq_add(w->chain.x + k, w->chain.x + k, ring->x + edge);
  fmpq_sub(w->chain.y + k, ring->y + next, ring->y + edge);
  fmpq_mul(w->chain.y + k, w->chain.y + k, share);
  fmpq_add(w->chain.y + k, w->chain.y + k, ring->y + edge);
  tp_lie_of(w->world.x + k, w->world.y + k, &w->lie, w->chain.x + k, w->chain.y + k);
}

/* Water before a face, which the block has on its left, pushes it to where it rises from: a face
 * steeper than 45 degrees that it would push away from the side of the case. */
static bool holds_back(const wetting *w) {
  fmpq_t run, rise;
  fmpq_init(run);
  fmpq_init(rise);
  fmpq_sub(run, w->world.x + 1, w->world.x);
  fmpq_sub(rise, w->world.y + 1, w->world.y);
  const bool back = w->left ? fmpq_sgn(rise) < 0 : fmpq_sgn(rise) > 0;
  fmpq_abs(run, run);
  fmpq_abs(rise, rise);
  const bool steep = fmpq_cmp(rise, run) > 0;
  fmpq_clear(run);
  fmpq_clear(rise);
  return back && steep;
}

static bool press(wetting *w, const tp_polyline *ring, long edge, const fmpq_t from,
                  const fmpq_t to, bool joint) {
  const tp_water_description *water = &w->blocks->scene->loads.water;
  if (fmpq_cmp(from, to) >= 0) return true;
  if (joint && water->shape == TP_WATER_UPLIFT_NONE) return true;
  set_point(w, 0, ring, edge, from);
  set_point(w, 1, ring, edge, to);
  const bool left_out = !joint && water->faces != TP_WATER_ON_BOTH && holds_back(w);
  tp_wet_lines none = {0};
  tp_wet_lines *lines = left_out ? &none : joint ? &w->joints : &w->faces;
  const bool done = tp_water_press(lines, &w->stand, &w->chain, &w->world, 0, w->unit_kpa, NULL);
  w->omits = w->omits || none.count > 0;
  tp_wet_lines_clear(&none);
  return done;
}

static bool press_on_block(wetting *w, long block) {
  const tp_rigid_block *rigid = w->blocks->assemblage->blocks + block;
  const tp_polyline *ring = w->blocks->sections[block].rings;
  fmpq_t reached, one;
  fmpq_init(reached);
  fmpq_init(one);
  fmpq_one(one);
  bool done = true;
  for (long k = 0; k < ring->count && done; k++) {
    const long p = rigid->outline + k, q = k + 1 == ring->count ? rigid->outline : p + 1;
    const long count = tp_edge_pieces_find(&w->pieces, block, p, q);
    fmpq_zero(reached);
    for (long n = 0; n < count && done; n++) {
      done = press(w, ring, k, reached, w->pieces.items[n].from, false) &&
             press(w, ring, k, w->pieces.items[n].from, w->pieces.items[n].to, true);
      fmpq_set(reached, w->pieces.items[n].to);
    }
    done = done && press(w, ring, k, reached, one, false);
  }
  fmpq_clear(reached);
  fmpq_clear(one);
  return done;
}

/* ---- sums --------------------------------------------------------------------------------------
 */

static tp_status add_lines(tp_block_loads *loads, const wetting *w, const tp_load_setting *setting,
                           long block, const tp_wet_lines *lines, tp_system_load_kind kind,
                           tp_message *message) {
  if (lines->count == 0) return TP_OK;
  tp_block_load load = {.kind = kind, .block = block};
  tp_wrench_init(&load.wrench);
  tp_load_wet_lines(&load.wrench, lines, setting);
  const tp_status status = tp_block_loads_add(loads, w->blocks, &load, false, message);
  tp_wrench_clear(&load.wrench);
  return status;
}

static tp_status wet_block(tp_block_loads *loads, wetting *w, const tp_load_setting *setting,
                           long block, tp_message *message) {
  tp_status status = press_on_block(w, block) ? TP_OK : tp_fail_memory(message, "the water");
  if (status == TP_OK) {
    status =
        add_lines(loads, w, setting, block, &w->joints, TP_SYSTEM_LOAD_WATER_IN_JOINTS, message);
  }
  if (status == TP_OK) {
    status = add_lines(loads, w, setting, block, &w->faces, TP_SYSTEM_LOAD_WATER_ON_FACES, message);
  }
  tp_wet_lines_clear(&w->joints);
  tp_wet_lines_clear(&w->faces);
  return status;
}

/* What the water in a contact pushes its two sides apart by. */
static tp_bounded size_of(const tp_wet_lines *lines, const tp_placed_blocks *blocks) {
  fmpq_t fx, fy, moment;
  arb_t x, y;
  fmpq_init(fx);
  fmpq_init(fy);
  fmpq_init(moment);
  arb_init(x);
  arb_init(y);
  tp_wet_lines_sum(fx, fy, moment, lines, blocks->scene->metres_per_unit, false);
  arb_set_fmpq(x, fx, BITS);
  arb_set_fmpq(y, fy, BITS);
  arb_hypot(x, x, y, BITS);
  arb_mul_ui(x, x, TP_KILO, BITS);
  const tp_bounded size = tp_ball_bounded(x);
  fmpq_clear(fx);
  fmpq_clear(fy);
  fmpq_clear(moment);
  arb_clear(x);
  arb_clear(y);
  return size;
}

/* Along one of the blocks' edges, which is the whole of it or more. */
static bool wet_contact(tp_bounded *water, wetting *w, const tp_block_contact *c) {
  const tp_assemblage *a = w->blocks->assemblage;
  if (c->ends[0] == c->ends[1]) return true;
  for (int side = 0; side < 2; side++) {
    const tp_rigid_block *rigid = a->blocks + c->block[side];
    const long from = c->from, to = c->to;
    if (from < rigid->outline || from >= rigid->end || to < rigid->outline || to >= rigid->end) {
      continue;
    }
    const long p = from + 1 == to || (from + 1 == rigid->end && to == rigid->outline) ? from : to;
    const long q = p == from ? to : from;
    tp_edge_piece *piece = w->pieces.items;
    if (!tp_edge_piece_set(piece, &a->lattice, c, p, q)) continue;
    const bool done = press(w, w->blocks->sections[c->block[side]].rings, p - rigid->outline,
                            piece->from, piece->to, true);
    *water = size_of(&w->joints, w->blocks);
    tp_wet_lines_clear(&w->joints);
    return done;
  }
  return true;
}

static tp_status wet_all(tp_block_loads *loads, wetting *w, const tp_load_setting *setting,
                         tp_message *message) {
  const tp_assemblage *a = w->blocks->assemblage;
  tp_status status = find_stand(w, message);
  for (long k = 0; k < a->count && status == TP_OK; k++) {
    if (a->blocks[k].number >= 0) status = wet_block(loads, w, setting, k, message);
  }
  for (long k = 0; k < a->contact_count && status == TP_OK; k++) {
    if (!wet_contact(loads->water + k, w, a->contacts + k)) {
      status = tp_fail_memory(message, "the water");
    }
  }
  return status;
}

/* Two points, to be set. */
static bool make_chain(tp_polyline *chain) {
  const tp_mark none = {0, 0};
  fmpq_t zero;
  fmpq_init(zero);
  bool done = true;
  for (int k = 0; k < 2 && done; k++) done = tp_polyline_append(chain, zero, zero, none);
  fmpq_clear(zero);
  return done;
}

tp_status tp_block_water_add(tp_block_loads *loads, const tp_placed_blocks *blocks,
                             const tp_load_setting *setting, tp_message *message) {
  wetting w = {.blocks = blocks, .left = loads->left};
  tp_lie_init(&w.lie);
  fmpq_init(w.stand.level);
  fmpq_init(w.unit_kpa);
  const bool made = make_chain(&w.chain) && make_chain(&w.world) &&
                    tp_edge_pieces_init(&w.pieces, blocks->assemblage);
  const tp_status status =
      made ? wet_all(loads, &w, setting, message) : tp_fail_memory(message, "the water");
  loads->omits = w.omits;
  tp_edge_pieces_clear(&w.pieces);
  tp_lie_clear(&w.lie);
  fmpq_clear(w.stand.level);
  fmpq_clear(w.unit_kpa);
  tp_polyline_clear(&w.surface);
  tp_polyline_clear(&w.chain);
  tp_polyline_clear(&w.world);
  return status;
}
