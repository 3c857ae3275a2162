/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a point of contact q, with the direction t of its facet and the normal n = (-t_y, t_x), does
 * to a twist and to a force, in one arithmetic (docs/mechanics.md sections 6 and 6a); included once
 * for each by contact_rows.h, and by derive/vector_formulas.h for symbols. Triples are forces with
 * their moment, or twists (v_x, v_y, omega), about one origin.
 *
 * The includer defines NUMBER and NAME(name), and either, of numbers that are values, PLUS, MINUS,
 * TIMES and NEGATIVE of them and WHOLE_NUMBER(n); or on pointers to NUMBER the operations SET,
 * NEGATE, ONE, ZERO, ADD, SUBTRACT, MULTIPLY, ADD_PRODUCT and SUBTRACT_PRODUCT, with PARAMETER and
 * DISCARD: what they need besides, after a comma, and that it is not needed. Where the components
 * of t are of another type it defines WHOLE, and the operations with a component as their last
 * operand. All are undefined at the end. No include guard: that is meant. */

#ifdef PLUS
#define PARAMETER
#define DISCARD
#define SET(r, a) (*(r) = *(a))
#define NEGATE(r, a) (*(r) = NEGATIVE(*(a)))
#define ONE(r) (*(r) = WHOLE_NUMBER(1))
#define ZERO(r) (*(r) = WHOLE_NUMBER(0))
#define ADD(r, a, b) (*(r) = PLUS(*(a), *(b)))
#define SUBTRACT(r, a, b) (*(r) = MINUS(*(a), *(b)))
#define MULTIPLY(r, a, b) (*(r) = TIMES(*(a), *(b)))
#define ADD_PRODUCT(r, a, b) (*(r) = PLUS(*(r), TIMES(*(a), *(b))))
#define SUBTRACT_PRODUCT(r, a, b) (*(r) = MINUS(*(r), TIMES(*(a), *(b))))
#endif
#ifndef WHOLE
#define WHOLE NUMBER
#define SET_WHOLE SET
#define ADD_WHOLE ADD
#define SUBTRACT_WHOLE SUBTRACT
#define MULTIPLY_WHOLE MULTIPLY
#define ADD_PRODUCT_WHOLE ADD_PRODUCT
#define SUBTRACT_PRODUCT_WHOLE SUBTRACT_PRODUCT
#endif

static inline void NAME(cross)(NUMBER *product, const NUMBER *a, const NUMBER *b PARAMETER) {
  for (int k = 0; k < 3; k++) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    MULTIPLY(product + k, a + next, b + last);
    SUBTRACT_PRODUCT(product + k, a + last, b + next);
  }
}

static inline void NAME(set_dot)(NUMBER *product, const NUMBER *a, const NUMBER *b PARAMETER) {
  MULTIPLY(product, a, b);
  ADD_PRODUCT(product, a + 1, b + 1);
  ADD_PRODUCT(product, a + 2, b + 2);
}

#ifdef PLUS
static inline NUMBER NAME(dot)(const NUMBER *a, const NUMBER *b) {
  NUMBER product;
  NAME(set_dot)(&product, a, b);
  return product;
}

static inline NUMBER NAME(determinant)(const NUMBER *a, const NUMBER *b, const NUMBER *c) {
  NUMBER product[3];
  NAME(cross)(product, b, c);
  return NAME(dot)(a, product);
}
#endif

static inline void NAME(reverse)(NUMBER *triple PARAMETER) {
  DISCARD;
  for (int k = 0; k < 3; k++) NEGATE(triple + k, triple + k);
}

/* h = (n, q x n): h . a is the velocity of the twist a along the normal; q x n = t . q. */
static inline void NAME(normal_row)(NUMBER *h, const NUMBER *x, const NUMBER *y, const WHOLE *tx,
                                    const WHOLE *ty PARAMETER) {
  SET_WHOLE(h, ty);
  NEGATE(h, h);
  SET_WHOLE(h + 1, tx);
  MULTIPLY_WHOLE(h + 2, x, tx);
  ADD_PRODUCT_WHOLE(h + 2, y, ty);
}

/* g = (t, q x t): g . a is its velocity along the facet. */
static inline void NAME(slip_row)(NUMBER *g, const NUMBER *x, const NUMBER *y, const WHOLE *tx,
                                  const WHOLE *ty PARAMETER) {
  SET_WHOLE(g, tx);
  SET_WHOLE(g + 1, ty);
  MULTIPLY_WHOLE(g + 2, x, ty);
  SUBTRACT_PRODUCT_WHOLE(g + 2, y, tx);
}

