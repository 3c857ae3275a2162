/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The boundary sums of ring_sums.h in one arithmetic; included once for each. The includer defines
 * NUMBER, COORDINATE (the type of x and y), FUNCTION, PARAMETER (what operations need besides, with
 * a comma before it, or nothing) and the operations INIT, CLEAR, ZERO, SET_COORDINATE, ADD,
 * SUBTRACT, MULTIPLY and ADD_PRODUCT on pointers to NUMBER, which may be moved byte by byte.
 * `sum_count` is that of the area sums, or up to XY24, or all. All are undefined at the end. No
 * include guard: that is meant. */

static void FUNCTION(NUMBER *sums, const COORDINATE *x, const COORDINATE *y, long count,
                     int sum_count PARAMETER) {
  enum { X0, Y0, X1, Y1, C, T, Q, REGISTERS };
  NUMBER r[REGISTERS];
  for (int k = 0; k < REGISTERS; k++) INIT(r + k);
  for (int k = 0; k < sum_count; k++) ZERO(sums + k);
  if (count > 0) {
    SET_COORDINATE(r + X0, x + count - 1);
    SET_COORDINATE(r + Y0, y + count - 1);
  }
  for (long k = 0; k < count; k++) {
    SET_COORDINATE(r + X1, x + k);
    SET_COORDINATE(r + Y1, y + k);
    MULTIPLY(r + C, r + X0, r + Y1); /* c */
    MULTIPLY(r + T, r + X1, r + Y0);
    if (sum_count > TP_XY24) ADD(r + Q, r + C, r + T); /* x0 y1 + x1 y0, for XY24 */
    SUBTRACT(r + C, r + C, r + T);
    ADD(sums + TP_A2, sums + TP_A2, r + C);
    if (sum_count > TP_XY24) {
      MULTIPLY(r + T, r + X0, r + Y0);
      ADD_PRODUCT(r + T, r + X1, r + Y1);
      ADD(r + T, r + T, r + T);
      ADD(r + Q, r + Q, r + T);
      ADD_PRODUCT(sums + TP_XY24, r + Q, r + C);
    }
    for (int axis = 0; axis < 2; axis++) {
      NUMBER *from = r + (axis == 0 ? X0 : Y0), *to = r + (axis == 0 ? X1 : Y1);
      ADD(r + T, from, to);
      ADD_PRODUCT(sums + (axis == 0 ? TP_X6 : TP_Y6), r + T, r + C);
      if (sum_count > TP_AREA_SUM_COUNT) {
        MULTIPLY(r + T, r + T, to); /* x1 (x0 + x1) + x0^2 */
        ADD_PRODUCT(r + T, from, from);
        ADD_PRODUCT(sums + (axis == 0 ? TP_XX12 : TP_YY12), r + T, r + C);
      }
      const NUMBER held = *from;
      *from = *to;
      *to = held;
    }
  }
  for (int k = 0; k < REGISTERS; k++) CLEAR(r + k);
}

#undef NUMBER
#undef COORDINATE
#undef FUNCTION
#undef PARAMETER
#undef INIT
#undef CLEAR
#undef ZERO
#undef SET_COORDINATE
#undef ADD
#undef SUBTRACT
#undef MULTIPLY
#undef ADD_PRODUCT
