/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A pool of POSIX threads over many blocks: workers take chunks of blocks from an atomic counter,
 * each with a separate workspace; counts and the first complaint are added up at the end. */

#include "batch/share.h"

#include "common/host.h"
#include "common/threads.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* More threads than this wait for each other. */
enum { MOST_THREADS = 1024 };

typedef struct shared {
  tp_block_work *work;
  const void *task;
  size_t count, chunk;
  atomic_size_t next; /* the first chunk that nobody took */
  atomic_bool ended;  /* a block has ended the whole */
} shared;

typedef struct worker {
  shared *all;
  tp_workspace workspace;
  tp_status status;
  tp_message message;
  pthread_t thread;
} worker;

void tp_workspace_clear(tp_workspace *workspace) {
  if (!workspace->borrowed) free(workspace->room);
  workspace->room = NULL;
  workspace->capacity = 0;
  workspace->borrowed = false;
}

bool tp_workspace_reserve(tp_workspace *workspace, size_t count) {
  if (count <= workspace->capacity) return true;
  tp_workspace_clear(workspace);
  workspace->room = count <= SIZE_MAX / sizeof(double) ? calloc(count, sizeof(double)) : NULL;
  workspace->capacity = workspace->room != NULL ? count : 0;
  return workspace->room != NULL;
}

static void complain(tp_blocks_summary *summary, size_t block, const tp_message *message) {
  if (summary->bad++ > 0) return; /* chunks come in their order, so that this was the first */
  summary->first_bad = block;
  tp_refuse(&summary->complaint, message->fault, (tp_place){0}, "block %zu: %s", block,
            message->text);
}

static tp_status do_block(worker *own, size_t block) {
  tp_blocks_summary *summary = &own->workspace.summary;
  const tp_status status = own->all->work(&own->workspace, own->all->task, block, &own->message);
  switch (status) {
  case TP_OK:
    summary->done++;
    return TP_OK;
  case TP_NO_ANSWER:
    summary->without++;
    return TP_OK;
  case TP_UNDECIDED:
    summary->undecided++;
    return TP_OK;
  case TP_BAD_INPUT:
    complain(summary, block, &own->message);
    return TP_OK;
  default:
    return status;
  }
}

static void take_chunks(worker *own) {
  shared *all = own->all;
  while (own->status == TP_OK && !atomic_load(&all->ended)) {
    const size_t chunk = atomic_fetch_add(&all->next, 1);
    if (chunk > (all->count - 1) / all->chunk) return;
    const size_t first = chunk * all->chunk, left = all->count - first;
    const size_t end = first + (left < all->chunk ? left : all->chunk);
    for (size_t k = first; k < end && own->status == TP_OK; k++) own->status = do_block(own, k);
  }
  if (own->status != TP_OK) atomic_store(&all->ended, true);
}

/* A thread that was started: what FLINT keeps for it ends with it. */
static void *run(void *argument) {
  {
    TP_GUARD_HOST;
    take_chunks(argument);
  }
  tp_cleanup();
  return NULL;
}

/* One, and others for no more than the chunks after the first. */
static size_t threads_of(size_t asked, size_t more_chunks) {
  size_t more = (asked != 0 ? asked : tp_threads_present()) - 1;
  if (more > MOST_THREADS - 1) more = MOST_THREADS - 1;
  return 1 + (more > more_chunks ? more_chunks : more);
}

/* Of one thread into that of all. */
static void add(tp_blocks_summary *sum, const tp_blocks_summary *own) {
  if (own->bad > 0 && (sum->bad == 0 || own->first_bad < sum->first_bad)) {
    sum->first_bad = own->first_bad;
    sum->complaint = own->complaint;
  }
  sum->done += own->done;
  sum->without += own->without;
  sum->undecided += own->undecided;
  sum->bad += own->bad;
  sum->climbed += own->climbed;
}

/* A thread that cannot be had leaves more to the others. */
static void share(worker *workers, size_t threads) {
  size_t started = 1;
  for (; started < threads; started++) {
    if (pthread_create(&workers[started].thread, NULL, run, workers + started) != 0) break;
  }
  take_chunks(workers);
  for (size_t k = 1; k < started; k++) pthread_join(workers[k].thread, NULL);
}

tp_status tp_share_out(tp_blocks_summary *summary, tp_block_work *work, const void *task,
                       size_t count, size_t chunk, size_t threads, tp_message *message) {
  tp_blocks_summary sum = {0};
  shared all = {.work = work, .task = task, .count = count, .chunk = chunk};
  tp_status status = TP_OK;
  if (count > 0) {
    threads = threads_of(threads, (count - 1) / chunk);
    worker *workers = calloc(threads, sizeof *workers);
    if (workers == NULL) return tp_fail_memory(message, "the threads");
    for (size_t k = 0; k < threads; k++) workers[k].all = &all;
    share(workers, threads);
    for (size_t k = 0; k < threads; k++) {
      add(&sum, &workers[k].workspace.summary);
      if (status == TP_OK && workers[k].status != TP_OK) {
        status = workers[k].status;
        if (message != NULL) *message = workers[k].message;
      }
      tp_workspace_clear(&workers[k].workspace);
    }
    free(workers);
  }
  if (status == TP_OK) *summary = sum;
  return status;
}
