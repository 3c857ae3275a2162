/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts of edges: sorted by the line that they lie on, in whole numbers, and along it; those
 * that overlap against each other touch. Corners within edges, and overlaps, among edges whose
 * boxes meet (assemblage/edge_pairs.h), by signs of cross products in whole numbers. A corner in a
 * notch of another block touches both of its flanks, as in statics of one block. Salient corners of
 * two blocks that meet are kept apart from contacts (assemblage/corner_pairs.h). */

#define _GNU_SOURCE /* qsort_r */
#include "assemblage/assemblage.h"
#include "assemblage/corner_pairs.h"
#include "assemblage/edge_pairs.h"

#include "common/grow.h"
#include "common/outside.h"

#include <stdlib.h>

/* An edge of an outline from point `from` to `to`, along a line with the least whole direction
 * (dx, dy), dx > 0 or dx = 0 and dy > 0, and offset dx y - dy x. */
typedef struct line_edge {
  fmpz_t dx, dy, offset;
  long low, high; /* its points in the direction of the line */
  long block;
  bool along; /* it runs so, and its block is on the left */
} line_edge;

static void set_edge(line_edge *e, const tp_assemblage *a, long block, long from, long to) {
  const tp_lattice *l = &a->lattice;
  fmpz_t g;
  fmpz_init(g);
  fmpz_init(e->dx);
  fmpz_init(e->dy);
  fmpz_init(e->offset);
  fmpz_sub(e->dx, l->x + to, l->x + from);
  fmpz_sub(e->dy, l->y + to, l->y + from);
  fmpz_gcd(g, e->dx, e->dy);
  e->along = fmpz_sgn(e->dx) > 0 || (fmpz_is_zero(e->dx) && fmpz_sgn(e->dy) > 0);
  if (!e->along) fmpz_neg(g, g);
  fmpz_divexact(e->dx, e->dx, g);
  fmpz_divexact(e->dy, e->dy, g);
  fmpz_mul(e->offset, e->dx, l->y + from);
  fmpz_submul(e->offset, e->dy, l->x + from);
  e->block = block;
  e->low = e->along ? from : to;
  e->high = e->along ? to : from;
  fmpz_clear(g);
}

static void clear_edge(line_edge *e) {
  fmpz_clear(e->dx);
  fmpz_clear(e->dy);
  fmpz_clear(e->offset);
}

static int compare_lines(const line_edge *a, const line_edge *b) {
  int order = fmpz_cmp(a->dx, b->dx);
  if (order == 0) order = fmpz_cmp(a->dy, b->dy);
  return order != 0 ? order : fmpz_cmp(a->offset, b->offset);
}

/* Points of one line, in its direction. */
static int compare_points(const tp_lattice *l, long p, long q) {
  const int order = fmpz_cmp(l->x + p, l->x + q);
  return order != 0 ? order : fmpz_cmp(l->y + p, l->y + q);
}

static int compare_edges(const void *first, const void *second, void *lattice) {
  const line_edge *a = first, *b = second;
  const int order = compare_lines(a, b);
  return order != 0 ? order : compare_points(lattice, a->low, b->low);
}

static tp_status fail_overlap(const tp_assemblage *a, long i, long j, tp_message *message) {
  return tp_refuse(message, TP_FAULT_GEOMETRY, a->given[i > j ? i : j].place,
                   "blocks '%s' and '%s' overlap: move one of them, or cut it off where the other "
                   "begins; 'contact: {within: …}' closes overlaps that are noise of a survey",
                   tp_quote_all(a->given[i < j ? i : j].name).text,
                   tp_quote_all(a->given[i > j ? i : j].name).text);
}

static tp_status add_contact(tp_assemblage *a, tp_block_contact contact, tp_message *message) {
  tp_block_contact *contacts =
      tp_grow(a->contacts, a->contact_count, &a->contact_room, sizeof *contacts);
  if (contacts == NULL) return tp_fail_memory(message, "the contacts");
  a->contacts = contacts;
  contact.along[0] = contact.from;
  contact.along[1] = contact.to;
  contacts[a->contact_count++] = contact;
  return TP_OK;
}

