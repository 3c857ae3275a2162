/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What one triangle adds to the first COUNT sums of solid_sums.h, in one arithmetic; included once
 * for each. The includer defines COUNT, NUMBER, FUNCTION and the operations ADD, SUBTRACT, MULTIPLY
 * and ADD_PRODUCT on pointers to NUMBER. `r` are SOLID_REGISTERS numbers to compute in. All are
 * undefined at the end. No include guard: that is meant.
 *
 * The tetrahedron of the origin and the corners a, b, c: with d = a . (b x c), six times its
 * volume, and s = a + b + c, 24 int x  = d s_x,   120 int x y = d (a_x a_y + b_x b_y + c_x c_y +
 * s_x s_y). */

static void FUNCTION(NUMBER *sums, const NUMBER *const corners[3], NUMBER *r) {
  enum { D, T, S, E = S + 3, F = E + 3 }; /* S, E, F: three each */
  const NUMBER *a = corners[0], *b = corners[1], *c = corners[2];
  for (int k = 0; k < 3; k++) {
    SUBTRACT(r + E + k, b + k, a + k);
    SUBTRACT(r + F + k, c + k, a + k);
  }
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    MULTIPLY(r + T, r + E + i, r + F + j);
    MULTIPLY(r + S, r + E + j, r + F + i);
    SUBTRACT(r + T, r + T, r + S);
    if (k == 0) {
      MULTIPLY(r + D, a, r + T);
    } else {
      ADD_PRODUCT(r + D, a + k, r + T);
    }
  }
  ADD(sums + TP_SOLID_V6, sums + TP_SOLID_V6, r + D);
  for (int k = 0; k < 3; k++) {
    ADD(r + S + k, a + k, b + k);
    ADD(r + S + k, r + S + k, c + k);
    ADD_PRODUCT(sums + TP_SOLID_X24 + k, r + D, r + S + k);
  }
  for (int k = TP_SOLID_XX120; k < COUNT; k++) {
    const int i = tp_solid_axes[k - TP_SOLID_XX120][0], j = tp_solid_axes[k - TP_SOLID_XX120][1];
    MULTIPLY(r + T, a + i, a + j);
    ADD_PRODUCT(r + T, b + i, b + j);
    ADD_PRODUCT(r + T, c + i, c + j);
    ADD_PRODUCT(r + T, r + S + i, r + S + j);
    ADD_PRODUCT(sums + k, r + D, r + T);
  }
}

#undef COUNT
#undef NUMBER
#undef FUNCTION
#undef ADD
#undef SUBTRACT
#undef MULTIPLY
#undef ADD_PRODUCT
