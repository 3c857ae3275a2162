/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chunk of edges in pairs, after ring_sums_vector_in.h; included once for each instruction set.
 * The first measure is sum |high part of c|, the second is not used. What each line loses is
 * counted in ring_sums_compensated.c. No include guard: that is meant. */

/* A term into its sum: what the sum of the high parts loses goes to the low part. */
INLINE void KERNEL(add_pair)(PAIR *sum, PAIR term) {
  const PAIR high = KERNEL(two_sum)(sum->high, term.high);
  sum->high = high.high;
  sum->low += high.low + term.low;
}

/* c = u0 v1 - u1 v0. */
INLINE PAIR KERNEL(cross)(VECTOR u0, VECTOR v0, VECTOR u1, VECTOR v1) {
  const PAIR p = KERNEL(two_product)(u0, v1), q = KERNEL(two_product)(u1, v0);
  const PAIR c = KERNEL(two_sum)(p.high, -q.high);
  return (PAIR){c.high, c.low + (p.low - q.low)};
}

/* The exact u times a pair. */
INLINE PAIR KERNEL(scaled)(VECTOR u, PAIR c) {
  const PAIR p = KERNEL(two_product)(u, c.high);
  return (PAIR){p.high, p.low + u * c.low};
}

INLINE PAIR KERNEL(product)(PAIR q, PAIR c) {
  const PAIR p = KERNEL(two_product)(q.high, c.high);
  return (PAIR){p.high, p.low + (q.high * c.low + q.low * c.high)};
}

/* a^2 + a b + b^2. */
INLINE PAIR KERNEL(square_form)(VECTOR a, VECTOR b) {
  const PAIR aa = KERNEL(two_product)(a, a), ab = KERNEL(two_product)(a, b),
             bb = KERNEL(two_product)(b, b);
  const PAIR two = KERNEL(two_sum)(aa.high, ab.high), all = KERNEL(two_sum)(two.high, bb.high);
  return (PAIR){all.high, (two.low + all.low) + ((aa.low + ab.low) + bb.low)};
}

/* u0 v1 + u1 v0 + 2 (u0 v0 + u1 v1). */
INLINE PAIR KERNEL(mixed_form)(VECTOR u0, VECTOR v0, VECTOR u1, VECTOR v1) {
  const PAIR p = KERNEL(two_product)(u0, v1), q = KERNEL(two_product)(u1, v0),
             r = KERNEL(two_product)(u0, v0), s = KERNEL(two_product)(u1, v1);
  const PAIR once = KERNEL(two_sum)(p.high, q.high), twice = KERNEL(two_sum)(r.high, s.high),
             all = KERNEL(two_sum)(once.high, 2 * twice.high);
  return (PAIR){all.high,
                ((once.low + 2 * twice.low) + all.low) + ((p.low + q.low) + 2 * (r.low + s.low))};
}

/* c of every edge of a chunk, after that of the edge before; 0 beyond the end. */
typedef struct KERNEL(crosses) {
  _Alignas(64) double high[TP_LANES + TP_CHUNK_EDGES];
  _Alignas(64) double low[TP_LANES + TP_CHUNK_EDGES];
} KERNEL(crosses);

INLINE PAIR KERNEL(cross_load)(const KERNEL(crosses) * c, long k) {
  return (PAIR){KERNEL(load)(c->high + k), KERNEL(load)(c->low + k)};
}

INLINE void KERNEL(cross_store)(KERNEL(crosses) * c, long k, PAIR cross) {
  KERNEL(store)(c->high + k, cross.high);
  KERNEL(store)(c->low + k, cross.low);
}

INLINE void KERNEL(store_sum)(lane_rows *out, int sum, long lane, PAIR value) {
  KERNEL(store)(out->row[TP_ROW_SUMS + 2 * sum] + lane, value.high);
  KERNEL(store)(out->row[TP_ROW_SUMS + 2 * sum + 1] + lane, value.low);
}

/* First pass: c, its sum, the measure and the largest coordinates. */
INLINE void KERNEL(areas)(lane_rows *out, KERNEL(crosses) * c, const span *s, long lane) {
  VECTOR most_u = {0}, most_v = {0}, measure = {0};
  PAIR area = {{0}, {0}};
  for (long k = lane; k < s->count; k += TP_LANES) {
    VECTOR u0, v0, u1, v1;
    if (k < s->whole) {
      u0 = KERNEL(load)(s->u + k);
      v0 = KERNEL(load)(s->v + k);
      u1 = KERNEL(load)(s->u + k + 1);
      v1 = KERNEL(load)(s->v + k + 1);
    } else {
      u0 = KERNEL(load_first)(s->u + k, s->count - k);
      v0 = KERNEL(load_first)(s->v + k, s->count - k);
      u1 = KERNEL(load_second)(s->u + k, s->count - k, s->end_u);
      v1 = KERNEL(load_second)(s->v + k, s->count - k, s->end_v);
    }
    const PAIR cross = KERNEL(cross)(u0, v0, u1, v1);
    KERNEL(cross_store)(c, TP_LANES + k, cross);
    KERNEL(add_pair)(&area, cross);
    measure += KERNEL(absolute)(cross.high);
    most_u = LARGER(KERNEL(absolute)(u0), most_u);
    most_v = LARGER(KERNEL(absolute)(v0), most_v);
  }
  KERNEL(store)(out->row[TP_ROW_MOST_U] + lane, most_u);
  KERNEL(store)(out->row[TP_ROW_MOST_V] + lane, most_v);
  KERNEL(store)(out->row[TP_ROW_MEASURES] + lane, measure);
  KERNEL(store)(out->row[TP_ROW_MEASURES + 1] + lane, (VECTOR){0});
  KERNEL(store_sum)(out, TP_A2, lane, area);
}

