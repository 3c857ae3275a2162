/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Fractions of polynomials, which were Calcium's, from FLINT 3 on top of FLINT 2 and Arb: Debian
 * has no more sources of Calcium of its own. The types are those of Calcium 0.4.1. */

#ifndef TP_WASM_FMPZ_MPOLY_Q_H
#define TP_WASM_FMPZ_MPOLY_Q_H

#include <acb.h>
#include <flint/fmpq.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_vec.h>

typedef struct {
  fmpz_mpoly_struct num;
  fmpz_mpoly_struct den;
} fmpz_mpoly_q_struct;

typedef fmpz_mpoly_q_struct fmpz_mpoly_q_t[1];

#include <calcium/flint_3_fmpz_mpoly_q.h>

#endif
