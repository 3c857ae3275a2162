/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The design value of one number: with it, and all other numbers as they stand in the scene file, a
 * quantity Q (an angle, or the factor of safety) is what samples have with the probability wanted,
 *
 *     P(Q <= Q(x)) = p,     Q(x) = Q of the scene with x in the place of the number.
 *
 * So one solve with x stands at a tilt exactly where at most the share p of all samples does not:
 * where Q is the friction angle itself, as of a slab that slides, x is its quantile. The study's
 * own samples are counted, the same at every x, so that P leaps but does not scatter; its interval
 * (Wilson) gives that of x (statistics/design_value.h). A sample without the quantity counts as if
 * it had it at no tilt. */

#include "statistics/design_value.h"
#include "statistics/proportion.h"
#include "statistics/quantiles.h"
#include "study/analyses.h"
#include "study/sample.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The value is looked for to this share of the range. */
static const double share_of_range = 1e-9;

typedef struct search {
  const tp_study *study;
  const tp_study_options *options;
  const tp_wanted_design *wanted;
  const double *sorted; /* the quantity of all samples that have it, rising */
  size_t count, kept;   /* kept: also of those without */
  size_t calls;
  bool stopped;
} search;

/* Q(x); NaN is none. */
static tp_status solve(double *quantity, search *s, double x, tp_message *message) {
  if (s->options->stop != NULL && s->options->stop(s->options->context)) {
    s->stopped = true;
    return tp_fail(message, TP_UNDECIDED, (tp_place){0}, "the study was stopped");
  }
  tp_study_at at;
  tp_study_row row = {.values = &x, .at = &at};
  const tp_variable *variable = s->study->variables + s->wanted->variable;
  tp_status status = tp_study_solve_with(&row, s->study, &variable->key, x, message);
  s->calls++;
  *quantity = row.quantities[s->wanted->quantity];
  if (status == TP_OK && isnan(*quantity)) {
    status = tp_fail(message, TP_NO_ANSWER, (tp_place){0}, "at %g the scene has no such number%s%s",
                     x, row.why != NULL ? ": " : "", row.why != NULL ? row.why : "");
  }
  free(row.why);
  return status;
}

/* How many of the samples have no more. */
static size_t count_up_to(const search *s, double quantity) {
  size_t low = 0, high = s->count;
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (s->sorted[middle] <= quantity) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low + (s->kept - s->count);
}

static tp_status probability_at(tp_estimate *probability, void *context, double x,
                                tp_message *message) {
  search *s = context;
  double quantity = NAN;
  const tp_status status = solve(&quantity, s, x, message);
  if (status == TP_OK) *probability = tp_proportion(count_up_to(s, quantity), s->kept, 0.95);
  return status;
}

/* Into the design, with what the scene then has, and which end of the interval is the safe one. */
static tp_status find(tp_study_design *design, search *s, double from, double to,
                      tp_message *message) {
  const tp_design_search own = {probability_at, s,  s->wanted->probability,
                                from,           to, share_of_range * (to - from)};
  tp_estimate found = {NAN, NAN, NAN};
  double least = NAN, most = NAN;
  tp_status status = tp_design_value(&found, &own, message);
  if (status == TP_OK) status = solve(&design->quantity_value, s, found.value, message);
  if (status == TP_OK) status = solve(&least, s, from, message);
  if (status == TP_OK) status = solve(&most, s, to, message);
  if (status != TP_OK) return status;
  design->value = found.value;
  design->low = found.low;
  design->high = found.high;
  design->low_is_safe = most > least;
  design->known = true;
  return TP_OK;
}

/* What has no answer tells why; a study that is stopped has none at all. */
static tp_status design_one(tp_study_design *design, search *s, const tp_study_variable *variable,
                            tp_message *message) {
  const tp_wanted_design *w = s->wanted;
  const double from = w->ranged ? w->from : variable->least;
  const double to = w->ranged ? w->to : variable->greatest;
  tp_message why = {.text = ""};
  *design = (tp_study_design){w->variable, w->probability, w->quantity, .scene_value = NAN};
  fmpq_t scene_value;
  fmpq_init(scene_value);
  tp_status status = tp_scene_key_value(scene_value, &s->study->variables[w->variable].key,
                                        s->study->scene, message);
  if (status == TP_OK) design->scene_value = tp_study_double(scene_value);
  fmpq_clear(scene_value);
  if (status != TP_OK) return status;
  status = from < to ? find(design, s, from, to, &why)
                     : tp_fail(&why, TP_NO_ANSWER, (tp_place){0},
                               "all samples have the same number; say where to look, by 'from' and "
                               "'to'");
  design->scenes = s->calls;
  if (status == TP_OK || s->stopped) return TP_OK;
  if (status != TP_NO_ANSWER && status != TP_UNDECIDED) {
    if (message != NULL) *message = why;
    return status;
  }
  design->why = strdup(why.text);
  return design->why != NULL ? TP_OK : tp_fail_memory(message, "a design value");
}

static size_t sort(double *sorted, const double *column, size_t kept) {
  size_t count = 0;
  for (size_t k = 0; k < kept; k++) {
    if (!isnan(column[k])) sorted[count++] = column[k];
  }
  tp_column_sort(sorted, count);
  return count;
}

static void forget(tp_study_result *result) {
  for (size_t k = 0; k < result->design_value_count; k++) free(result->design_values[k].why);
  free(result->design_values);
  result->design_values = NULL;
  result->design_value_count = 0;
}

tp_status tp_study_design_values(tp_study_result *result, const tp_study *study,
                                 const tp_study_options *options, bool *stopped,
                                 tp_message *message) {
  *stopped = false;
  if (study->design_count == 0 || result->kept == 0) return TP_OK;
  double *sorted = calloc(result->kept, sizeof *sorted);
  result->design_values = calloc(study->design_count, sizeof *result->design_values);
  tp_status status = sorted != NULL && result->design_values != NULL
                         ? TP_OK
                         : tp_fail_memory(message, "the design values");
  for (size_t k = 0; k < study->design_count && status == TP_OK && !*stopped; k++) {
    const tp_wanted_design *wanted = study->designs + k;
    const double *column = result->columns[study->variable_count + (size_t)wanted->quantity].values;
    search s = {.study = study,
                .options = options,
                .wanted = wanted,
                .sorted = sorted,
                .count = sort(sorted, column, result->kept),
                .kept = result->kept};
    result->design_value_count = k + 1;
    status =
        design_one(result->design_values + k, &s, result->variables + wanted->variable, message);
    *stopped = s.stopped;
  }
  if (*stopped) forget(result);
  free(sorted);
  return status;
}
