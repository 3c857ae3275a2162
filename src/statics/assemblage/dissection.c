/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A cut halves blocks by one of their coordinates. Those on it are the fewest that all contacts
 * across it have an end in: a least vertex cover of these, from a greatest matching (Koenig 1931).
 * Of both coordinates the one with fewer is taken. */

#include "assemblage/dissection.h"
#include "assemblage/touching.h"

#include <stdlib.h>
#include <string.h>

enum { FEW = 6 }; /* that are not cut any more */

typedef enum side { ELSEWHERE, LOWER, UPPER, ON_CUT } side;

typedef struct placed {
  double at[2];
  long number;
} placed;

typedef struct dissecting {
  tp_dissection *d;
  placed *blocks;       /* those that are cut follow each other */
  unsigned char *sides; /* by number */
  long *match;          /* by number: whom it is matched with; -1 */
  long *seen, stamp;    /* by number: in which search */
  long ordered;
} dissecting;

static int compare_along(const placed *a, const placed *b, int axis) {
  for (int k = 0; k < 2; k++) {
    const double p = a->at[k == 0 ? axis : !axis], q = b->at[k == 0 ? axis : !axis];
    if (p < q) return -1;
    if (p > q) return 1;
  }
  return a->number < b->number ? -1 : a->number > b->number;
}

static int compare_x(const void *a, const void *b) {
  return compare_along(a, b, 0);
}

static int compare_y(const void *a, const void *b) {
  return compare_along(a, b, 1);
}

/* ---- the blocks on a cut -----------------------------------------------------------------------
 */

/* Can a lower block be matched, if others are matched anew? */
static bool match_one(dissecting *s, long block) {
  const tp_dissection *d = s->d;
  for (long k = d->first[block]; k < d->first[block + 1]; k++) {
    const long other = d->neighbours[k];
    if (s->sides[other] != UPPER || s->seen[other] == s->stamp) continue;
    s->seen[other] = s->stamp;
    if (s->match[other] < 0 || match_one(s, s->match[other])) {
      s->match[other] = block;
      s->match[block] = other;
      return true;
    }
  }
  return false;
}

/* What alternating paths from a lower block without a match come to. */
static void reach(dissecting *s, long block) {
  const tp_dissection *d = s->d;
  if (s->seen[block] == s->stamp) return;
  s->seen[block] = s->stamp;
  for (long k = d->first[block]; k < d->first[block + 1]; k++) {
    const long other = d->neighbours[k];
    if (s->sides[other] != UPPER || s->seen[other] == s->stamp) continue;
    s->seen[other] = s->stamp;
    reach(s, s->match[other]);
  }
}

/* Sides of all, those on the cut too; how many these are. */
static long cut(dissecting *s, placed *blocks, long count, int axis) {
  qsort(blocks, (size_t)count, sizeof *blocks, axis == 0 ? compare_x : compare_y);
  for (long k = 0; k < count; k++) {
    s->sides[blocks[k].number] = k < count / 2 ? LOWER : UPPER;
    s->match[blocks[k].number] = -1;
  }
  for (long k = 0; k < count / 2; k++) {
    s->stamp++;
    (void)match_one(s, blocks[k].number);
  }
  s->stamp++;
  for (long k = 0; k < count / 2; k++) {
    if (s->match[blocks[k].number] < 0) reach(s, blocks[k].number);
  }
  long on_cut = 0;
  for (long k = 0; k < count; k++) {
    const long own = blocks[k].number;
    const bool reached = s->seen[own] == s->stamp;
    if (s->match[own] < 0 || reached == (k < count / 2)) continue;
    s->sides[own] = ON_CUT;
    on_cut++;
  }
  return on_cut;
}

/* ---- parts -------------------------------------------------------------------------------------
 */

static void add_part(dissecting *s, const placed *blocks, long count, long from) {
  tp_dissection *d = s->d;
  const long own = d->part_count;
  if (count == 0) return;
  d->parts[d->part_count++] = (tp_dissected_part){s->ordered, s->ordered + count, -1};
  for (long k = 0; k < count; k++) {
    d->place[blocks[k].number] = s->ordered;
    d->order[s->ordered++] = blocks[k].number;
  }
  for (long k = from; k < own; k++) {
    if (d->parts[k].parent < 0) d->parts[k].parent = own;
  }
}

/* Lower ones first, those on the cut last. */
static int by_side(const dissecting *s, const placed *block) {
  const int own = s->sides[block->number];
  return own == LOWER ? 0 : own == UPPER ? 1 : 2;
}

static void part_blocks(dissecting *s, placed *blocks, long count, placed *room, long sizes[3]) {
  long at = 0;
  for (int own = 0; own < 3; own++) {
    const long first = at;
    for (long k = 0; k < count; k++) {
      if (by_side(s, blocks + k) == own) room[at++] = blocks[k];
    }
    sizes[own] = at - first;
  }
  memcpy(blocks, room, (size_t)count * sizeof *blocks);
  for (long k = 0; k < count; k++) s->sides[blocks[k].number] = ELSEWHERE;
}

static void dissect(dissecting *s, placed *blocks, long count, placed *room) {
  const long from = s->d->part_count;
  if (count <= FEW) {
    add_part(s, blocks, count, from);
    return;
  }
  long sizes[3];
  const long by_x = cut(s, blocks, count, 0), by_y = cut(s, blocks, count, 1);
  if (by_x < by_y) (void)cut(s, blocks, count, 0);
  part_blocks(s, blocks, count, room, sizes);
  dissect(s, blocks, sizes[0], room);
  dissect(s, blocks + sizes[0], sizes[1], room);
  add_part(s, blocks + sizes[0] + sizes[1], sizes[2], from);
}

/* Places against the first one's, so that far from the origin they differ too. */
static void place_all(placed *blocks, const tp_force_program *p) {
  const tp_assemblage *a = p->assemblage;
  for (long b = 0; b < p->rows / 3; b++) {
    const tp_rigid_block *own = a->blocks + p->block[b], *first = a->blocks + p->block[0];
    blocks[b] = (placed){{tp_assemblage_length(a, first->x, own->x).value,
                          tp_assemblage_length(a, first->y, own->y).value},
                         b};
  }
}

bool tp_dissection_init(tp_dissection *d, const tp_force_program *p) {
  const size_t blocks = (size_t)p->rows / 3 + 1;
  *d = (tp_dissection){.block_count = p->rows / 3,
                       .order = calloc(blocks, sizeof *d->order),
                       .place = calloc(blocks, sizeof *d->place),
                       .first = calloc(blocks, sizeof *d->first),
                       .parts = calloc(blocks, sizeof *d->parts)};
  dissecting s = {.d = d,
                  .blocks = calloc(2 * blocks, sizeof *s.blocks),
                  .sides = calloc(blocks, sizeof *s.sides),
                  .match = calloc(blocks, sizeof *s.match),
                  .seen = calloc(blocks, sizeof *s.seen)};
  const bool done = d->order != NULL && d->place != NULL && d->first != NULL && d->parts != NULL &&
                    s.blocks != NULL && s.sides != NULL && s.match != NULL && s.seen != NULL &&
                    tp_touching_find(d->first, &d->neighbours, p);
  if (done) {
    place_all(s.blocks, p);
    dissect(&s, s.blocks, d->block_count, s.blocks + blocks);
  }
  free(s.blocks);
  free(s.sides);
  free(s.match);
  free(s.seen);
  return done;
}

void tp_dissection_clear(tp_dissection *d) {
  free(d->order);
  free(d->place);
  free(d->first);
  free(d->neighbours);
  free(d->parts);
  *d = (tp_dissection){.block_count = 0};
}
