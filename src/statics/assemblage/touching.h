/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which free blocks touch which. */

#ifndef TP_ASSEMBLAGE_TOUCHING_H
#define TP_ASSEMBLAGE_TOUCHING_H

#include "assemblage/force_program.h"

/* By number: neighbours[first[b]] … neighbours[first[b + 1] - 1] are those that block b touches,
 * each once, ascending. `first` has room for one more than there are blocks; `neighbours` is to be
 * freed. False when memory is exhausted. */
TP_MUST_USE bool tp_touching_find(long *first, long **neighbours, const tp_force_program *program);

#endif
