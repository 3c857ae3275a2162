/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ranks of `mpirun -n COUNT topple …`: as many processes of the same command, each with its
 * number, that tell one another how they end. MPI is loaded where there are several, so neither the
 * program nor the library depends on it. */

#ifndef TP_CLI_RANKS_H
#define TP_CLI_RANKS_H

#include <stdbool.h>
#include <stddef.h>

#include "topple.h"

/* `told`: this one told all others to stop; `heard`: so many told it. */
typedef struct tp_ranks {
  int rank, count;
  int told, heard;
  const struct tp_ranks_calls *calls;
} tp_ranks;

/* What the library of ranks has, by the name of TP_RANKS_CALLS. All are called by one thread. */
typedef struct tp_ranks_calls {
  bool (*begin)(tp_ranks *ranks);
  /* `all`: of each rank its `own`, of `size` bytes. Waits for all without using the processor. */
  void (*gather)(const tp_ranks *ranks, void *all, const void *own, size_t size);
  void (*tell_stop)(tp_ranks *ranks);
  bool (*hears_stop)(tp_ranks *ranks);
  void (*end)(tp_ranks *ranks);
} tp_ranks_calls;
#define TP_RANKS_CALLS "tp_ranks_calls_of_mpi"

/* One rank and no calls where mpirun did not start this. On failure `rank` is as mpirun says. */
TP_MUST_USE tp_status tp_cli_ranks_begin(tp_ranks *ranks, tp_message *message);
/* Nothing where there is one rank. */
void tp_cli_ranks_end(tp_ranks *ranks);

#endif