/* The moment of the force (e_0, e_1) at (x, y), as the third of the triple. */
static inline void NAME(moment)(NUMBER *e, const NUMBER *x, const NUMBER *y PARAMETER) {
  MULTIPLY(e + 2, x, e + 1);
  SUBTRACT_PRODUCT(e + 2, y, e);
}

/* The force along an edge of the friction cone, n + t tan(phi), or n - t tan(phi) `against` t. */
static inline void NAME(cone_edge)(NUMBER *e, const WHOLE *tx, const WHOLE *ty,
                                   const NUMBER *friction, bool against PARAMETER) {
  MULTIPLY_WHOLE(e, friction, tx);
  MULTIPLY_WHOLE(e + 1, friction, ty);
  if (against) {
    NEGATE(e, e);
    NEGATE(e + 1, e + 1);
  }
  SUBTRACT_WHOLE(e, e, ty);
  ADD_WHOLE(e + 1, e + 1, tx);
}

/* The same with its moment from the rows of its point: h + g tan(phi). */
static inline void NAME(cone_row)(NUMBER *e, const NUMBER *h, const NUMBER *g,
                                  const NUMBER *friction, bool against PARAMETER) {
  for (int k = 0; k < 3; k++) {
    MULTIPLY(e + k, friction, g + k);
    if (against) NEGATE(e + k, e + k);
    ADD(e + k, e + k, h + k);
  }
}

/* Turning about a point, counter-clockwise: (y, -x, 1). */
static inline void NAME(turn)(NUMBER *twist, const NUMBER *x, const NUMBER *y PARAMETER) {
  DISCARD;
  SET(twist, y);
  NEGATE(twist + 1, x);
  ONE(twist + 2);
}

/* What a twist, which `turns` or slides, takes to begin over the mass, times the scale s: with the
 * centroid at (x, y) / s it moves by (s v_x - omega y, s v_y + omega x), its turn takes k^2 omega.
 */
static inline void NAME(inertia)(NUMBER *own, const NUMBER *twist, const NUMBER *scale,
                                 const NUMBER *x, const NUMBER *y, const NUMBER *gyration,
                                 bool turns PARAMETER) {
  MULTIPLY(own, twist, scale);
  MULTIPLY(own + 1, twist + 1, scale);
  ZERO(own + 2);
  if (!turns) return;
  SUBTRACT_PRODUCT(own, twist + 2, y);
  ADD_PRODUCT(own + 1, twist + 2, x);
  MULTIPLY(own + 2, twist + 2, gyration);
}

/* k^2 M^-1 h of a normal row h, brought to the centroid: h_2 s - t . (x, y). */
static inline void NAME(response)(NUMBER *own, const NUMBER *h, const NUMBER *scale,
                                  const NUMBER *x, const NUMBER *y,
                                  const NUMBER *gyration PARAMETER) {
  MULTIPLY(own, h, gyration);
  MULTIPLY(own + 1, h + 1, gyration);
  MULTIPLY(own + 2, h + 2, scale);
  SUBTRACT_PRODUCT(own + 2, h + 1, x);
  ADD_PRODUCT(own + 2, h, y);
}

/* The power of the weight W, with its moments W (x, y) about the origin, on a twist at the tilt
 * alpha: (slope tan(alpha) + level) cos(alpha). */
static inline void NAME(weight_power)(NUMBER *slope, NUMBER *level, const NUMBER *twist,
                                      const NUMBER *weight, const NUMBER *x,
                                      const NUMBER *y PARAMETER) {
  MULTIPLY(slope, y, twist + 2);
  SUBTRACT_PRODUCT(slope, weight, twist);
  MULTIPLY(level, x, twist + 2);
  ADD_PRODUCT(level, weight, twist + 1);
  NEGATE(level, level);
}

#undef NUMBER
#undef NAME
#undef PLUS
#undef MINUS
#undef TIMES
#undef NEGATIVE
#undef WHOLE_NUMBER
#undef PARAMETER
#undef DISCARD
#undef SET
#undef NEGATE
#undef ONE
#undef ZERO
#undef ADD
#undef SUBTRACT
#undef MULTIPLY
#undef ADD_PRODUCT
#undef SUBTRACT_PRODUCT
#undef WHOLE
#undef SET_WHOLE
#undef ADD_WHOLE
#undef SUBTRACT_WHOLE
#undef MULTIPLY_WHOLE
#undef ADD_PRODUCT_WHOLE
#undef SUBTRACT_PRODUCT_WHOLE
