/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The kernels of one instruction set; included once for each, with the macros of
 * ring_sums_vector_in.h. No include guard: that is meant. */

#include "block/ring_sums_vector_in.h"

#include "block/ring_sums_plain_in.h"

#include "block/ring_sums_pair_in.h"

INLINE void KERNEL(chunk)(lane_rows *out, const span *s, int sum_count, bool pairs) {
  if (pairs) {
    KERNEL(pair_chunk)(out, s, sum_count);
  } else {
    KERNEL(plain_chunk)(out, s, sum_count);
  }
}

/* Chunks pairwise: level k holds the sum of 2^k chunks where bit k of `filled` is set. */
INLINE void KERNEL(chunks)(lane_rows *out, const tp_ring *ring, long first, long count,
                           int sum_count, bool pairs) {
  lane_rows levels[BLOCK_LEVELS];
  unsigned filled = 0;
  for (long done = 0; done < count; done += TP_CHUNK_EDGES) {
    const long left = count - done;
    const span s = span_of(ring, first + done, left < TP_CHUNK_EDGES ? left : TP_CHUNK_EDGES);
    KERNEL(chunk)(out, &s, sum_count, pairs);
    int level = 0;
    for (; (filled >> level & 1) != 0; level++) {
      KERNEL(join)(out, levels + level, sum_count, pairs);
    }
    memcpy(levels + level, out, sizeof *out);
    filled++; /* clears the levels below and sets this one */
  }
  memset(out, 0, sizeof *out);
  for (int level = 0; level < BLOCK_LEVELS; level++) {
    if ((filled >> level & 1) != 0) KERNEL(join)(out, levels + level, sum_count, pairs);
  }
}

/* A small ring is one chunk, and asks for no levels. */
#define BLOCK(name, all_chunks, sum_count, pairs)                                                  \
  static TARGET __attribute__((noinline)) void all_chunks(                                         \
      double rows[TP_ROW_COUNT], const tp_ring *ring, long first, long count) {                    \
    lane_rows lanes;                                                                               \
    KERNEL(chunks)(&lanes, ring, first, count, sum_count, pairs);                                  \
    join_lanes(rows, &lanes, sum_count, pairs);                                                    \
  }                                                                                                \
  static TARGET void name(double rows[TP_ROW_COUNT], const tp_ring *ring, long first,              \
                          long count) {                                                            \
    if (count > TP_CHUNK_EDGES) {                                                                  \
      all_chunks(rows, ring, first, count);                                                        \
      return;                                                                                      \
    }                                                                                              \
    lane_rows lanes;                                                                               \
    const span s = span_of(ring, first, count);                                                    \
    KERNEL(chunk)(&lanes, &s, sum_count, pairs);                                                   \
    join_lanes(rows, &lanes, sum_count, pairs);                                                    \
  }
BLOCK(KERNEL(plain_area), KERNEL(plain_area_chunks), TP_AREA_SUM_COUNT, false)
BLOCK(KERNEL(plain_all), KERNEL(plain_all_chunks), TP_SUM_COUNT, false)
BLOCK(KERNEL(pair_area), KERNEL(pair_area_chunks), TP_AREA_SUM_COUNT, true)
BLOCK(KERNEL(pair_all), KERNEL(pair_all_chunks), TP_SUM_COUNT, true)

#undef BLOCK
#undef INLINE
#undef VECTOR
#undef BITS
#undef PAIR
