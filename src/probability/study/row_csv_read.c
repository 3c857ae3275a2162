/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A row read back, as it was written: only the last field can be in quotes. */

#include "study/row_csv.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Past the field that begins at `*at`; false: there is none. */
static bool skip(const char **at) {
  const char *comma = strchr(*at, ',');
  if (comma == NULL) return false;
  *at = comma + 1;
  return true;
}

static bool read_number(double *value, const char **at) {
  if (**at == ',') {
    *value = NAN;
  } else {
    char *end = NULL;
    *value = strtod(*at, &end);
    if (end == *at || *end != ',') return false;
  }
  return skip(at);
}

static const char holds_nowhere[] = "holds nowhere";

/* What becomes of a block, in words; or nothing. */
static bool read_words(const char **words, const char **at) {
  const size_t length = strcspn(*at, ",");
  *words = length == strlen(holds_nowhere) ? holds_nowhere : "";
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    const char *name = tp_study_outcome_name((tp_study_outcome)k);
    if (strlen(name) == length && strncmp(*at, name, length) == 0) *words = name;
  }
  return strncmp(*at, *words, length) == 0 && strlen(*words) == length && skip(at);
}

/* Nothing, or the name of a definition. */
static bool read_definition(int *definition, const char **at) {
  *definition = -1;
  for (int k = 0; k < TP_FOS_DEFINITIONS && **at != ','; k++) {
    const char *name = tp_fos_definition_name((tp_fos_definition)k);
    const size_t length = strlen(name);
    if (strncmp(*at, name, length) == 0 && (*at)[length] == ',') *definition = k;
  }
  return (**at == ',' || *definition >= 0) && skip(at);
}

static bool read_outcome(tp_study_outcome *outcome, const char **at) {
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    const char *name = tp_study_outcome_name((tp_study_outcome)k);
    const size_t length = strlen(name);
    if (strncmp(*at, name, length) != 0 || (*at)[length] != ',') continue;
    *outcome = (tp_study_outcome)k;
    return skip(at);
  }
  return false;
}

/* As tp_encode_csv has written it: without quotes, and the apostrophe before what a spreadsheet
 * takes for a formula. */
static char *read_text(const char *at) {
  char *text = malloc(strlen(at) + 1);
  if (text == NULL) return NULL;
  size_t length = 0;
  const bool quoted = *at == '"';
  if (quoted) at++;
  if (*at == '\'' && at[1] != '\0' && strchr("=+-@", at[1]) != NULL) at++;
  for (; *at != '\0'; at++) {
    if (quoted && *at == '"') at++;
    if (*at == '\0') break;
    text[length++] = *at;
  }
  text[length] = '\0';
  return text;
}

static bool read_sample(uint64_t *sample, const char **at) {
  char *end = NULL;
  errno = 0;
  *sample = strtoull(*at, &end, 10);
  return end != *at && *end == ',' && errno == 0 && skip(at);
}

static bool read_tilts(tp_study_row *row, const tp_study *study, const char **at) {
  bool read = true;
  for (size_t k = 1; k <= study->tilt_count && read; k++) {
    read = read_outcome(&row->at[k].outcome, at) && read_number(&row->at[k].fos, at);
  }
  return read;
}

/* Of a sample that makes no scene it is the outcome. */
static bool read_status(tp_study_row *row, const char **at) {
  const bool invalid = row->at[0].outcome == TP_STUDY_INVALID;
  const size_t length = strcspn(*at, ",");
  row->open = length == 4 && strncmp(*at, "open", length) == 0;
  const bool certain = length == 7 && strncmp(*at, "certain", length) == 0;
  const bool told = length == 7 && strncmp(*at, "invalid", length) == 0;
  return (invalid ? told : row->open || certain) && skip(at);
}

static bool read_measures(tp_study_row *row, const tp_study *study, const char **at) {
  bool read = true;
  for (size_t k = 0; k < study->measure_count && read; k++) {
    read = read_number(row->measures + k, at);
  }
  return read;
}

bool tp_study_read_row(tp_study_row *row, bool *no_memory, const tp_study *study,
                       const char *line) {
  const char *at = line;
  double *q = row->quantities;
  *no_memory = false;
  row->why = NULL;
  row->told_by = TP_TOLD_UNKNOWN;
  row->tilt_deg = NAN;
  row->first = row->limit_mechanism = row->fos_mechanism = "";
  bool read = read_sample(&row->sample, &at);
  for (size_t k = 0; k < study->variable_count && read; k++) {
    read = read_number(row->values + k, &at);
  }
  read = read && read_outcome(&row->at[0].outcome, &at) && read_number(q + TP_STUDY_FOS, &at) &&
         read_words(&row->fos_mechanism, &at) && read_definition(&row->fos_definition, &at) &&
         read_number(&row->fos_moments, &at) && read_number(&row->fos_sliding, &at) &&
         read_words(&row->first, &at) && read_number(q + TP_STUDY_MOMENTS_DEG, &at) &&
         read_number(&row->pivot_x_m, &at) && read_number(&row->pivot_y_m, &at) &&
         read_number(q + TP_STUDY_ONSET_DEG, &at) && read_number(q + TP_STUDY_LIMIT_DEG, &at) &&
         read_words(&row->limit_mechanism, &at) && read_tilts(row, study, &at) &&
         read_measures(row, study, &at);
  if (!read) return false;
  row->at[0].fos = q[TP_STUDY_FOS];
  if (!read_status(row, &at)) return false;
  if (row->at[0].outcome != TP_STUDY_INVALID) return *at == '\0';
  row->why = read_text(at);
  *no_memory = row->why == NULL;
  return row->why != NULL;
}
