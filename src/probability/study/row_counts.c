/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of whole numbers over rows, and the sum of hashes of their text. */

#include "study/row_counts.h"

#include "output/sha256.h"
#include "statistics/proportion.h"

#include <math.h>
#include <string.h>

_Static_assert(sizeof(tp_row_counts) % sizeof(uint64_t) == 0, "counts are numbers alone");

size_t tp_row_counts_numbers(const tp_study *study) {
  return offsetof(tp_row_counts, outcomes) / sizeof(uint64_t) +
         (study->tilt_count + 1) * TP_STUDY_OUTCOMES;
}

void tp_row_counts_begin(tp_row_counts *own, const tp_study *study) {
  memset(own, 0, tp_row_counts_numbers(study) * sizeof(uint64_t));
}

void tp_row_counts_add(tp_row_counts *own, const tp_row_counts *other, const tp_study *study) {
  uint64_t *sum = (uint64_t *)own;
  const uint64_t *more = (const uint64_t *)other;
  const size_t count = tp_row_counts_numbers(study);
  for (size_t k = 0; k < count; k++) sum[k] += more[k];
}

/* ---- rows --------------------------------------------------------------------------------------
 */

static int octave(uint64_t sample) {
  return sample == 0 ? 0 : 64 - __builtin_clzll(sample);
}

static bool moves(tp_study_outcome outcome) {
  return outcome == TP_STUDY_SLIDES || outcome == TP_STUDY_TOPPLES ||
         outcome == TP_STUDY_SLIDES_AND_TOPPLES || outcome == TP_STUDY_LEAVES_BASE;
}

void tp_row_counts_row(tp_row_counts *own, const tp_study *study, const tp_study_row *row,
                       uint64_t first) {
  const int definition = row->fos_definition;
  const bool by_doubles = row->told_by == TP_TOLD_BY_DOUBLES;
  own->samples++;
  own->open += row->open;
  own->by_doubles += by_doubles;
  *(by_doubles ? &own->doubles_nanoseconds : &own->ladder_nanoseconds) +=
      (uint64_t)llrint(1e9 * row->seconds);
  for (size_t k = 0; k <= study->tilt_count; k++) own->outcomes[k][row->at[k].outcome]++;
  own->below_required += row->design == TP_DESIGN_NOT_MET;
  own->meets_required += row->design == TP_DESIGN_MET;
  if (definition >= 0) {
    own->definitions[definition]++;
    own->below[definition] += row->quantities[TP_STUDY_FOS] < 1;
  }
  if (moves(row->at[0].outcome)) {
    own->moved[octave(row->sample)]++;
    own->moved_of_shard[octave(row->sample - first)]++;
  }
}

void tp_row_counts_text(tp_row_counts *own, uint64_t piece, const char *text, size_t length) {
  uint8_t number[sizeof piece], hash[TP_SHA256_SIZE];
  tp_sha256_state state;
  for (size_t k = 0; k < sizeof number; k++) number[k] = (uint8_t)(piece >> 8 * k);
  tp_sha256_begin(&state);
  tp_sha256_add(&state, number, sizeof number);
  tp_sha256_add(&state, text, length);
  tp_sha256_tell(hash, &state);
  own->bytes += length;
  for (size_t k = 0; k < TP_SHA256_SIZE; k++) {
    own->hash[k / 8] += (uint64_t)hash[k] << 8 * (k % 8);
  }
}

bool tp_row_counts_same_text(const tp_row_counts *own, const tp_row_counts *other) {
  return own->bytes == other->bytes && memcmp(own->hash, other->hash, sizeof own->hash) == 0;
}

/* ---- shares ------------------------------------------------------------------------------------
 */

tp_study_share tp_row_counts_share(uint64_t count, uint64_t samples) {
  const tp_estimate own = tp_proportion(count, samples, 0.95);
  return (tp_study_share){count, own.value, own.low, own.high};
}

uint64_t tp_row_counts_stands(const tp_row_counts *own, size_t tilt) {
  return own->outcomes[tilt][TP_STUDY_STANDS] + own->outcomes[tilt][TP_STUDY_INTERLOCKED];
}

uint64_t tp_row_counts_moves(const tp_row_counts *own, size_t tilt) {
  uint64_t count = 0;
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    if (moves((tp_study_outcome)k)) count += own->outcomes[tilt][k];
  }
  return count;
}

uint64_t tp_row_counts_open(const tp_row_counts *own, size_t tilt) {
  return own->samples - own->outcomes[tilt][TP_STUDY_INVALID] - tp_row_counts_stands(own, tilt) -
         tp_row_counts_moves(own, tilt);
}

uint64_t tp_row_counts_open_required(const tp_row_counts *own) {
  return own->samples - own->outcomes[0][TP_STUDY_INVALID] - own->below_required -
         own->meets_required;
}

static bool is_narrow(const tp_row_counts *own, const tp_study *study, uint64_t count) {
  const tp_study_share share = tp_row_counts_share(count, own->samples);
  return share.high - share.low <= 2 * study->half_width;
}

bool tp_row_counts_is_certain(const tp_row_counts *own, const tp_study *study) {
  if (!(study->half_width > 0) || own->samples == 0) return false;
  for (size_t k = 0; k <= study->tilt_count; k++) {
    for (int j = 0; j < TP_STUDY_OUTCOMES; j++) {
      if (!is_narrow(own, study, own->outcomes[k][j])) return false;
    }
    if (!is_narrow(own, study, tp_row_counts_stands(own, k)) ||
        !is_narrow(own, study, tp_row_counts_moves(own, k))) {
      return false;
    }
  }
  return true;
}
