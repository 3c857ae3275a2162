/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The head of a study's page: its samples, the answer that a report quotes, and by what each number
 * varies. */

#include "output/encode.h"
#include "report/study_words.h"

#include <string.h>

static void add_end(tp_text *t, const tp_study_result *r) {
  switch (r->end) {
  case TP_STUDY_CERTAIN:
    tp_text_add(t, "; stopped, as every interval is within +-%.4g", r->half_width);
    break;
  case TP_STUDY_INTERRUPTED:
    tp_text_add(t, "; interrupted");
    break;
  case TP_STUDY_SHARD:
    tp_text_add(t, "; shard %zu of %zu", r->shard, r->shards);
    break;
  default:
    break;
  }
}

static void add_range(tp_text *t, double least, double greatest, const char *unit) {
  tp_text_add(t, " %.6g to %.6g", least, greatest);
  if (unit != NULL) tp_text_add(t, " %s", strcmp(unit, "deg") == 0 ? "°" : unit);
}

/* Of the base of each sample, where the study asks. */
static void add_measures(tp_text *t, const tp_study_result *r) {
  if (r->roughness_count == 0) return;
  tp_text_add(t, "\nMeasured on the base\n");
  for (size_t k = 0; k < r->roughness_count; k++) {
    const tp_study_measure *own = r->roughness + k;
    tp_text_add(t, "  %-*s %-12s", TP_STUDY_LABEL, own->name,
                k + 2 == r->roughness_count   ? "Eq. (15)"
                : k + 1 == r->roughness_count ? "Eq. (16)"
                                              : "");
    if (own->samples == 0) {
      tp_text_add(t, " -");
    } else {
      add_range(t, own->least, own->greatest, own->unit);
    }
    if (own->samples > 0 && own->samples < r->kept) {
      tp_text_add(t, ", of %zu samples", own->samples);
    }
    tp_text_add(t, "\n");
  }
  if (r->bracketed == 0) return;
  tp_text_add(t, "  Critical angles between these two: %zu of %zu\n", r->within, r->bracketed);
}

static void add_variables(tp_text *t, const tp_study_result *r) {
  tp_text_add(t, "\n%-*s samples\n", TP_STUDY_LABEL + 2, "Variables");
  for (size_t k = 0; k < r->variable_count; k++) {
    const tp_study_variable *v = r->variables + k;
    tp_text_add(t, "  ");
    tp_encode_column(t, v->key, TP_STUDY_LABEL);
    if (r->kept > 0) add_range(t, v->least, v->greatest, v->unit);
    tp_text_add(t, "\n    %s: %s\n", v->kind, v->law);
  }
  for (size_t k = 0; k < r->correlation_count; k++) {
    const tp_study_correlation *own = r->correlations + k;
    tp_text_add(t, "%s    ", k == 0 ? "  Correlated\n" : "");
    tp_encode_plain(t, r->variables[own->one].key);
    tp_text_add(t, ", ");
    tp_encode_plain(t, r->variables[own->other].key);
    tp_text_add(t, ": %.4g\n", own->value);
  }
}

/* What a report quotes, before all that it rests on. */
static void add_answer(tp_text *t, const tp_study_result *r) {
  const tp_study_tilt *own = r->tilts;
  if ((!own->has_tilt && !own->as_it_lies) || r->samples == 0) return;
  if (own->as_it_lies) {
    tp_text_add(t, "\nAs it lies, ");
  } else if (own->tilt_varies) {
    tp_text_add(t, "\nAt the scene's tilt, which varies, ");
  } else {
    tp_text_add(t, "\nAt %.6g° ", own->tilt_deg);
  }
  tp_text_add(t, "certain to move: %.2f %% (%.2f to %.2f %%), to stand: %.2f %%%s",
              100 * own->certain_to_move.share, 100 * own->certain_to_move.low,
              100 * own->certain_to_move.high, 100 * own->certain_to_stand.share,
              own->neither.samples > 0 ? "" : "\n");
  if (own->neither.samples > 0) tp_text_add(t, "; open: %.2f %%\n", 100 * own->neither.share);
  if (!r->has_required_fos) return;
  tp_text_add(t,
              "Below the factor required: %.2f %% (%.2f to %.2f %%); certain to be met: %.2f %%; "
              "open: %.2f %%\n",
              100 * r->below_required.share, 100 * r->below_required.low,
              100 * r->below_required.high, 100 * r->meets_required.share,
              100 * r->open_required.share);
}

static const char *method_words(const char *method) {
  return strcmp(method, "latin_hypercube") == 0 ? "Latin hypercube"
         : strcmp(method, "monte_carlo") == 0   ? "Monte Carlo"
         : strcmp(method, "sobol") == 0         ? "Sobol' points"
                                                : method;
}

void tp_study_add_head(tp_text *t, const tp_study_result *r) {
  if (r->title != NULL) {
    tp_encode_plain(t, r->title);
    tp_text_add(t, "\n\n");
  }
  tp_text_add(t, "Study of ");
  tp_encode_plain(t, r->scene);
  tp_text_add(t, "\n%zu of %zu samples", r->samples, r->planned);
  if (strcmp(r->method, "none") != 0)
    tp_text_add(t, ", %s, seed %zu", method_words(r->method), r->seed);
  add_end(t, r);
  tp_text_add(t, "\n");
  add_answer(t, r);
  add_variables(t, r);
  add_measures(t, r);
}
