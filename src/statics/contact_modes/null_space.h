/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The null space of a matrix of whole numbers of which most are zero, exactly: by elimination
 * (number/integer_rows.h) with the shortest row first. */

#ifndef TP_CONTACT_MODES_NULL_SPACE_H
#define TP_CONTACT_MODES_NULL_SPACE_H

#include "topple_basics.h"

#include <flint/fmpz_mat.h>

/* A basis as the columns of `space`, which is made: columns of `rows` x how many. `rows` is used
 * up. False when memory is exhausted. */
TP_MUST_USE bool tp_null_space(fmpz_mat_t space, fmpz_mat_t rows);

#endif
