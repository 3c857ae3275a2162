/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The program of forces in rationals. Outlines and weights are what the scene gives, to the last
 * digit; the strength of every joint is the least, or the greatest, of what it is enclosed by. The
 * more strength, the more forces there are: what the least one holds is held, and what the greatest
 * one does not hold is not. */

#ifndef TP_ASSEMBLAGE_EXACT_PROGRAM_H
#define TP_ASSEMBLAGE_EXACT_PROGRAM_H

#include "assemblage/force_program.h"

typedef struct tp_exact_program {
  const tp_force_program *forces; /* borrowed: the same rows and columns in doubles */
  const tp_contact_strength *strengths;
  bool greatest;
  fmpq *columns;       /* an entry a row, in lattice steps: forces have no unit of their own */
  fmpq *bounds;        /* by column */
  const fmpq **most;   /* its bound, or NULL */
  fmpq *live, *target; /* by row: w1 and -w0 */
  long *exponents;     /* by column: a factor of 1 here is 2^exponent there */
} tp_exact_program;

/* False in `made` where loads are not known exactly. `forces` is of these strengths and loads. On
 * failure, and where not made, cleared. */
TP_MUST_USE tp_status tp_exact_program_init(bool *made, tp_exact_program *program,
                                            const tp_force_program *forces,
                                            const tp_contact_strength *strengths,
                                            const tp_weight_loads *loads, bool greatest,
                                            tp_message *message);
void tp_exact_program_clear(tp_exact_program *program);

#endif
