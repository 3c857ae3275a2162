/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study by the ranks of mpirun: rank k runs shard k + 1 with its rows in a file beside those that
 * are wanted, or in a temporary folder where none are, and the first rank merges them. So the bytes
 * are those of one process, and what was interrupted goes on. Whoever fails or is interrupted tells
 * the others, which stop after their chunk; then all know how each ended. */

#include "cli/study_run.h"

#include "cli/signals.h"

#include "cli/cli.h"

#include <errno.h>
#include <limits.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* How a step ended on a rank. */
typedef struct outcome {
  tp_status status;
  bool interrupted;
} outcome;

/* What the first rank decides: the first part of the names of the shards' files; or none, as rows
 * are there that one process began, and one goes on with them. */
typedef struct plan {
  bool alone, temporary;
  char folder[PATH_MAX]; /* that is temporary */
  char prefix[PATH_MAX + 32];
} plan;

typedef struct ranked {
  tp_ranks *ranks;
  const tp_study *study;
  const tp_study_options *options;
  const tp_study_file *rows;
  plan plan;
  atomic_bool stopped;
  bool failed, interrupted; /* this rank or another */
} ranked;

/* ---- together ----------------------------------------------------------------------------------
 */

/* All wait for all. The first rank that failed has its status, and complains. */
static tp_status agree(ranked *r, tp_status status, tp_message *message) {
  outcome *all = calloc((size_t)r->ranks->count, sizeof *all);
  if (all == NULL) {
    tp_cli_complain("out of memory");
    _exit(TP_EXIT_SYSTEM); /* mpirun ends the others, that wait */
  }
  const outcome own = {.status = status, .interrupted = tp_cli_signal() != 0};
  r->ranks->calls->gather(r->ranks, all, &own, sizeof own);
  int failed = 0;
  while (failed < r->ranks->count && all[failed].status == TP_OK) failed++;
  for (int k = 0; k < r->ranks->count; k++) r->interrupted = r->interrupted || all[k].interrupted;
  free(all);
  r->failed = failed < r->ranks->count;
  if (failed == r->ranks->rank) return status;
  message->text[0] = '\0';
  return TP_OK;
}

static bool is_fine(const ranked *r, tp_status status) {
  return status == TP_OK && !r->failed;
}

/* ---- the plan ----------------------------------------------------------------------------------
 */

static bool name_part(char *path, size_t size, const plan *own, int rank, const char *suffix) {
  const int length = snprintf(path, size, "%s.part%d%s", own->prefix, rank + 1, suffix);
  return length > 0 && (size_t)length < size;
}

static bool always(void *context) {
  (void)context;
  return true;
}

/* Are the wanted rows a file that can be begun or gone on with? A run that stops before its first
 * sample tells, and how many rows are there. */
static tp_status look_at_rows(ranked *r, tp_message *message) {
  tp_study_result *found = NULL;
  tp_study_options own = *r->options;
  char path[2 * PATH_MAX];
  own.stop = always;
  const tp_status status = tp_study_run(&found, r->study, &own, message);
  if (status != TP_OK) return status;
  /* with parts beside it, it was being merged */
  const bool parted =
      name_part(path, sizeof path, &r->plan, 0, ".progress") && access(path, F_OK) == 0;
  r->plan.alone = found->samples > 0 && !parted;
  tp_study_result_free(found);
  return TP_OK;
}

static tp_status make_folder(plan *own, tp_message *message) {
  const char *where = getenv("TMPDIR");
  if (where == NULL || where[0] == '\0') where = "/tmp";
  const int length = snprintf(own->folder, sizeof own->folder, "%s/topple-XXXXXX", where);
  if (length > 0 && (size_t)length < sizeof own->folder && mkdtemp(own->folder) != NULL) {
    own->temporary = true;
    snprintf(own->prefix, sizeof own->prefix, "%s/rows", own->folder);
    return TP_OK;
  }
  snprintf(message->text, sizeof message->text,
           "the ranks need a temporary folder, which cannot be made: %s; set TMPDIR",
           strerror(errno));
  return TP_SYSTEM_FAILED;
}

static tp_status make_plan(ranked *r, tp_message *message) {
  const char *rows = r->options->rows;
  struct stat state;
  /* a pipe or a device is written to once */
  if (rows == NULL || (stat(rows, &state) == 0 && !S_ISREG(state.st_mode))) {
    return make_folder(&r->plan, message);
  }
  if (strlen(rows) < PATH_MAX) {
    snprintf(r->plan.prefix, sizeof r->plan.prefix, "%s", rows);
    return look_at_rows(r, message);
  }
  snprintf(message->text, sizeof message->text, "the name of the rows is too long");
  return TP_BAD_INPUT;
}

/* Every rank has that of the first. */
static tp_status share_plan(ranked *r, tp_message *message) {
  tp_status status = r->ranks->rank == 0 ? make_plan(r, message) : TP_OK;
  status = agree(r, status, message);
  if (!is_fine(r, status)) return status;
  plan *all = calloc((size_t)r->ranks->count, sizeof *all);
  if (all == NULL) {
    tp_cli_complain("out of memory");
    _exit(TP_EXIT_SYSTEM);
  }
  r->ranks->calls->gather(r->ranks, all, &r->plan, sizeof r->plan);
  r->plan = all[0];
  free(all);
  return TP_OK;
}

