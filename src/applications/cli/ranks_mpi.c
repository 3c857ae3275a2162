/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ranks by MPI, the library that the program loads under mpirun. To stop is told by an empty
 * message to each other rank, which looks for one between two chunks of its work. */

#include "cli/ranks.h"

#include <limits.h>
#include <mpi.h>
#include <stdlib.h>
#include <time.h>

enum { STOP = 1 };

static bool begin(tp_ranks *ranks) {
  int provided = 0;
  /* threads work, but one alone calls MPI */
  if (MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS) return false;
  MPI_Comm_rank(MPI_COMM_WORLD, &ranks->rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks->count);
  return provided >= MPI_THREAD_FUNNELED;
}

/* MPI's own waiting takes a whole processor, which another rank's threads may need. */
static void sleep_until(MPI_Request *request) {
  const struct timespec moment = {.tv_nsec = 1000000};
  int done = 0;
  MPI_Test(request, &done, MPI_STATUS_IGNORE);
  while (!done) {
    nanosleep(&moment, NULL);
    MPI_Test(request, &done, MPI_STATUS_IGNORE);
  }
}

static void gather(const tp_ranks *ranks, void *all, const void *own, size_t size) {
  MPI_Request request;
  (void)ranks;
  MPI_Iallgather(own, (int)size, MPI_BYTE, all, (int)size, MPI_BYTE, MPI_COMM_WORLD, &request);
  sleep_until(&request);
  MPI_Wait(&request, MPI_STATUS_IGNORE); /* which is over */
}

/* By messages that are kept until they are taken, so that nobody is waited for. Without memory
 * the others are not told, and end when they are done. */
static void tell_stop(tp_ranks *ranks) {
  if (ranks->told > 0 || ranks->count > INT_MAX / MPI_BSEND_OVERHEAD) return;
  const int size = ranks->count * MPI_BSEND_OVERHEAD;
  void *kept = malloc((size_t)size);
  if (kept == NULL) return;
  MPI_Buffer_attach(kept, size);
  ranks->told = 1;
  for (int k = 0; k < ranks->count; k++) {
    if (k != ranks->rank) MPI_Bsend(NULL, 0, MPI_BYTE, k, STOP, MPI_COMM_WORLD);
  }
}

static void hear(tp_ranks *ranks) {
  MPI_Recv(NULL, 0, MPI_BYTE, MPI_ANY_SOURCE, STOP, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  ranks->heard++;
}

static bool hears_stop(tp_ranks *ranks) {
  int there = 0;
  if (ranks->heard > 0) return true;
  MPI_Iprobe(MPI_ANY_SOURCE, STOP, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
  if (there) hear(ranks);
  return there != 0;
}

/* No message may be left. */
static void end(tp_ranks *ranks) {
  int told = 0, size = 0;
  void *kept = NULL;
  MPI_Allreduce(&ranks->told, &told, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  while (ranks->heard < told - ranks->told) hear(ranks);
  if (ranks->told > 0) MPI_Buffer_detach((void *)&kept, &size);
  free(kept);
  MPI_Finalize();
}

extern const tp_ranks_calls tp_ranks_calls_of_mpi;
const tp_ranks_calls tp_ranks_calls_of_mpi = {begin, gather, tell_stop, hears_stop, end};
