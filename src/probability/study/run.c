/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study run: chunk after chunk of a fixed number of samples, in rounds (study/rounds.h). The
 * samples of a chunk are shared out to threads, each filling its own row; rows are written and
 * counted in their order. So what comes out depends neither on threads or ranks nor on where a run
 * was interrupted. */

#include "common/clock.h"
#include "common/host.h"
#include "common/options.h"
#include "study/hdf5_rows.h"
#include "study/points.h"
#include "study/result.h"
#include "study/rounds.h"

#include <stdlib.h>

TP_OPTIONS_END(tp_study_options, forecast);

void tp_study_options_init(tp_study_options *options, size_t size) {
  const tp_study_options defaults = {.size = sizeof defaults, .shard = 1, .shards = 1};
  tp_options_fill(options, size, &defaults);
}

static tp_status start(tp_rounds *r, const tp_study *study, const tp_study_options *options,
                       tp_message *message) {
  const uint64_t next = tp_shard_chunk(study, options->shard, options->shards);
  const uint64_t past = tp_shard_chunk(study, options->shard + 1, options->shards);
  *r = (tp_rounds){.study = study,
                   .options = options,
                   .rows = {.descriptor = -1},
                   .next = next,
                   .past = past,
                   .size = 1};
  tp_status status = tp_tally_init(&r->tally, study, tp_chunk_sample(study, next),
                                   tp_chunk_sample(study, past), message);
  if (status != TP_OK) return status;
  return tp_block_init(&r->block, study, options, &r->tally,
                       tp_rank_count(options->ranks) > 1 ? TP_BLOCK_CHUNKS : 1, message);
}

static void end(tp_rounds *r) {
  tp_rows_close(&r->rows);
  tp_block_clear(&r->block);
  tp_tally_clear(&r->tally);
  free(r->spans);
}

/* ---- rounds ------------------------------------------------------------------------------------
 */

static bool is_certain(const tp_rounds *r) {
  return r->options->shards == 1 && tp_row_counts_is_certain(&r->tally.counts, r->study);
}

static tp_study_end how_it_ended(const tp_rounds *r, bool stopped) {
  if (stopped) return TP_STUDY_INTERRUPTED;
  if (r->next < r->past) return TP_STUDY_CERTAIN;
  return r->options->shards > 1 ? TP_STUDY_SHARD : TP_STUDY_COMPLETE;
}

static tp_status make_rounds(tp_rounds *r, tp_study_end *ended, tp_message *message) {
  const uint64_t past = tp_chunk_sample(r->study, r->past);
  tp_status status = tp_rounds_go_on(r, message);
  bool last = false;
  r->block.began = tp_clock_now();
  r->block.planned = (past - tp_chunk_sample(r->study, r->next)) / tp_rank_count(r->options->ranks);
  while (status == TP_OK && !r->over && r->next < r->past && !last && !is_certain(r)) {
    status = tp_rounds_next(r, &last, message);
    if (status == TP_OK && !r->over && !last && r->options->progress != NULL) {
      r->options->progress(r->options->context, (size_t)r->tally.counts.samples,
                           (size_t)(past - r->tally.first));
    }
  }
  *ended = how_it_ended(r, last && !is_certain(r));
  return status;
}

/* The first rank sums up, and where it has points to solve for that the others help it; HDF5 is
 * made by all of them. */
static tp_status sum_up(tp_study_result **result, tp_rounds *r, tp_study_end ended,
                        const tp_hdf5_rows *hdf5, tp_message *message) {
  const tp_study_ranks *ranks = r->options->ranks;
  tp_status status = tp_rounds_gather(r, message);
  if (status != TP_OK || r->over) return status;
  if (tp_rank_is_first(ranks)) {
    status = tp_study_sum_up(result, &r->tally, ended, r->options, message);
    status = tp_study_end_points(r->options, status, message);
  } else {
    status = tp_study_help_with_points(r->study, r->options, message);
  }
  status = tp_together_agree(ranks, status, &r->over, message);
  if (status != TP_OK || r->over || ended == TP_STUDY_INTERRUPTED) return status;
  return tp_hdf5_rows_make(hdf5, *result, r->study, r->options, message);
}

static tp_status check(const tp_study_options *options, tp_message *message) {
  enum { MOST_SHARDS = 1000000 };
  if (options->shards < 1 || options->shards > MOST_SHARDS || options->shard < 1 ||
      options->shard > options->shards) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                     "a shard is one from 1 to the number of shards, of a million at most");
  }
  const tp_study_ranks *ranks = options->ranks;
  if (ranks == NULL || (ranks->rank < ranks->count &&
                        (ranks->count == 1 ||
                         (ranks->sum != NULL && ranks->send != NULL && ranks->receive != NULL)))) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                   "a rank is one from 0 to before the number of ranks, and has calls to reach "
                   "the others");
}

tp_status tp_study_run(tp_study_result **result, const tp_study *study,
                       const tp_study_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, result);
  TP_REFUSE_NULL(message, study);
  TP_REFUSE_NULL(message, options);
  tp_study_options taken = tp_study_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  tp_status status = check(options, message);
  if (status != TP_OK) return status;
  tp_rounds r;
  tp_hdf5_rows hdf5;
  tp_study_end ended = TP_STUDY_COMPLETE;
  bool failed = false;
  status = tp_hdf5_rows_begin(&hdf5, &taken, study, message);
  const tp_status started = start(&r, study, options, status == TP_OK ? message : NULL);
  if (status == TP_OK) status = started;
  status = tp_together_agree(options->ranks, status, &failed, message);
  r.over = failed;
  if (status == TP_OK && !r.over) status = make_rounds(&r, &ended, message);
  tp_study_result *own = NULL;
  if (status == TP_OK && !r.over) status = sum_up(&own, &r, ended, &hdf5, message);
  if (status == TP_OK) {
    *result = own; /* none on a rank that is not the first */
  } else {
    tp_study_result_free(own);
  }
  end(&r);
  tp_hdf5_rows_end(&hdf5);
  return status;
}
