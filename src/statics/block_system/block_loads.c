/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each load of the scene evaluated by its own file of the room of loads; a bolt acts on two blocks,
 * one way and the other. Then all of them as rows of the program of forces. */

#include "block_system/block_loads.h"

#include "block_system/resultant.h"
#include "common/outside.h"
#include "load/check.h"
#include "number/ball.h"
#include "scene/anchor.h"

#include <stdlib.h>

enum { BITS = 256, ROW = 3 };

bool tp_block_loads_are_called_for(const tp_scene *scene) {
  const tp_loads_description *d = &scene->loads;
  return d->water.given || d->pressure_count > 0 || d->surcharge_count > 0 ||
         d->support_count > 0 || d->anchor_count > 0 || d->force_count > 0;
}

/* ---- those of the scene ------------------------------------------------------------------------
 */

typedef struct gathering {
  tp_block_loads *loads;
  const tp_placed_blocks *blocks;
  const tp_load_setting *setting;
  const fmpq *up; /* in the scene's axes */
  tp_message *message;
} gathering;

typedef void evaluation(tp_wrench *wrench, const tp_line_load *line,
                        const tp_load_setting *setting);

/* On one block. */
static tp_status add_line(const gathering *g, const tp_line_load *line, long block,
                          tp_system_load_kind kind, evaluation *evaluate) {
  const bool supports = kind == TP_SYSTEM_LOAD_SUPPORT_PRESSURE;
  tp_block_load load = {.kind = kind, .active = supports && !line->passive, .block = block};
  tp_wrench_init(&load.wrench);
  evaluate(&load.wrench, line, g->setting);
  const tp_status status = tp_block_loads_add(g->loads, g->blocks, &load, false, g->message);
  tp_wrench_clear(&load.wrench);
  return status;
}

static tp_status refuse_line(const gathering *g, const tp_line_load *line,
                             tp_system_load_kind kind) {
  const char *what = tp_system_load_kind_name(kind);
  const bool pushes = kind != TP_SYSTEM_LOAD_SURCHARGE;
  if (line->block >= 0) {
    return tp_load_lines_check(line, 1, g->blocks->sections[line->block].rings, what, pushes,
                               g->message);
  }
  return tp_refuse(g->message, TP_FAULT_GEOMETRY, line->place,
                   "this %s lies on no straight face of the blocks from end to end%s: give its "
                   "points on them, or name its 'block'",
                   what, pushes ? ", which runs counter-clockwise round them" : " that looks up");
}

/* All of it on the block that is named, or each stretch on the one that it lies on. */
static tp_status add_stretches(const gathering *g, const tp_line_load *line,
                               tp_system_load_kind kind, evaluation *evaluate) {
  const bool weighs = kind == TP_SYSTEM_LOAD_SURCHARGE;
  tp_line_stretches found;
  bool covered = false;
  if (!tp_line_stretches_find(&found, &covered, g->blocks, line, line->block,
                              weighs ? g->up : NULL)) {
    tp_line_stretches_clear(&found);
    return tp_fail_memory(g->message, "the loads");
  }
  tp_status status = covered ? TP_OK : refuse_line(g, line, kind);
  if (line->block >= 0) {
    if (status == TP_OK) status = add_line(g, line, line->block, kind, evaluate);
  } else {
    for (long k = 0; k < found.count && status == TP_OK; k++) {
      status = add_line(g, &found.items[k].line, found.items[k].block, kind, evaluate);
    }
  }
  tp_line_stretches_clear(&found);
  return status;
}

static tp_status add_lines(const gathering *g, const tp_line_load *lines, long count,
                           tp_system_load_kind kind, evaluation *evaluate) {
  tp_status status = TP_OK;
  for (long k = 0; k < count && status == TP_OK; k++) {
    status = add_stretches(g, lines + k, kind, evaluate);
  }
  return status;
}

static tp_status add_bolt(const gathering *g, const tp_anchor_description *anchor, long row) {
  long into = -1;
  tp_block_load load = {.kind = TP_SYSTEM_LOAD_ANCHOR, .active = !anchor->passive};
  tp_status status = tp_block_bolt_ends(&load.block, &into, g->blocks, anchor, row, g->message);
  if (status != TP_OK) return status;
  tp_wrench_init(&load.wrench);
  tp_load_anchor(&load.wrench, anchor, row, g->setting);
  status = tp_block_loads_add(g->loads, g->blocks, &load, false, g->message);
  load.block = into;
  if (status == TP_OK) status = tp_block_loads_add(g->loads, g->blocks, &load, true, g->message);
  tp_wrench_clear(&load.wrench);
  return status;
}