/* Two edges of one line, the second beginning where the first does or behind that. */
static tp_status meet(tp_assemblage *a, const line_edge *e, const line_edge *f,
                      tp_message *message) {
  const tp_lattice *l = &a->lattice;
  if (e->block == f->block || compare_points(l, f->low, e->high) >= 0) return TP_OK;
  if (e->along == f->along) return fail_overlap(a, e->block, f->block, message);
  const line_edge *left = e->along ? e : f, *right = e->along ? f : e;
  const long end = compare_points(l, e->high, f->high) < 0 ? e->high : f->high;
  if (a->blocks[e->block].number < 0 && a->blocks[f->block].number < 0) return TP_OK;
  return add_contact(a,
                     (tp_block_contact){.block = {left->block, right->block},
                                        .ends = {f->low, end},
                                        .from = left->low,
                                        .to = left->high},
                     message);
}

/* Those of one line, in order: each with the ones before it that reach as far. */
static tp_status sweep_line(tp_assemblage *a, const line_edge *edges, long count, long *open,
                            tp_message *message) {
  long open_count = 0;
  tp_status status = TP_OK;
  for (long k = 0; k < count && status == TP_OK; k++) {
    long kept = 0;
    for (long o = 0; o < open_count && status == TP_OK; o++) {
      const line_edge *before = edges + open[o];
      if (compare_points(&a->lattice, before->high, edges[k].low) <= 0) continue;
      status = meet(a, before, edges + k, message);
      open[kept++] = open[o];
    }
    open[kept] = k;
    open_count = kept + 1;
  }
  return status;
}

static tp_status meet_along_lines(tp_assemblage *a, line_edge *edges, long count,
                                  tp_message *message) {
  long *open = calloc((size_t)count + 1, sizeof *open);
  if (open == NULL) return tp_fail_memory(message, "the contacts");
  qsort_r(edges, (size_t)count, sizeof *edges, compare_edges, &a->lattice);
  tp_status status = TP_OK;
  for (long k = 0; k < count && status == TP_OK;) {
    long end = k + 1;
    while (end < count && compare_lines(edges + k, edges + end) == 0) end++;
    status = sweep_line(a, edges + k, end - k, open, message);
    k = end;
  }
  free(open);
  return status;
}

/* ---- corners and overlaps ----------------------------------------------------------------------
 */

/* Does the direction from a corner p of a block to the point q lead into the block? On its border
 * it does not. */
static bool leads_inside(const tp_lattice *l, const tp_block_corner *c, long q) {
  const int after = tp_lattice_cross(l, c->point, c->next, c->point, q);
  const int before = tp_lattice_cross(l, c->point, q, c->point, c->before);
  const int turn = tp_lattice_cross(l, c->before, c->point, c->point, c->next);
  return turn >= 0 ? after > 0 && before > 0 : after > 0 || before > 0;
}

/* Does the point lie within the edge, off its ends? It is on the line. */
static bool lies_within(const tp_lattice *l, long p, long from, long to) {
  return tp_lattice_dot(l, from, to, from, p) > 0 && tp_lattice_dot(l, to, from, to, p) > 0;
}

static tp_status add_corner(tp_assemblage *a, const tp_edge_of_block *e, long other, long from,
                            long to, tp_message *message) {
  if (a->blocks[e->block].number < 0 && a->blocks[other].number < 0) return TP_OK;
  const long point = e->corner.point;
  return add_contact(
      a,
      (tp_block_contact){
          .block = {other, e->block}, .ends = {point, point}, .from = from, .to = to},
      message);
}

static bool is_same_way(const tp_lattice *l, long at, long p, long q) {
  return tp_lattice_cross(l, at, p, at, q) == 0 && tp_lattice_dot(l, at, p, at, q) > 0;
}

/* A corner in a notch of another block, or at a vertex on a straight edge of it: against each flank
 * along which the blocks share no piece. */
static tp_status touch_flanks(tp_assemblage *a, const tp_edge_of_block *e,
                              const tp_edge_of_block *f, tp_message *message) {
  const tp_lattice *l = &a->lattice;
  const tp_block_corner *c = &e->corner, *notch = &f->corner;
  const int turn = tp_lattice_cross(l, notch->before, notch->point, notch->point, notch->next);
  const bool shares_next = is_same_way(l, notch->point, notch->next, c->before);
  const bool shares_before = is_same_way(l, notch->point, notch->before, c->next);
  if (turn > 0 || (turn == 0 && (shares_next || shares_before))) return TP_OK;
  tp_status status = TP_OK;
  if (!shares_next) status = add_corner(a, e, f->block, notch->point, notch->next, message);
  if (status == TP_OK && turn < 0 && !shares_before) {
    status = add_corner(a, e, f->block, notch->before, notch->point, message);
  }
  return status;
}

