/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The null space of a matrix of whole numbers of which most are zero, exactly: Gauss and Jordan's
 * elimination with the shortest row first, each row freed of its common factor at every step. Where
 * rows join neighbours alone, as contacts do blocks, numbers stay far shorter than its minors. */

#ifndef TP_CONTACT_MODES_NULL_SPACE_H
#define TP_CONTACT_MODES_NULL_SPACE_H

#include "topple_basics.h"

#include <flint/fmpz_mat.h>

/* A basis as the columns of `space`, which is made: columns of `rows` x how many. `rows` is used
 * up. False when memory is exhausted. */
TP_MUST_USE bool tp_null_space(fmpz_mat_t space, fmpz_mat_t rows);

#endif
