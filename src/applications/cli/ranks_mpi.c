/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ranks by MPI, the library that the program loads under mpirun or srun. The sums are those of MPI,
 * of whole numbers, so that their order does not matter. */

#include "cli/ranks.h"

#include <limits.h>
#include <mpi.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { BYTES = 1 };

/* MPI's own waiting takes a whole processor, which another rank's threads may need: sleeps begin
 * short, as the others are mostly soon there, and end at a millisecond. */
static void sleep_a_while(long *nanoseconds) {
  const struct timespec moment = {.tv_nsec = *nanoseconds};
  nanosleep(&moment, NULL);
  if (*nanoseconds < 1000000) *nanoseconds *= 2;
}

static bool wait_for(MPI_Request *requests, int count) {
  long nanoseconds = 20000;
  int done = 0;
  bool fine = MPI_Testall(count, requests, &done, MPI_STATUSES_IGNORE) == MPI_SUCCESS;
  while (fine && !done) {
    sleep_a_while(&nanoseconds);
    fine = MPI_Testall(count, requests, &done, MPI_STATUSES_IGNORE) == MPI_SUCCESS;
  }
  return fine;
}

/* What MPI leaves as it is on the first rank, before which there is none. */
static bool sum(void *context, uint64_t *before, uint64_t *all, const uint64_t *own, size_t count) {
  MPI_Request requests[2] = {MPI_REQUEST_NULL, MPI_REQUEST_NULL};
  (void)context;
  if (count > INT_MAX) return false;
  if (before != NULL) memset(before, 0, count * sizeof *before);
  const bool begun = MPI_Iallreduce(own, all, (int)count, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD,
                                    requests) == MPI_SUCCESS &&
                     (before == NULL || MPI_Iexscan(own, before, (int)count, MPI_UINT64_T, MPI_SUM,
                                                    MPI_COMM_WORLD, requests + 1) == MPI_SUCCESS);
  return begun && wait_for(requests, 2);
}

static bool send(void *context, const void *bytes, size_t size) {
  MPI_Request request = MPI_REQUEST_NULL;
  (void)context;
  return size <= INT_MAX &&
         MPI_Isend(bytes, (int)size, MPI_BYTE, 0, BYTES, MPI_COMM_WORLD, &request) == MPI_SUCCESS &&
         wait_for(&request, 1);
}

static bool receive(void *context, size_t rank, void **bytes, size_t *size) {
  long nanoseconds = 20000;
  int there = 0, length = 0;
  MPI_Message found;
  MPI_Status state;
  MPI_Request request = MPI_REQUEST_NULL;
  (void)context;
  *bytes = NULL;
  bool fine = MPI_Improbe((int)rank, BYTES, MPI_COMM_WORLD, &there, &found, &state) == MPI_SUCCESS;
  while (fine && !there) {
    sleep_a_while(&nanoseconds);
    fine = MPI_Improbe((int)rank, BYTES, MPI_COMM_WORLD, &there, &found, &state) == MPI_SUCCESS;
  }
  if (!fine || MPI_Get_count(&state, MPI_BYTE, &length) != MPI_SUCCESS) return false;
  *size = (size_t)length;
  if (length > 0) *bytes = malloc(*size);
  if (length > 0 && *bytes == NULL) return false;
  return MPI_Imrecv(*bytes, length, MPI_BYTE, &found, &request) == MPI_SUCCESS &&
         wait_for(&request, 1);
}

static bool begin(tp_study_ranks *ranks) {
  int provided = 0, rank = 0, count = 0;
  /* threads work, but one alone calls MPI */
  if (MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS) return false;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  *ranks = (tp_study_ranks){
      .rank = (size_t)rank, .count = (size_t)count, .sum = sum, .send = send, .receive = receive};
  return provided >= MPI_THREAD_FUNNELED;
}

static void end(void) {
  MPI_Finalize();
}

extern const tp_ranks_calls tp_ranks_calls_of_mpi;
const tp_ranks_calls tp_ranks_calls_of_mpi = {begin, end};