/* The corner e->from of one block against the edge f of another. */
static tp_status try_corner(tp_assemblage *a, const tp_edge_of_block *e, const tp_edge_of_block *f,
                            tp_message *message) {
  const tp_lattice *l = &a->lattice;
  const tp_block_corner *c = &e->corner;
  const long from = f->corner.point, to = f->corner.next;
  if (tp_lattice_same_point(l, c->point, from)) { /* a corner of both */
    const bool overlap = leads_inside(l, &f->corner, c->next) ||
                         leads_inside(l, &f->corner, c->before) || leads_inside(l, c, to);
    if (overlap) return fail_overlap(a, e->block, f->block, message);
    const tp_status status = tp_corner_pairs_try(a, e, f, message);
    return status == TP_OK ? touch_flanks(a, e, f, message) : status;
  }
  if (tp_lattice_cross(l, from, to, from, c->point) != 0 || !lies_within(l, c->point, from, to)) {
    return TP_OK;
  }
  const int next = tp_lattice_cross(l, from, to, c->point, c->next);
  const int before = tp_lattice_cross(l, from, to, c->point, c->before);
  if (next > 0 || before > 0) return fail_overlap(a, e->block, f->block, message);
  if (next == 0 || before == 0) return TP_OK; /* edges share a piece of the line */
  return add_corner(a, e, f->block, from, to, message);
}

static bool crosses(const tp_lattice *l, long p, long q, long r, long s) {
  return tp_lattice_cross(l, p, q, p, r) * tp_lattice_cross(l, p, q, p, s) < 0 &&
         tp_lattice_cross(l, r, s, r, p) * tp_lattice_cross(l, r, s, r, q) < 0;
}

static tp_status try_pair(void *context, const tp_edge_of_block *e, const tp_edge_of_block *f,
                          tp_message *message) {
  tp_assemblage *a = context;
  if (crosses(&a->lattice, e->corner.point, e->corner.next, f->corner.point, f->corner.next)) {
    return fail_overlap(a, e->block, f->block, message);
  }
  const tp_status status = try_corner(a, e, f, message);
  return status == TP_OK ? try_corner(a, f, e, message) : status;
}

/* A block all within another crosses no edge of it. */
static tp_status try_within(void *context, long block, long other, tp_message *message) {
  return fail_overlap(context, block, other, message);
}

/* By the numbers of their blocks, then along the first block's outline: whatever the axes are. */
static int compare_contacts(const void *first, const void *second) {
  const tp_block_contact *a = first, *b = second;
  for (int greater = 0; greater < 2; greater++) {
    const long p = a->block[(a->block[0] < a->block[1]) == greater];
    const long q = b->block[(b->block[0] < b->block[1]) == greater];
    if (p != q) return p < q ? -1 : 1;
  }
  if (a->from != b->from) return a->from < b->from ? -1 : 1;
  return (a->ends[0] > b->ends[0]) - (a->ends[0] < b->ends[0]);
}

static int compare_pairs(const void *first, const void *second) {
  const tp_corner_pair *a = first, *b = second;
  return compare_contacts(a->side, b->side);
}

tp_status tp_block_contacts_find(tp_assemblage *a, tp_message *message) {
  const long count = a->edge_count;
  line_edge *edges = calloc((size_t)count + 1, sizeof *edges);
  if (edges == NULL) return tp_fail_memory(message, "the contacts");
  long at = 0;
  for (long k = 0; k < a->count; k++) {
    const tp_rigid_block *block = a->blocks + k;
    for (long p = block->outline; p < block->end; p++) {
      set_edge(edges + at++, a, k, p, p + 1 < block->end ? p + 1 : block->outline);
    }
  }
  tp_status status = meet_along_lines(a, edges, count, message);
  if (status == TP_OK) {
    status = tp_edge_pairs_each(a, try_pair, try_within, message);
  }
  if (status == TP_OK && a->contact_count > 0) {
    qsort(a->contacts, (size_t)a->contact_count, sizeof *a->contacts, compare_contacts);
  }
  if (status == TP_OK && a->pair_count > 0) {
    qsort(a->pairs, (size_t)a->pair_count, sizeof *a->pairs, compare_pairs);
  }
  for (long k = 0; k < count; k++) clear_edge(edges + k);
  free(edges);
  return status;
}
