/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The steps of the simplex method in floating point of any number of bits (simplex.c has them in
 * doubles). */

#ifndef TP_LINEAR_PROGRAM_PRECISE_STEP_H
#define TP_LINEAR_PROGRAM_PRECISE_STEP_H

#include "linear_program/simplex.h"
#include "number/work.h"

#include <arf.h>

/* Numbers at work: an inverse of 3 by 3, six vectors of 3, and six alone. */
enum { TP_PRECISE_SCRATCH = 3 * 3 + 6 * 3 + 6 };

typedef struct tp_precise {
  long count, bits, first_bounded;
  arf_struct *columns, *most; /* three entries a column; most: infinite where it is not bounded */
  bool *at_most;              /* NULL: none is bounded */
  arf_struct *scratch;        /* what the numbers below share */
  arf_struct *direction, *target, *inverse, *values, *prices, *step, *rest;
  arf_struct *size, *far, *own, *term, *best, *least;
  bool first_phase, has_t;
  int sign[3];
  long basis[3];
  tp_work *work; /* NULL: steps are not counted */
} tp_precise;

/* Hands the scratch out; the rest is the caller's to fill. */
void tp_precise_share(tp_precise *p);

tp_simplex_outcome tp_precise_run(tp_precise *p);

#endif
