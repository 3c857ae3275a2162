/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many ranks there are is read from the environment that a launcher gives its processes: Open
 * MPI by its own names, the MPICH family by those of PMI, srun of Slurm by those of a step (a batch
 * script has no step, and is one process), PMIx by the rank alone. So without a launcher no MPI is
 * loaded. */

#include "cli/ranks.h"

#include "cli/library.h"

#include <stdio.h>
#include <stdlib.h>

/* Names of the number of ranks, and of the rank. */
static const char *const launchers[][2] = {
    {"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
    {"PMI_SIZE", "PMI_RANK"},
    {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"},
    {NULL, "PMIX_RANK"},
};

/* -1 where there is no such number. */
static long read_number(const char *name) {
  const char *text = name != NULL ? getenv(name) : NULL;
  char *end = NULL;
  const long number = text != NULL ? strtol(text, &end, 10) : -1;
  return text != NULL && end != text && number >= 0 && number <= 100000000 ? number : -1;
}

/* The first launcher that tells; `*count` 0 where it tells the rank alone, 1 where there is none.
 */
static void find_launcher(size_t *rank, size_t *count) {
  *rank = 0;
  *count = 1;
  for (size_t k = 0; k < sizeof launchers / sizeof launchers[0]; k++) {
    const long size = read_number(launchers[k][0]), own = read_number(launchers[k][1]);
    if (own < 0 || (launchers[k][0] != NULL && size < 1)) continue;
    *rank = (size_t)own;
    *count = size > 0 ? (size_t)size : 0;
    return;
  }
}

static const tp_ranks_calls *load(size_t count, tp_message *message) {
  tp_cli_why why;
  const tp_ranks_calls *calls = tp_cli_load_call(TP_RANKS_LIBRARY, TP_RANKS_CALLS, &why);
  if (calls != NULL) return calls;
  char processes[32] = "several";
  if (count > 0) snprintf(processes, sizeof processes, "%zu", count);
  snprintf(message->text, sizeof message->text,
           "this is one of %s processes of mpirun, and their ranks are known by " TP_RANKS_LIBRARY
           ", which does not load (%s); './run --with mpi' in Topple's folder installs MPI and "
           "builds it, or share the "
           "study out by --shard",
           processes, why.text);
  return NULL;
}

tp_status tp_cli_ranks_begin(tp_ranks *ranks, tp_message *message) {
  size_t rank = 0, count = 1;
  find_launcher(&rank, &count);
  *ranks = (tp_ranks){.own = {.count = 1}};
  if (count == 1) return TP_OK;
  ranks->own.rank = rank;
  const tp_ranks_calls *calls = load(count, message);
  if (calls == NULL) return TP_DEPENDENCY_FAILED;
  ranks->end = calls->end;
  if (calls->begin(&ranks->own) && (count == 0 || ranks->own.count == count)) return TP_OK;
  snprintf(message->text, sizeof message->text,
           "mpirun or srun began %zu processes, but the MPI that Topple was built with knows of "
           "%zu; use the mpirun of that MPI ('srun --mpi=pmix'), or share the study out by --shard",
           count, ranks->own.count);
  ranks->own.rank = rank;
  ranks->end = NULL;
  return TP_DEPENDENCY_FAILED;
}

void tp_cli_ranks_end(tp_ranks *ranks) {
  if (ranks->end != NULL) ranks->end();
}