/* Second pass, by vertices: sum (u_k + u_{k+1}) c_k = sum u_k (c_{k-1} + c_k), where u_k is exact.
 * Meanwhile the next chunk is on its way from memory. */
INLINE void KERNEL(first_moments)(lane_rows *out, const KERNEL(crosses) * c, const span *s,
                                  long lane) {
  PAIR sum_u = {{0}, {0}}, sum_v = {{0}, {0}};
  for (long k = lane; k < s->count; k += TP_LANES) {
    const VECTOR u =
        k < s->whole ? KERNEL(load)(s->u + k) : KERNEL(load_first)(s->u + k, s->count - k);
    const VECTOR v =
        k < s->whole ? KERNEL(load)(s->v + k) : KERNEL(load_first)(s->v + k, s->count - k);
    if (lane == 0) __builtin_prefetch(s->u + k + TP_CHUNK_EDGES);
    if (lane == 0) __builtin_prefetch(s->v + k + TP_CHUNK_EDGES);
    const PAIR before = KERNEL(cross_load)(c, TP_LANES + k - 1),
               after = KERNEL(cross_load)(c, TP_LANES + k);
    const PAIR high = KERNEL(two_sum)(before.high, after.high);
    const PAIR both = {high.high, high.low + (before.low + after.low)};
    KERNEL(add_pair)(&sum_u, KERNEL(scaled)(u, both));
    KERNEL(add_pair)(&sum_v, KERNEL(scaled)(v, both));
  }
  KERNEL(store_sum)(out, TP_X6, lane, sum_u);
  KERNEL(store_sum)(out, TP_Y6, lane, sum_v);
}

/* Third pass, where it is called for. */
INLINE void KERNEL(second_moments)(lane_rows *out, const KERNEL(crosses) * c, const span *s,
                                   long lane) {
  PAIR sum_uu = {{0}, {0}}, sum_vv = {{0}, {0}}, sum_uv = {{0}, {0}};
  for (long k = lane; k < s->count; k += TP_LANES) {
    VECTOR u0, v0, u1, v1;
    if (k < s->whole) {
      u0 = KERNEL(load)(s->u + k);
      v0 = KERNEL(load)(s->v + k);
      u1 = KERNEL(load)(s->u + k + 1);
      v1 = KERNEL(load)(s->v + k + 1);
    } else {
      u0 = KERNEL(load_first)(s->u + k, s->count - k);
      v0 = KERNEL(load_first)(s->v + k, s->count - k);
      u1 = KERNEL(load_second)(s->u + k, s->count - k, s->end_u);
      v1 = KERNEL(load_second)(s->v + k, s->count - k, s->end_v);
    }
    const PAIR cross = KERNEL(cross_load)(c, TP_LANES + k);
    KERNEL(add_pair)(&sum_uu, KERNEL(product)(KERNEL(square_form)(u0, u1), cross));
    KERNEL(add_pair)(&sum_vv, KERNEL(product)(KERNEL(square_form)(v0, v1), cross));
    KERNEL(add_pair)(&sum_uv, KERNEL(product)(KERNEL(mixed_form)(u0, v0, u1, v1), cross));
  }
  KERNEL(store_sum)(out, TP_XX12, lane, sum_uu);
  KERNEL(store_sum)(out, TP_YY12, lane, sum_vv);
  KERNEL(store_sum)(out, TP_XY24, lane, sum_uv);
}

INLINE void KERNEL(pair_chunk)(lane_rows *out, const span *s, int sum_count) {
  KERNEL(crosses) c;
  const PAIR before = KERNEL(cross)(s->before_u + (VECTOR){0}, s->before_v + (VECTOR){0},
                                    s->u[0] + (VECTOR){0}, s->v[0] + (VECTOR){0});
  KERNEL(cross_store)(&c, TP_LANES - WIDTH, before);
  for (long lane = 0; lane < TP_LANES; lane += WIDTH) KERNEL(areas)(out, &c, s, lane);
  for (long lane = 0; lane < TP_LANES; lane += WIDTH) KERNEL(first_moments)(out, &c, s, lane);
  if (sum_count < TP_SUM_COUNT) return;
  for (long lane = 0; lane < TP_LANES; lane += WIDTH) KERNEL(second_moments)(out, &c, s, lane);
}
