/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chunk of edges in double, after ring_sums_vector_in.h; included once for each instruction set.
 * The measures are sum |du| and sum |dv|. No include guard: that is meant. */

/* WIDTH edges into their lanes. */
INLINE void KERNEL(add_edges)(VECTOR rows[TP_ROW_SUMS + TP_SUM_COUNT], VECTOR u0, VECTOR v0,
                              VECTOR u1, VECTOR v1, int sum_count) {
  VECTOR *const sums = rows + TP_ROW_SUMS;
  const VECTOR du = u1 - u0, dv = v1 - v0;
  const VECTOR c = u0 * dv - v0 * du;
  const VECTOR u = u0 + u1, v = v0 + v1;
  sums[TP_A2] += c;
  sums[TP_X6] += u * c;
  sums[TP_Y6] += v * c;
  if (sum_count == TP_SUM_COUNT) {
    sums[TP_XX12] += (u1 * u + u0 * u0) * c;
    sums[TP_YY12] += (v1 * v + v0 * v0) * c;
    sums[TP_XY24] += ((u0 * v1 + u1 * v0) + 2 * (u0 * v0 + u1 * v1)) * c;
  }
  rows[TP_ROW_MEASURES] += KERNEL(absolute)(du);
  rows[TP_ROW_MEASURES + 1] += KERNEL(absolute)(dv);
  rows[TP_ROW_MOST_U] = LARGER(KERNEL(absolute)(u0), rows[TP_ROW_MOST_U]);
  rows[TP_ROW_MOST_V] = LARGER(KERNEL(absolute)(v0), rows[TP_ROW_MOST_V]);
}

/* Row by row, and not by a loop, so that the rows are registers for compilers, too. */
INLINE void KERNEL(store_rows)(lane_rows *out, const VECTOR rows[TP_ROW_SUMS + TP_SUM_COUNT],
                               long lane, int sum_count) {
  KERNEL(store)(out->row[TP_ROW_MOST_U] + lane, rows[TP_ROW_MOST_U]);
  KERNEL(store)(out->row[TP_ROW_MOST_V] + lane, rows[TP_ROW_MOST_V]);
  KERNEL(store)(out->row[TP_ROW_MEASURES] + lane, rows[TP_ROW_MEASURES]);
  KERNEL(store)(out->row[TP_ROW_MEASURES + 1] + lane, rows[TP_ROW_MEASURES + 1]);
  KERNEL(store)(out->row[TP_ROW_SUMS + TP_A2] + lane, rows[TP_ROW_SUMS + TP_A2]);
  KERNEL(store)(out->row[TP_ROW_SUMS + TP_X6] + lane, rows[TP_ROW_SUMS + TP_X6]);
  KERNEL(store)(out->row[TP_ROW_SUMS + TP_Y6] + lane, rows[TP_ROW_SUMS + TP_Y6]);
  if (sum_count == TP_AREA_SUM_COUNT) return;
  KERNEL(store)(out->row[TP_ROW_SUMS + TP_XX12] + lane, rows[TP_ROW_SUMS + TP_XX12]);
  KERNEL(store)(out->row[TP_ROW_SUMS + TP_YY12] + lane, rows[TP_ROW_SUMS + TP_YY12]);
  KERNEL(store)(out->row[TP_ROW_SUMS + TP_XY24] + lane, rows[TP_ROW_SUMS + TP_XY24]);
}

/* A chunk lies in the nearest cache and is passed once for every WIDTH lanes, so that their sums
 * stay in registers. */
INLINE void KERNEL(plain_chunk)(lane_rows *out, const span *s, int sum_count) {
  for (long lane = 0; lane < TP_LANES; lane += WIDTH) {
    VECTOR rows[TP_ROW_SUMS + TP_SUM_COUNT] = {0};
    const double *u = s->u + lane, *v = s->v + lane;
    for (const double *const end = s->u + s->whole; u < end; u += TP_LANES, v += TP_LANES) {
      KERNEL(add_edges)
      (rows, KERNEL(load)(u), KERNEL(load)(v), KERNEL(load)(u + 1), KERNEL(load)(v + 1), sum_count);
    }
    const long left = s->count - s->whole - lane;
    if (left > 0) {
      KERNEL(add_edges)
      (rows, KERNEL(load_first)(u, left), KERNEL(load_first)(v, left),
       KERNEL(load_second)(u, left, s->end_u), KERNEL(load_second)(v, left, s->end_v), sum_count);
    }
    KERNEL(store_rows)(out, rows, lane, sum_count);
  }
}
