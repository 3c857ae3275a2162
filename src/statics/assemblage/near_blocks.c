/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs among the corners that lie near corners and edges of other blocks, less those in contact.
 */

#include "assemblage/near_blocks.h"

#include "assemblage/corner_search.h"
#include "common/grow.h"

#include <math.h>
#include <stdlib.h>

typedef struct pair {
  long block[2];
  double distance;
} pair;

typedef struct gathering {
  const tp_assemblage *assemblage;
  const tp_corner_search *search;
  pair *pairs;
  long count, room;
} gathering;

static tp_status gather(void *context, const tp_near_corner *near, tp_message *message) {
  gathering *g = context;
  const long a = g->search->corners[near->corner].block, b = g->search->corners[near->other].block;
  if (g->assemblage->blocks[a].number < 0 && g->assemblage->blocks[b].number < 0) return TP_OK;
  pair *pairs = tp_grow(g->pairs, g->count, &g->room, sizeof *pairs);
  if (pairs == NULL) return tp_fail_memory(message, "the corners of blocks");
  g->pairs = pairs;
  pairs[g->count++] = (pair){{a < b ? a : b, a < b ? b : a}, near->distance};
  return TP_OK;
}

static int compare_pairs(const void *first, const void *second) {
  const pair *a = first, *b = second;
  for (int k = 0; k < 2; k++) {
    if (a->block[k] != b->block[k]) return a->block[k] < b->block[k] ? -1 : 1;
  }
  return (a->distance > b->distance) - (a->distance < b->distance);
}

/* A mean of the sides of the boxes of free blocks. */
static double size_of(const gathering *g) {
  const tp_assemblage *a = g->assemblage;
  double sum = 0;
  for (long c = 0; c < g->search->count;) {
    const long block = g->search->corners[c].block;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (; c < g->search->count && g->search->corners[c].block == block; c++) {
      low[0] = fmin(low[0], g->search->corners[c].x);
      high[0] = fmax(high[0], g->search->corners[c].x);
      low[1] = fmin(low[1], g->search->corners[c].y);
      high[1] = fmax(high[1], g->search->corners[c].y);
    }
    if (a->blocks[block].number >= 0) sum += sqrt((high[0] - low[0]) * (high[1] - low[1]));
  }
  return sum / (double)a->free_count;
}

/* The contacts of an assemblage stand in the order of their pairs. */
static bool touch(const tp_assemblage *a, const pair *own) {
  long low = 0, high = a->contact_count;
  while (low < high) {
    const long middle = low + (high - low) / 2;
    const long *block = a->contacts[middle].block;
    const pair at = {
        {block[0] < block[1] ? block[0] : block[1], block[0] < block[1] ? block[1] : block[0]},
        own->distance};
    const int order = compare_pairs(&at, own);
    if (order == 0) return true;
    if (order < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return false;
}

/* Of each pair the least distance comes first; what meets in a corner has none. */
static void choose(tp_near_blocks *near, gathering *g, double size) {
  if (g->count > 0) qsort(g->pairs, (size_t)g->count, sizeof *g->pairs, compare_pairs);
  for (long k = 0; k < g->count; k++) {
    const pair *own = g->pairs + k;
    const bool again =
        k > 0 && own[-1].block[0] == own->block[0] && own[-1].block[1] == own->block[1];
    if (again || own->distance <= 1e-14 * size || touch(g->assemblage, own)) continue;
    if (near->count++ > 0 && own->distance >= near->distance) continue;
    near->block[0] = own->block[0];
    near->block[1] = own->block[1];
    near->distance = own->distance;
  }
}

tp_status tp_near_blocks_find(tp_near_blocks *near, const tp_assemblage *a, double share,
                              tp_message *message) {
  tp_corner_search search;
  *near = (tp_near_blocks){.count = 0};
  tp_status status = tp_corner_search_init(&search, a->given, a->count, message);
  if (status != TP_OK) return status;
  gathering g = {.assemblage = a, .search = &search};
  const double size = size_of(&g);
  status = tp_near_corners_each(&search, share * size, gather, &g, message);
  if (status == TP_OK) status = tp_near_edges_each(&search, share * size, gather, &g, message);
  if (status == TP_OK) choose(near, &g, size);
  free(g.pairs);
  tp_corner_search_clear(&search);
  return status;
}
