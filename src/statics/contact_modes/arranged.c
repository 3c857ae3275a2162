/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points are compared as whole numbers of the lattice. A contact has the block of the lower rank
 * first; its ends follow each other along t. As x changes its sign so do moments, and t, which runs
 * along the outline of the first block, runs the other way: so do slips, and a pair of corners has
 * its sides in the other order. */

#include "contact_modes/arranged.h"

#include "contact_modes/corner_modes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_arranged_clear(tp_arranged *a) {
  free(a->resting.block);
  free(a->resting.contacts);
  free(a->blocks);
  free(a->rank);
  free(a->level);
  free(a->number);
  free(a->contact);
  free(a->swapped);
  free(a->size);
  memset(a, 0, sizeof *a);
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

static void find_levels(tp_arranged *a) {
  const tp_assemblage *of = a->given->assemblage;
  for (long b = 0; b < of->count; b++) a->level[b] = of->blocks[b].number < 0 ? 0 : of->count;
  for (bool changed = true; changed;) {
    changed = false;
    for (long k = 0; k < a->given->contact_count; k++) {
      const long *block = a->given->contacts[k].of.block;
      for (int side = 0; side < 2; side++) {
        if (a->level[block[side]] <= a->level[block[1 - side]] + 1) continue;
        a->level[block[side]] = a->level[block[1 - side]] + 1;
        changed = true;
      }
    }
  }
}

/* Of two points against the drive, then upwards. */
static int compare_points(const tp_arranged *a, long p, long q) {
  const tp_lattice *l = &a->given->assemblage->lattice;
  const int x = fmpz_cmp(l->x + p, l->x + q);
  if (x != 0) return a->mirrored ? x : -x;
  return fmpz_cmp(l->y + p, l->y + q);
}

/* The least corner of an outline, or the greatest one. */
static long extreme(const tp_arranged *a, long block, int sign) {
  const tp_rigid_block *own = a->given->assemblage->blocks + block;
  long best = own->outline;
  for (long p = best + 1; p < own->end; p++) {
    if (sign * compare_points(a, p, best) > 0) best = p;
  }
  return best;
}

static bool is_before(const tp_arranged *a, long b, long other) {
  if (a->level[b] != a->level[other]) return a->level[b] < a->level[other];
  int order = compare_points(a, extreme(a, b, -1), extreme(a, other, -1));
  if (order == 0) order = compare_points(a, extreme(a, b, 1), extreme(a, other, 1));
  return order != 0 ? order < 0 : b < other;
}

static void order_blocks(tp_arranged *a) {
  const tp_assemblage *of = a->given->assemblage;
  for (long b = 0; b < of->count; b++) {
    a->rank[b] = 0;
    for (long other = 0; other < of->count; other++) {
      if (other != b && is_before(a, other, b)) a->rank[b]++;
    }
  }
  const long fixed = of->count - of->free_count;
  for (long b = 0; b < of->count; b++) {
    if (of->blocks[b].number < 0) continue;
    a->number[a->rank[b] - fixed] = of->blocks[b].number;
    a->resting.block[a->rank[b] - fixed] = b;
  }
}

/* About its centroid. */
static void set_block(tp_rigid_block *own) {
  const tp_near arm2 =
      tp_near_plus(tp_near_times(own->arm_x, own->arm_x), tp_near_times(own->arm_y, own->arm_y));
  own->gyration2 = tp_near_minus(own->gyration2, arm2);
  own->arm_x = own->arm_y = (tp_near){0, 0};
}

/* ---- contacts ----------------------------------------------------------------------------------
 */

static double size_of(const tp_force_column *c) {
  const tp_near *entry = c->entry[c->row[0] >= 0 ? 0 : 1];
  return hypot(entry[0].value, entry[1].value);
}

static void set_column(tp_force_column *own, const tp_arranged *a, double size, bool turns,
                       bool is_along) {
  const tp_resting *given = a->given;
  const tp_force_column c = *own;
  for (int side = 0; side < 2; side++) {
    const int from = turns ? 1 - side : side;
    tp_near *entry = own->entry[side];
    own->row[side] = c.row[from];
    memcpy(entry, c.entry[from], sizeof own->entry[side]);
    if (c.row[from] < 0) continue;
    const long b = given->block[c.row[from] / 3];
    const tp_rigid_block *block = given->assemblage->blocks + b;
    own->row[side] = 3 * (a->rank[b] - (given->assemblage->count - given->assemblage->free_count));
    entry[2] = tp_near_minus(entry[2], tp_near_minus(tp_near_times(block->arm_x, entry[1]),
                                                     tp_near_times(block->arm_y, entry[0])));
    for (int e = 0; e < 3; e++) {
      if (!tp_near_is_zero(entry[e])) entry[e] = tp_near_div(entry[e], (tp_near){size, 0});
      if (a->mirrored && (e == 1) == is_along) entry[e] = tp_near_neg(entry[e]);
    }
  }
}

