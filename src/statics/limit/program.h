/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The linear program of a question: sum f c + t direction = target, t to be the largest.
 *
 * Where all loads turn with the tilt, F = F_c cos + F_s sin, and t is tan(tilt): direction F_s,
 * target -F_c. Otherwise it is the program at a tilt near the limit, t the way from there:
 * direction F', target -F. */

#ifndef TP_LIMIT_PROGRAM_H
#define TP_LIMIT_PROGRAM_H

#include "certificate/answer.h"
#include "linear_program/scaled.h"

typedef struct tp_program {
  tp_vector direction, target;
} tp_program;

void tp_program_init(tp_program *program);
void tp_program_clear(tp_program *program);
void tp_program_set_linear(tp_program *program, const tp_limit_question *question);

/* At a tilt near the limit, in degrees. */
void tp_program_set_near(tp_program *program, const tp_limit_question *question, const arb_t near);

/* The question's cones in doubles; false when memory is exhausted. */
TP_MUST_USE bool tp_program_scaled(tp_scaled *scaled, const tp_limit_question *question);

tp_simplex_answer tp_program_solve(const tp_program *program, tp_scaled *scaled);

/* At the question's bits (precise.h), still unproven. */
tp_simplex_answer tp_program_solve_precisely(const tp_program *program, tp_scaled *scaled,
                                             const tp_limit_question *question);

/* In doubles, unproven: the limit in degrees, 90 where interlocked, -90 where nothing holds. */
double tp_program_estimate(tp_scaled *scaled, const tp_limit_question *question);

#endif
