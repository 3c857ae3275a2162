/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many ranks there are is read from the environment that mpirun gives its processes, of Open
 * MPI by its own names and of the MPICH family by those of PMI: without mpirun no MPI is loaded. */

#include "cli/ranks.h"

#include "cli/library.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

/* The first of two variables that is there; 0 where there is neither, or no such number. */
static int read_number(const char *one, const char *other) {
  const char *text = getenv(one);
  if (text == NULL) text = getenv(other);
  const long number = text != NULL ? strtol(text, NULL, 10) : 0;
  return number > 0 && number <= 1000000 ? (int)number : 0;
}

static tp_status load(tp_ranks *ranks, tp_message *message) {
  void *library = tp_cli_load_library(TP_RANKS_LIBRARY);
  if (library != NULL) ranks->calls = dlsym(library, TP_RANKS_CALLS);
  if (ranks->calls != NULL) return TP_OK;
  const char *why = dlerror();
  snprintf(message->text, sizeof message->text,
           "this is one of %d processes of mpirun, and their ranks are known by " TP_RANKS_LIBRARY
           ", which does not load (%s); './run --with mpi' in Topple's folder installs MPI and "
           "builds it, or share the "
           "study out by --shard",
           ranks->count, why != NULL ? why : "no reason is given");
  return TP_DEPENDENCY_FAILED;
}

tp_status tp_cli_ranks_begin(tp_ranks *ranks, tp_message *message) {
  const int count = read_number("OMPI_COMM_WORLD_SIZE", "PMI_SIZE");
  *ranks = (tp_ranks){.count = 1};
  if (count < 2) return TP_OK;
  *ranks = (tp_ranks){.rank = read_number("OMPI_COMM_WORLD_RANK", "PMI_RANK"), .count = count};
  const tp_status status = load(ranks, message);
  if (status != TP_OK) return status;
  const int rank = ranks->rank;
  if (ranks->calls->begin(ranks) && ranks->count == count) return TP_OK;
  ranks->rank = rank;
  ranks->calls = NULL;
  snprintf(message->text, sizeof message->text,
           "mpirun began %d processes, but the MPI that Topple was built with knows of %d; use the "
           "mpirun of that MPI, or share the study out by --shard",
           count, ranks->count);
  return TP_DEPENDENCY_FAILED;
}

void tp_cli_ranks_end(tp_ranks *ranks) {
  if (ranks->calls != NULL) ranks->calls->end(ranks);
}