static tp_status add_bolts(const gathering *g) {
  const tp_loads_description *d = &g->blocks->scene->loads;
  tp_status status = TP_OK;
  for (long k = 0; k < d->anchor_count; k++) {
    const tp_anchor_description *anchor = d->anchors + k;
    for (long row = 0; row < tp_anchor_rows(anchor) && status == TP_OK; row++) {
      status = add_bolt(g, anchor, row);
    }
  }
  return status;
}

/* The block that it acts on. */
static tp_status find_pushed(long *block, const gathering *g, const tp_anchor_description *force) {
  const tp_placed_blocks *b = g->blocks;
  *block = force->block;
  if (*block < 0) {
    const tp_status status = tp_block_find_at(block, b, force->x.value, force->y.value, "force",
                                              force->place, g->message);
    if (status != TP_OK) return status;
  }
  const char *name = b->scene->many.blocks[*block].name;
  if (b->scene->many.blocks[*block].fixed) {
    return tp_refuse(g->message, TP_FAULT_KEY, force->place,
                     "block '%s' is ground: a force on it does nothing", tp_quote_all(name).text);
  }
  if (tp_block_is_near(b, *block, force->x.value, force->y.value)) return TP_OK;
  return tp_refuse(g->message, TP_FAULT_GEOMETRY, force->place,
                   "this force does not act on block '%s': 'at' lies outside it",
                   tp_quote_all(name).text);
}

static tp_status add_forces(const gathering *g) {
  const tp_loads_description *d = &g->blocks->scene->loads;
  tp_status status = TP_OK;
  for (long k = 0; k < d->force_count && status == TP_OK; k++) {
    tp_block_load load = {.kind = TP_SYSTEM_LOAD_FORCE, .block = -1};
    status = find_pushed(&load.block, g, d->forces + k);
    if (status != TP_OK) break;
    tp_wrench_init(&load.wrench);
    tp_load_anchor(&load.wrench, d->forces + k, 0, g->setting);
    status = tp_block_loads_add(g->loads, g->blocks, &load, false, g->message);
    tp_wrench_clear(&load.wrench);
  }
  return status;
}

static tp_status add_all(const gathering *g) {
  const tp_loads_description *d = &g->blocks->scene->loads;
  tp_status status = TP_OK;
  if (d->water.given) status = tp_block_water_add(g->loads, g->blocks, g->setting, g->message);
  if (status == TP_OK) {
    status =
        add_lines(g, d->pressures, d->pressure_count, TP_SYSTEM_LOAD_PRESSURE, tp_load_pressure);
  }
  if (status == TP_OK) {
    status = add_lines(g, d->surcharges, d->surcharge_count, TP_SYSTEM_LOAD_SURCHARGE,
                       tp_load_surcharge);
  }
  if (status == TP_OK) {
    status = add_lines(g, d->supports, d->support_count, TP_SYSTEM_LOAD_SUPPORT_PRESSURE,
                       tp_load_pressure);
  }
  if (status == TP_OK) status = add_bolts(g);
  return status == TP_OK ? add_forces(g) : status;
}

/* ---- rows of the program -----------------------------------------------------------------------
 */

/* In units of the assemblage. */
static tp_near part_of(const arb_t of, const arb_t unit, bool reversed) {
  arb_t own;
  arb_init(own);
  arb_div(own, of, unit, BITS);
  if (reversed) arb_neg(own, own);
  const tp_near part = tp_ball_near_exact(own);
  arb_clear(own);
  return part;
}

/* At a tilt a gravity points to (-sin a, -cos a): what has the factor sin a or cos a follows it. */
static void apply(tp_applied_load *row, tp_near *steady, const tp_trig *of, const arb_t unit) {
  *steady = tp_near_plus(*steady, part_of(of->of + TP_ONE, unit, false));
  row->down[0] = tp_near_plus(row->down[0], part_of(of->of + TP_SIN, unit, true));
  row->down[1] = tp_near_plus(row->down[1], part_of(of->of + TP_COS, unit, true));
}

/* Adds by how much a force points to the side and off the base together. */
static void add_push(arb_t push, const tp_block_loads *loads, const tp_block_load *own) {
  (loads->left ? arb_sub : arb_add)(push, push, own->wrench.x.of + TP_ONE, BITS);
  arb_add(push, push, own->wrench.y.of + TP_ONE, BITS);
}

