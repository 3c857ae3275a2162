/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of a point of contact, edges of its friction cone, their moments, inertia and the power of
 * the weight, from the one definition in contact_rows_in.h: in doubles (tp_double_…), in doubles
 * with bounds (tp_near_…), in these with exact zeros kept (tp_sparse_…), and in balls (tp_ball_…),
 * there with t in whole numbers. */

#ifndef TP_PLANE_CONTACT_ROWS_H
#define TP_PLANE_CONTACT_ROWS_H

#include "number/near.h"
#include "topple_basics.h"

#include <arb.h>
#include <stdbool.h>

#define NUMBER double
#define NAME(name) tp_double_##name
#define PLUS(a, b) ((a) + (b))
#define MINUS(a, b) ((a) - (b))
#define TIMES(a, b) ((a) * (b))
#define NEGATIVE(a) (-(a))
#define WHOLE_NUMBER(n) (n)
#include "plane/contact_rows_in.h"

#define NUMBER tp_near
#define NAME(name) tp_near_##name
#define PLUS tp_near_add
#define MINUS tp_near_sub
#define TIMES tp_near_mul
#define NEGATIVE tp_near_neg
#define WHOLE_NUMBER(n) ((tp_near){n, 0})
#include "plane/contact_rows_in.h"

#define NUMBER tp_near
#define NAME(name) tp_sparse_##name
#define PLUS tp_near_plus
#define MINUS tp_near_minus
#define TIMES tp_near_times
#define NEGATIVE tp_near_neg
#define WHOLE_NUMBER(n) ((tp_near){n, 0})
#include "plane/contact_rows_in.h"

#define NUMBER arb_struct
#define NAME(name) tp_ball_##name
#define PARAMETER , long bits
#define DISCARD (void)bits
#define SET arb_set
#define NEGATE arb_neg
#define ONE arb_one
#define ZERO arb_zero
#define ADD(r, a, b) arb_add(r, a, b, bits)
#define SUBTRACT(r, a, b) arb_sub(r, a, b, bits)
#define MULTIPLY(r, a, b) arb_mul(r, a, b, bits)
#define ADD_PRODUCT(r, a, b) arb_addmul(r, a, b, bits)
#define SUBTRACT_PRODUCT(r, a, b) arb_submul(r, a, b, bits)
#define WHOLE fmpz
#define SET_WHOLE arb_set_fmpz
#define ADD_WHOLE(r, a, b) arb_add_fmpz(r, a, b, bits)
#define SUBTRACT_WHOLE(r, a, b) arb_sub_fmpz(r, a, b, bits)
#define MULTIPLY_WHOLE(r, a, b) arb_mul_fmpz(r, a, b, bits)
#define ADD_PRODUCT_WHOLE(r, a, b) arb_addmul_fmpz(r, a, b, bits)
#define SUBTRACT_PRODUCT_WHOLE(r, a, b) arb_submul_fmpz(r, a, b, bits)
#include "plane/contact_rows_in.h"

/* x, or a component along it, of the scene in the frame of a tilt, whose side down-dip is -x, or
 * back: mirrored towards the right. */
static inline void tp_ball_mirror(arb_t x, tp_direction towards) {
  if (towards == TP_TOWARDS_RIGHT) arb_neg(x, x);
}

#endif
