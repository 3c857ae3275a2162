/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vertices of a toothed block and the corners of its slabs and triangles (Fig. 5, Appendix A) from
 * N, a, b and c, in rationals. */

#include "block/outline.h"

void tp_outline_joint_height(fmpq_t y, const tp_teeth *teeth, long joint) {
  const bool even = joint % 2 == 0;
  if (even == teeth->left_end_valley) {
    fmpq_zero(y);
  } else {
    fmpq_set(y, teeth->depth);
  }
}

static void joint_abscissa(fmpq_t x, const tp_teeth *teeth, long joint) {
  fmpz_t k;
  fmpz_init_set_si(k, joint);
  fmpq_mul_fmpz(x, teeth->width, k);
  fmpz_clear(k);
}

tp_teeth_point tp_outline_teeth_point(const tp_teeth *teeth, long k) {
  if (k <= teeth->count) {
    const bool low = (k % 2 == 0) == teeth->left_end_valley;
    return (tp_teeth_point){k, 0, low ? 0 : 1};
  }
  return (tp_teeth_point){k == teeth->count + 1 ? teeth->count : 0, 1, 1};
}

bool tp_outline_teeth(tp_polyline *outline, const tp_teeth *teeth, tp_mark mark) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  bool done = true;
  for (long k = 0; k < teeth->count + 3 && done; k++) {
    const tp_teeth_point p = tp_outline_teeth_point(teeth, k);
    joint_abscissa(x, teeth, p.x_a);
    fmpq_zero(y);
    if (p.y_b != 0) fmpq_add(y, y, teeth->height);
    if (p.y_c != 0) fmpq_add(y, y, teeth->depth);
    done = tp_polyline_append(outline, x, y, mark);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return done;
}

bool tp_outline_teeth_elements(tp_polyline *corners, const tp_teeth *teeth) {
  fmpq_t x, top;
  fmpq_init(x);
  fmpq_init(top);
  fmpq_add(top, teeth->height, teeth->depth);
  bool done = true;
  for (long joint = 0; joint <= teeth->count && done; joint++) {
    joint_abscissa(x, teeth, joint);
    done = tp_polyline_append(corners, x, teeth->depth, (tp_mark){0}) &&
           tp_polyline_append(corners, x, top, (tp_mark){0});
  }
  fmpq_clear(x);
  fmpq_clear(top);
  return done;
}
