/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The cones in doubles, each column scaled to size one, lengths by that of the contact, moments
 * about a point of it: what the simplex method works on. A sketch finds a basis; a face then proves
 * it. */

#ifndef TP_SKETCH_H
#define TP_SKETCH_H

#include "limit/cones.h"
#include "limit/simplex.h"
#include "limit/vector.h"

typedef struct tp_sketch tp_sketch;
struct tp_sketch {
  long count;
  double (*columns)[3];
  double *most; /* NULL: none is bounded; in units of `force` */
  bool *at_most;
  long length_exponent, force_exponent; /* units of 2^ */
  arb_t x, y;                           /* what moments are about, exact */
  double error, largest[3];             /* bounds: of the entries' error; of each row's entries */
  long bits;
  bool out_of_memory; /* in a step on it: what was left open is open for want of memory */
};

/* `size` is a wrench of the size of the loads, the weight's say. False when memory is exhausted. */
bool tp_sketch_init(tp_sketch *sketch, const tp_cones *cones, const tp_vector *size, long bits);
void tp_sketch_clear(tp_sketch *sketch);

/* A copy with tan(phi) and all bounds divided: the two edges of a cone, scaled alike, are their
 * mean and plus or minus their half difference over the divisor. */
bool tp_sketch_copy(tp_sketch *copy, const tp_sketch *sketch);
void tp_sketch_divide_strength(tp_sketch *sketch, const tp_sketch *given, long edges,
                               double divisor);

/* A wrench in the sketch's units. */
void tp_sketch_wrench(double wrench[3], const tp_sketch *sketch, const tp_vector *of);

/* A twist about the point of the sketch's moments, lengths by its unit; and back. */
void tp_sketch_twist(tp_vector *own, const tp_sketch *sketch, const tp_vector *twist);
void tp_sketch_untwist(tp_vector *twist, const tp_sketch *sketch, const tp_vector *own);

/* Maximise t subject to sum f c + t direction = target. */
tp_simplex_answer tp_sketch_solve(tp_sketch *sketch, const double direction[3],
                                  const double target[3]);

#endif