/* The parts that are merged, or were not wanted but for that. */
static void remove_parts(const ranked *r) {
  char path[2 * PATH_MAX];
  for (int k = 0; k < r->ranks->count; k++) {
    if (name_part(path, sizeof path, &r->plan, k, "")) (void)unlink(path);
    if (name_part(path, sizeof path, &r->plan, k, ".progress")) (void)unlink(path);
  }
  if (r->plan.temporary) (void)rmdir(r->plan.folder);
}

/* ---- samples -----------------------------------------------------------------------------------
 */

/* Asked in any thread. */
static bool is_stopped(void *context) {
  const ranked *r = context;
  return tp_cli_signal() != 0 || atomic_load(&r->stopped);
}

/* Asked by the thread that calls MPI. */
static void listen(void *context, size_t done, size_t of) {
  ranked *r = context;
  (void)done, (void)of;
  if (r->ranks->calls->hears_stop(r->ranks)) atomic_store(&r->stopped, true);
}

static tp_status run_part(tp_study_result **result, ranked *r, tp_message *message) {
  tp_study_options own = *r->options;
  char path[2 * PATH_MAX];
  if (!name_part(path, sizeof path, &r->plan, r->ranks->rank, "")) return TP_SYSTEM_FAILED;
  own.shard = (size_t)r->ranks->rank + 1;
  own.shards = (size_t)r->ranks->count;
  own.rows = path;
  own.context = r;
  own.stop = is_stopped;
  own.progress = listen;
  const tp_status status = tp_study_run(result, r->study, &own, message);
  if (status != TP_OK || tp_cli_signal() != 0) r->ranks->calls->tell_stop(r->ranks);
  return status;
}

static tp_status run_alone(tp_study_result **result, const ranked *r, tp_message *message) {
  if (r->ranks->rank > 0) return TP_OK;
  return tp_cli_study_run(result, r->study, r->options, message);
}

/* ---- one of all --------------------------------------------------------------------------------
 */

static void free_names(char **names, int count) {
  for (int k = 0; k < count && names != NULL; k++) free(names[k]);
  free(names);
}

/* Over what was merged before, if that was cut off. */
static tp_status merge(tp_study_result **result, ranked *r, tp_message *message) {
  const int count = r->ranks->count;
  char **names = calloc((size_t)count, sizeof *names);
  bool named = names != NULL;
  for (int k = 0; k < count && named; k++) {
    names[k] = malloc(2 * PATH_MAX);
    named = names[k] != NULL && name_part(names[k], 2 * PATH_MAX, &r->plan, k, "");
  }
  tp_study_options own = *r->options;
  own.restart = own.rows != NULL;
  own.context = r;
  own.stop = is_stopped;
  tp_study_result_free(*result);
  *result = NULL;
  const tp_status status = named ? tp_study_merge(result, r->study, (const char *const *)names,
                                                  (size_t)count, &own, message)
                                 : TP_OUT_OF_MEMORY;
  free_names(names, count);
  return status;
}

/* Interrupted, the first rank tells what it knows by itself: the samples of its part. */
static tp_status run_parts(tp_study_result **result, ranked *r, tp_message *message) {
  const bool first = r->ranks->rank == 0;
  tp_status status = agree(r, run_part(result, r, message), message);
  const bool whole = is_fine(r, status) && !r->interrupted;
  if (first && whole) status = merge(result, r, message);
  if (first && (r->plan.temporary || (whole && status == TP_OK))) remove_parts(r);
  return status;
}

static tp_status run(tp_study_result **result, ranked *r, tp_message *message) {
  tp_status status = share_plan(r, message);
  if (!is_fine(r, status)) return status;
  tp_cli_catch_signals();
  status = r->plan.alone ? run_alone(result, r, message) : run_parts(result, r, message);
  if (r->ranks->rank == 0 && is_fine(r, status)) {
    status = tp_cli_study_file_write(r->rows, r->study, *result, message);
  }
  return r->failed ? status : agree(r, status, message);
}

tp_status tp_cli_study_by_ranks(tp_study_result **result, tp_ranks *ranks, const char *path,
                                const tp_study_options *options, const tp_study_file *rows,
                                tp_message *message) {
  tp_study *study = NULL;
  ranked r = {.ranks = ranks, .options = options, .rows = rows};
  tp_status status = tp_study_read(&study, path, message);
  if (status == TP_OK && ranks->rank == 0) {
    status = tp_cli_study_file_check(rows, study, options->restart, message);
  }
  status = agree(&r, status, message);
  r.study = study;
  if (is_fine(&r, status)) status = run(result, &r, message);
  tp_study_free(study);
  if (ranks->rank == 0 && is_fine(&r, status)) return TP_OK;
  tp_study_result_free(*result);
  *result = NULL;
  return status;
}
