/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ranks of `mpirun -n COUNT topple …`, or of `srun`: as many processes of the same command,
 * each with its number, that run one study (topple_study.h). MPI is loaded where there are several,
 * so neither the program nor the library depends on it. */

#ifndef TP_CLI_RANKS_H
#define TP_CLI_RANKS_H

#include "topple.h"

/* `own` are the calls of the library of ranks, once it is loaded. */
typedef struct tp_ranks {
  tp_study_ranks own;
  void (*end)(void);
} tp_ranks;

/* What the library of ranks has, by the name of TP_RANKS_CALLS: `begin` tells rank and count, and
 * leaves the calls; false where MPI cannot be begun. */
typedef struct tp_ranks_calls {
  bool (*begin)(tp_study_ranks *ranks);
  void (*end)(void);
} tp_ranks_calls;
#define TP_RANKS_CALLS "tp_ranks_calls_of_mpi"

/* One rank and no calls where nothing started this as one of several. On failure `own.rank` is as
 * far as the environment tells. */
TP_MUST_USE tp_status tp_cli_ranks_begin(tp_ranks *ranks, tp_message *message);
/* Waits for all. Nothing where there is one rank. */
void tp_cli_ranks_end(tp_ranks *ranks);

#endif