static void swap(long pair[2]) {
  const long first = pair[0];
  pair[0] = pair[1];
  pair[1] = first;
}

/* Of a contact as given. */
static void set_contact(tp_resting_contact *own, bool *swapped, double *size,
                        const tp_arranged *a) {
  *size = size_of(&own->along);
  const bool turns = a->rank[own->of.block[0]] > a->rank[own->of.block[1]];
  if (turns) {
    swap(own->of.block);
    swap(own->of.along);
  }
  for (int e = 0; e < own->ends; e++) set_column(own->normal + e, a, *size, turns, false);
  set_column(&own->along, a, *size, turns, true);
  const int way = tp_lattice_dot(&a->given->assemblage->lattice, own->of.ends[0], own->of.ends[1],
                                 own->of.along[0], own->of.along[1]);
  *swapped = own->ends == 2 && (a->mirrored ? way > 0 : way < 0);
  if (!*swapped) return;
  const tp_force_column first = own->normal[0];
  own->normal[0] = own->normal[1];
  own->normal[1] = first;
  swap(own->of.ends);
}

/* By the later one of its blocks, the earlier one, where it lies, its direction. */
static int compare_contacts(const tp_arranged *a, const tp_resting_contact *c,
                            const tp_resting_contact *other) {
  for (int side = 1; side >= 0; side--) {
    const long own = a->rank[c->of.block[side]], of_other = a->rank[other->of.block[side]];
    if (own != of_other) return own < of_other ? -1 : 1;
  }
  for (int e = 0; e < 2; e++) {
    const int order = compare_points(a, c->of.ends[e], other->of.ends[e]);
    if (order != 0) return order;
  }
  for (int e = 0; e < 2; e++) {
    const double own = c->along.entry[1][e].value, of_other = other->along.entry[1][e].value;
    if (own != of_other) return own < of_other ? -1 : 1;
  }
  return 0;
}

static void move(tp_arranged *a, long to, long from) {
  a->resting.contacts[to] = a->resting.contacts[from];
  a->contact[to] = a->contact[from];
  a->swapped[to] = a->swapped[from];
  a->size[to] = a->size[from];
}

/* Into the order, of those from `first` on; of a pair of corners two at once. There is room for two
 * behind the last. */
static void insert(tp_arranged *a, long first, long at, long count) {
  const long room = a->resting.contact_count;
  long to = at;
  for (long k = 0; k < count; k++) move(a, room + k, at + k);
  for (; to > first; to -= count) {
    if (compare_contacts(a, a->resting.contacts + room, a->resting.contacts + to - count) >= 0)
      break;
    for (long k = 0; k < count; k++) move(a, to + k, to - count + k);
  }
  for (long k = 0; k < count; k++) move(a, to + k, room + k);
}

static void order_contacts(tp_arranged *a) {
  const tp_resting *given = a->given;
  tp_resting *r = &a->resting;
  for (long k = 0; k < given->contact_count; k++) {
    const long twin = given->contacts[k].twin;
    a->contact[k] = twin >= 0 && a->mirrored ? twin : k;
    r->contacts[k] = given->contacts[a->contact[k]];
    set_contact(r->contacts + k, a->swapped + k, a->size + k, a);
  }
  for (long k = 1; k < r->pair_first; k++) insert(a, 0, k, 1);
  for (long k = r->pair_first; k < r->contact_count; k += 2) insert(a, r->pair_first, k, 2);
}

/* The first contact of a line; the other side of a pair. */
static void join_contacts(tp_arranged *a) {
  tp_resting *r = &a->resting;
  for (long k = 0; k < r->contact_count; k++) {
    const long line = a->given->contacts[a->contact[k]].line;
    long first = 0;
    while (a->given->contacts[a->contact[first]].line != line) first++;
    r->contacts[k].line = first;
    r->contacts[k].twin = k < r->pair_first ? -1 : (k - r->pair_first) % 2 == 0 ? k + 1 : k - 1;
  }
}

