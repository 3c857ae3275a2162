/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A load about the origin moved to the own point of the block that it acts on, in balls of so many
 * bits that far-off origins cost nothing. */

#include "block_system/block_loads.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 256 };

void tp_block_loads_clear(tp_block_loads *loads) {
  for (long k = 0; k < loads->count; k++) tp_wrench_clear(&loads->items[k].wrench);
  free(loads->items);
  free(loads->applied);
  free(loads->resting);
  free(loads->pushing);
  free(loads->water);
  memset(loads, 0, sizeof *loads);
}

static bool make_room(tp_block_loads *loads) {
  if (loads->count < loads->room) return true;
  const long room = 2 * loads->room + 8;
  tp_block_load *items = realloc(loads->items, (size_t)room * sizeof *items);
  if (items == NULL) return false;
  loads->items = items;
  loads->room = room;
  return true;
}

static void negate(tp_trig *f) {
  for (int k = 0; k < TP_BASIS; k++) arb_neg(f->of + k, f->of + k);
}

/* Moments about a block's own point. */
static void move_to_block(tp_wrench *own, const tp_wrench *wrench, const tp_assemblage *a,
                          const tp_rigid_block *block) {
  fmpq_t metres;
  arb_t x, y;
  fmpq_init(metres);
  arb_init(x);
  arb_init(y);
  tp_lattice_metres_x(metres, &a->lattice, block->x);
  arb_set_fmpq(x, metres, BITS);
  tp_lattice_metres_y(metres, &a->lattice, block->y);
  arb_set_fmpq(y, metres, BITS);
  tp_trig_add(&own->x, &wrench->x, BITS);
  tp_trig_add(&own->y, &wrench->y, BITS);
  tp_wrench_moment(&own->moment, wrench, x, y, BITS);
  fmpq_clear(metres);
  arb_clear(x);
  arb_clear(y);
}

tp_status tp_block_loads_add(tp_block_loads *loads, const tp_placed_blocks *blocks,
                             const tp_block_load *load, bool reversed, tp_message *message) {
  const tp_rigid_block *rigid = blocks->assemblage->blocks + load->block;
  if (rigid->number < 0) return TP_OK;
  if (!make_room(loads)) return tp_fail_memory(message, "the loads");
  tp_block_load *own = loads->items + loads->count++;
  own->kind = load->kind;
  own->active = load->active;
  own->block = load->block;
  tp_wrench_init(&own->wrench);
  move_to_block(&own->wrench, &load->wrench, blocks->assemblage, rigid);
  if (!reversed) return TP_OK;
  negate(&own->wrench.x);
  negate(&own->wrench.y);
  negate(&own->wrench.moment);
  return TP_OK;
}
