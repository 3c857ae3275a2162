/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Let C and C' be what two blocks fill at the point, two convex sectors that share nothing else.
 * The second block moves into the first by velocities, against it, inside of D = C - C': again a
 * convex sector of less than 180 degrees, between the outermost of four rays: the edges of C, and
 * those of C' turned round. Of each of its two borders the edge that it is of is one side of the
 * pair. All by signs of whole numbers. */

#include "assemblage/corner_pairs.h"

#include "common/grow.h"
#include "common/outside.h"

static bool is_salient(const tp_lattice *l, const tp_block_corner *c) {
  return tp_lattice_cross(l, c->before, c->point, c->point, c->next) > 0;
}

static bool shares_edge(const tp_lattice *l, const tp_block_corner *c, const tp_block_corner *d) {
  return (tp_lattice_cross(l, c->point, c->next, d->point, d->before) == 0 &&
          tp_lattice_dot(l, c->point, c->next, d->point, d->before) > 0) ||
         (tp_lattice_cross(l, c->point, c->before, d->point, d->next) == 0 &&
          tp_lattice_dot(l, c->point, c->before, d->point, d->next) > 0);
}

static tp_block_contact side_of(long owner, long other, long point, long from, long to) {
  return (tp_block_contact){
      .block = {owner, other}, .ends = {point, point}, .from = from, .to = to, .along = {from, to}};
}

/* Of the edges that end at the point, that of the second block turned round, the one on the left;
 * of those that begin there, the one on the right. */
static tp_corner_pair pair_of(const tp_lattice *l, const tp_edge_of_block *e,
                              const tp_edge_of_block *f) {
  const tp_block_corner *c = &e->corner, *d = &f->corner;
  const bool ends = tp_lattice_cross(l, c->point, c->before, d->before, d->point) <= 0;
  const bool begins = tp_lattice_cross(l, c->point, c->next, d->next, d->point) >= 0;
  return (tp_corner_pair){{ends ? side_of(e->block, f->block, c->point, c->before, c->point)
                                : side_of(f->block, e->block, d->point, d->before, d->point),
                           begins ? side_of(e->block, f->block, c->point, c->point, c->next)
                                  : side_of(f->block, e->block, d->point, d->point, d->next)}};
}

tp_status tp_corner_pairs_try(tp_assemblage *a, const tp_edge_of_block *e,
                              const tp_edge_of_block *f, tp_message *message) {
  const tp_lattice *l = &a->lattice;
  const bool free = a->blocks[e->block].number >= 0 || a->blocks[f->block].number >= 0;
  if (e->block > f->block || !free || !is_salient(l, &e->corner) || !is_salient(l, &f->corner) ||
      shares_edge(l, &e->corner, &f->corner)) {
    return TP_OK;
  }
  tp_corner_pair *pairs = tp_grow(a->pairs, a->pair_count, &a->pair_room, sizeof *pairs);
  if (pairs == NULL) return tp_fail_memory(message, "the contacts");
  a->pairs = pairs;
  pairs[a->pair_count++] = pair_of(l, e, f);
  return TP_OK;
}