tp_status tp_arranged_init(tp_arranged *a, const tp_resting *given, bool to_the_left,
                           tp_message *message) {
  const size_t blocks = (size_t)given->assemblage->count + 1;
  const size_t contacts = (size_t)given->contact_count + 2;
  *a = (tp_arranged){.given = given, .mirrored = to_the_left, .assemblage = *given->assemblage};
  a->resting = (tp_resting){.assemblage = &a->assemblage,
                            .rows = given->rows,
                            .contact_count = given->contact_count,
                            .pair_first = given->pair_first,
                            .slips_run_back = to_the_left,
                            .block = calloc(blocks, sizeof *a->resting.block),
                            .contacts = calloc(contacts, sizeof *a->resting.contacts)};
  a->blocks = calloc(blocks, sizeof *a->blocks);
  a->rank = calloc(blocks, sizeof *a->rank);
  a->level = calloc(blocks, sizeof *a->level);
  a->number = calloc(blocks, sizeof *a->number);
  a->contact = calloc(contacts, sizeof *a->contact);
  a->swapped = calloc(contacts, sizeof *a->swapped);
  a->size = calloc(contacts, sizeof *a->size);
  if (a->resting.block == NULL || a->resting.contacts == NULL || a->blocks == NULL ||
      a->rank == NULL || a->level == NULL || a->number == NULL || a->contact == NULL ||
      a->swapped == NULL || a->size == NULL) {
    tp_arranged_clear(a);
    return tp_fail_memory(message, "the contacts of the blocks");
  }
  find_levels(a);
  order_blocks(a);
  memcpy(a->blocks, given->assemblage->blocks, (blocks - 1) * sizeof *a->blocks);
  for (size_t b = 0; b + 1 < blocks; b++) set_block(a->blocks + b);
  a->assemblage.blocks = a->blocks;
  order_contacts(a);
  join_contacts(a);
  return TP_OK;
}

/* ---- what is given -----------------------------------------------------------------------------
 */

void tp_arranged_friction(tp_near *own, const tp_arranged *a, const tp_near *given) {
  for (long k = 0; k < a->resting.contact_count; k++) own[k] = given[a->contact[k]];
}

void tp_arranged_cohesion(tp_near *own, const tp_arranged *a, const tp_near *given) {
  for (long k = 0; k < a->resting.contact_count; k++) {
    own[k] = tp_near_times(given[a->contact[k]], (tp_near){a->size[k], 0});
  }
}

void tp_arranged_bonds(tp_near *bonds, const tp_arranged *a, const tp_near *given) {
  for (long k = 0; k < a->resting.contact_count; k++) {
    for (int e = 0; e < 2; e++) {
      const int from = a->swapped[k] ? 1 - e : e;
      bonds[2 * k + e] = tp_near_times(given[2 * a->contact[k] + from], (tp_near){a->size[k], 0});
    }
  }
}

void tp_arranged_loads(tp_near *own, const tp_arranged *a, const tp_near *given) {
  for (long k = 0; k < a->resting.rows; k++) {
    own[k] = given[3 * a->number[k / 3] + k % 3];
    if (a->mirrored && k % 3 != 1) own[k] = tp_near_neg(own[k]);
  }
}

static tp_mode_set exchange(tp_mode_set set, tp_mode_set low, int by) {
  return (set & ~(low | low << by)) | (set & low) << by | (set >> by & low);
}

static tp_mode_set mode_of(const tp_arranged *a, long k, tp_mode_set own) {
  enum { FIRST_ALONE = 2 + 4 + 8, ENDS = 3, SLIPS = 1 };
  const tp_mode_set back = a->mirrored ? exchange(own, TP_MODES_FORWARD, SLIPS) : own;
  return a->swapped[k] ? exchange(back, FIRST_ALONE, ENDS) : back;
}

void tp_arranged_modes(tp_mode_set *given, const tp_arranged *a, const tp_mode_set *own) {
  for (long k = 0; k < a->resting.contact_count; k++) {
    given[a->contact[k]] = mode_of(a, k, own[k]);
  }
  /* a pair that sticks does so by its first side */
  for (long k = a->resting.pair_first; k < a->resting.contact_count; k += 2) {
    if ((own[k] & TP_MODES_STICK) == 0) continue;
    const long first = a->mirrored ? a->contact[k + 1] : a->contact[k];
    given[first] = own[k];
    given[first + 1] = TP_MODES_OPEN;
  }
}
