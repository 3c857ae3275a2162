/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks of a large ring, by as many threads as there are, joined in the order of the ring. */

#include "block/ring_sums_kernel.h"
#include "common/threads.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Levels of blocks: 63 bits of a count of edges less the 18 of a block, and one. Threads beyond
 * TP_SUMS_THREADS wait for memory. */
enum { LEVELS = 63 - 18 + 1 };

typedef struct work {
  const tp_ring *ring;
  tp_ring_kernel kernel;
  int sum_count;
  bool pairs;
  long block_count;
  atomic_long next;                /* the first block that nobody took */
  double (*results)[TP_ROW_COUNT]; /* of every block, where threads share the work */
} work;

/* The rows of a part into others, by what each row means. */
static void join(double to[TP_ROW_COUNT], const double from[TP_ROW_COUNT], const work *w) {
  for (int k = TP_ROW_MOST_U; k <= TP_ROW_MOST_V; k++) to[k] = from[k] > to[k] ? from[k] : to[k];
  const int measures = TP_ROW_SUMS + (w->pairs ? 0 : w->sum_count);
  for (int k = TP_ROW_MEASURES; k < measures; k++) to[k] += from[k];
  for (int k = measures; k < TP_ROW_SUMS + (w->pairs ? 2 * w->sum_count : 0); k += 2) {
    const double high = to[k], other = from[k], sum = high + other, of_other = sum - high;
    const double lost = (high - (sum - of_other)) + (other - of_other);
    to[k] = sum;
    to[k + 1] += lost + from[k + 1];
  }
}

static void sum_block(double rows[TP_ROW_COUNT], const work *w, long block) {
  const long first = block * TP_BLOCK_EDGES, left = w->ring->count - first;
  w->kernel(rows, w->ring, first, left < TP_BLOCK_EDGES ? left : TP_BLOCK_EDGES);
}

static void *share(void *argument) {
  work *w = argument;
  for (;;) {
    const long block = atomic_fetch_add(&w->next, 1);
    if (block >= w->block_count) return NULL;
    sum_block(w->results[block], w, block);
  }
}

/* Every block into `results`. A thread that cannot be had leaves more to the others. */
static void share_out(work *w, int threads) {
  pthread_t others[TP_SUMS_THREADS];
  int started = 0;
  for (; started + 1 < threads; started++) {
    if (pthread_create(others + started, NULL, share, w) != 0) break;
  }
  share(w);
  for (int k = 0; k < started; k++) pthread_join(others[k], NULL);
}

/* Blocks pairwise: level k holds the sum of 2^k blocks where bit k of `filled` is set. */
static void join_blocks(double rows[TP_ROW_COUNT], const work *w) {
  double levels[LEVELS][TP_ROW_COUNT];
  uint64_t filled = 0;
  for (long block = 0; block < w->block_count; block++) {
    if (w->results != NULL) {
      memcpy(rows, w->results[block], sizeof w->results[block]);
    } else {
      sum_block(rows, w, block);
    }
    int level = 0;
    for (; (filled >> level & 1) != 0; level++) join(rows, levels[level], w);
    memcpy(levels[level], rows, sizeof levels[level]);
    filled++; /* clears the levels below and sets this one */
  }
  memset(rows, 0, TP_ROW_COUNT * sizeof *rows);
  for (int level = 0; level < LEVELS; level++) {
    if ((filled >> level & 1) != 0) join(rows, levels[level], w);
  }
}

/* One thread for two blocks, for one costs about as much to start as a block takes. */
static int threads_of(tp_sums_plan plan, long block_count) {
  long threads = plan.threads;
  if (threads == 0 && block_count >= 4) threads = (long)tp_threads_present();
  if (plan.threads == 0 && threads > block_count / 2) threads = block_count / 2;
  return threads < 1 ? 1 : threads > TP_SUMS_THREADS ? TP_SUMS_THREADS : (int)threads;
}

void tp_ring_rows(double rows[TP_ROW_COUNT], const tp_ring *ring, tp_sums_plan plan, bool pairs) {
  if (ring->count <= 0) {
    memset(rows, 0, TP_ROW_COUNT * sizeof *rows);
    return;
  }
  const tp_ring_kernel kernel = tp_ring_kernel_choose(plan, pairs);
  if (ring->count <= TP_BLOCK_EDGES) {
    kernel(rows, ring, 0, ring->count);
    return;
  }
  work w = {.ring = ring,
            .kernel = kernel,
            .sum_count = plan.sum_count,
            .pairs = pairs,
            .block_count = (ring->count - 1) / TP_BLOCK_EDGES + 1};
  const int threads = threads_of(plan, w.block_count);
  if (threads > 1) w.results = calloc((size_t)w.block_count, sizeof *w.results);
  if (w.results != NULL) share_out(&w, threads);
  join_blocks(rows, &w);
  free(w.results);
}

/* Where 2^k or more, and fewer than 2^(k + 1), are added pairwise, a term passes at most k + 1
 * additions. */
static long levels_of(long count) {
  long levels = 0;
  for (; count > 0; count /= 2) levels++;
  return levels;
}

long tp_ring_additions_of_chunks(long count) {
  const long of_a_block = count < TP_BLOCK_EDGES ? count : TP_BLOCK_EDGES;
  const long chunks = (of_a_block - 1) / TP_CHUNK_EDGES + 1;
  const long blocks = (count - 1) / TP_BLOCK_EDGES + 1;
  return TP_CHUNK_EDGES / TP_LANES + 3 + levels_of(chunks) + (blocks > 1 ? levels_of(blocks) : 0);
}
