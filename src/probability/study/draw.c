/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The numbers of samples: listed ones by the cell, drawn ones by walks through the draws of each
 * cell. Any sample is the same wherever a chunk begins. */

#include "generate/random.h"
#include "study/study.h"

#include <stdlib.h>

/* The first list varies slowest, the columns fastest. */
double tp_variable_listed(const tp_study *study, size_t variable, uint64_t cell) {
  if (study->rows > 0) {
    if (study->variables[variable].source == TP_VARIABLE_COLUMN) {
      return study->variables[variable].values[cell % study->rows];
    }
    cell /= study->rows;
  }
  for (size_t k = study->variable_count; k-- > variable + 1;) {
    if (study->variables[k].source == TP_VARIABLE_LISTED) cell /= study->variables[k].count;
  }
  const tp_variable *own = study->variables + variable;
  return own->values[cell % own->count];
}

double tp_variable_drawn(const tp_variable *variable, const double *scores) {
  return tp_distribution_at_score(&variable->distribution, scores[variable->dimension]);
}

static void put_sample(double *values, const tp_study *study, uint64_t cell, const double *scores) {
  for (size_t k = 0; k < study->variable_count; k++) {
    const tp_variable *variable = study->variables + k;
    values[k] = variable->source == TP_VARIABLE_DRAWN ? tp_variable_drawn(variable, scores)
                                                      : tp_variable_listed(study, k, cell);
  }
}

/* Those of a range that lie in the cell of its `offset`-th sample. */
static tp_status draw_cell(double *values, const tp_study *study, uint64_t first, size_t count,
                           size_t offset, double *scores, tp_message *message) {
  const uint64_t cell = (first + offset) % study->cells;
  const tp_draws draws = {
      .method = study->method,
      .seed = study->cells == 1 ? study->seed : tp_random_bits(tp_random_mix(study->seed), cell),
      .samples = study->samples / study->cells,
      .dimensions = study->drawn,
      .correlation = study->correlation,
  };
  tp_draws_walk *walk = NULL;
  const tp_status status =
      tp_draws_begin(&walk, &draws, (first + offset) / study->cells, study->drawn_names, message);
  if (status != TP_OK) return status;
  for (uint64_t k = offset; k < count; k += study->cells) {
    tp_draws_next_scores(walk, scores);
    put_sample(values + k * study->variable_count, study, cell, scores);
  }
  tp_draws_end(walk);
  return TP_OK;
}

tp_status tp_study_draw(double *values, const tp_study *study, uint64_t first, size_t count,
                        tp_message *message) {
  double *scores = calloc(study->drawn + 1, sizeof *scores);
  if (scores == NULL) return tp_fail_memory(message, "the samples");
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && k < study->cells && status == TP_OK; k++) {
    if (study->drawn > 0) {
      status = draw_cell(values, study, first, count, k, scores, message);
    } else {
      put_sample(values + k * study->variable_count, study, first + k, scores);
    }
  }
  free(scores);
  return status;
}

uint64_t tp_study_chunks(const tp_study *study) {
  return (study->samples - 1) / study->chunk + 1;
}

size_t tp_study_chunk_size(const tp_study *study, uint64_t chunk) {
  const uint64_t left = study->samples - chunk * study->chunk;
  return left < study->chunk ? (size_t)left : study->chunk;
}

uint64_t tp_shard_chunk(const tp_study *study, size_t shard, size_t shards) {
  return tp_study_chunks(study) * (shard - 1) / shards;
}

uint64_t tp_chunk_sample(const tp_study *study, uint64_t chunk) {
  const uint64_t sample = chunk * study->chunk;
  return sample < study->samples ? sample : study->samples;
}
