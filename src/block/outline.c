/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

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

bool tp_outline_teeth(tp_polyline *outline, const tp_teeth *teeth, tp_mark mark) {
  fmpq_t x, y, zero;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(zero);
  bool done = true;
  for (long joint = 0; joint <= teeth->count && done; joint++) {
    joint_abscissa(x, teeth, joint);
    tp_outline_joint_height(y, teeth, joint);
    done = tp_polyline_append(outline, x, y, mark);
  }
  fmpq_add(y, teeth->height, teeth->depth);
  done =
      done && tp_polyline_append(outline, x, y, mark) && tp_polyline_append(outline, zero, y, mark);
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(zero);
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