/* Does one force drive, or, where it is NULL, all water together? A push that is zero counts as
 * driving, as balls may not distinguish it from one that is not; so it does for one block
 * (onset/onset_driving.c). */
static bool pushes_out(const tp_block_loads *loads, const tp_block_load *force) {
  arb_t push;
  arb_init(push);
  for (long k = 0; k < loads->count; k++) {
    const tp_block_load *load = loads->items + k;
    if (force != NULL ? load == force : tp_block_load_is_water(load)) add_push(push, loads, load);
  }
  const bool does = !arb_is_negative(push);
  arb_clear(push);
  return does;
}

static bool drives(const tp_block_loads *loads, const tp_block_load *own, bool of_water) {
  switch (own->kind) {
  case TP_SYSTEM_LOAD_WATER_IN_JOINTS:
  case TP_SYSTEM_LOAD_WATER_ON_FACES:
    return of_water;
  case TP_SYSTEM_LOAD_PRESSURE:
  case TP_SYSTEM_LOAD_FORCE:
    return pushes_out(loads, own);
  case TP_SYSTEM_LOAD_ANCHOR:
  case TP_SYSTEM_LOAD_SUPPORT_PRESSURE:
    return own->active;
  default:
    return false;
  }
}

/* What rests and what drives, apart. */
static void apply_one(tp_block_loads *loads, const tp_block_load *own, long at,
                      const arb_struct *units, bool driving) {
  const tp_trig *const of[ROW] = {&own->wrench.x, &own->wrench.y, &own->wrench.moment};
  for (long e = 0; e < ROW; e++) {
    tp_applied_load *all = loads->applied + at + e, *resting = loads->resting + at + e;
    apply(all, &all->steady, of[e], units + e);
    apply(resting, driving ? loads->pushing + at + e : &resting->steady, of[e], units + e);
  }
}

static tp_status apply_all(tp_block_loads *loads, const tp_assemblage *a, tp_message *message) {
  const size_t rows = (size_t)a->free_count * ROW + 1;
  loads->applied = calloc(rows, sizeof *loads->applied);
  loads->resting = calloc(rows, sizeof *loads->resting);
  loads->pushing = calloc(rows, sizeof *loads->pushing);
  if (loads->applied == NULL || loads->resting == NULL || loads->pushing == NULL) {
    return tp_fail_memory(message, "the loads");
  }
  arb_struct units[ROW];
  for (int e = 0; e < ROW; e++) arb_init(units + e);
  for (int e = 0; e < 2; e++) {
    arb_set_ui(units + e, TP_KILO);
    arb_mul_2exp_si(units + e, units + e, a->weight_exponent);
  }
  arb_set_fmpq(units + 2, a->lattice.step_m, BITS);
  arb_mul_2exp_si(units + 2, units + 2, a->length_exponent);
  arb_mul(units + 2, units + 2, units, BITS);
  const bool of_water = pushes_out(loads, NULL);
  for (long k = 0; k < loads->count; k++) {
    const tp_block_load *own = loads->items + k;
    apply_one(loads, own, ROW * a->blocks[own->block].number, units, drives(loads, own, of_water));
  }
  for (int e = 0; e < ROW; e++) arb_clear(units + e);
  return TP_OK;
}

tp_status tp_block_loads_init(tp_block_loads *loads, const tp_placed_blocks *blocks, bool left,
                              tp_message *message) {
  *loads = (tp_block_loads){.left = left};
  if (!tp_block_loads_are_called_for(blocks->scene)) return TP_OK;
  loads->water = calloc((size_t)blocks->assemblage->contact_count + 1, sizeof *loads->water);
  if (loads->water == NULL) return tp_fail_memory(message, "the loads");
  tp_load_setting setting;
  tp_load_setting_init(&setting, blocks->scene, false, BITS);
  arb_one(setting.thickness);
  tp_lie lie;
  tp_lie_init(&lie);
  tp_scene_lie(&lie, blocks->scene, left);
  const fmpq up[2] = {*lie.up_x, *lie.up_y};
  const gathering g = {loads, blocks, &setting, up, message};
  tp_status status = add_all(&g);
  if (status == TP_OK) status = apply_all(loads, blocks->assemblage, message);
  tp_lie_clear(&lie);
  tp_load_setting_clear(&setting);
  if (status != TP_OK) tp_block_loads_clear(loads);
  return status;
}
