/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A row read back, as it was written: only the last field can be in quotes. */

#include "study/field.h"
#include "study/outcome.h"
#include "study/row_csv.h"
#include "study/system_sample.h"
#include "terms/names.h"

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

/* Nothing, or whether a factor is met. */
static bool read_design(int *design, const char **at) {
  *design = -1;
  for (int k = 0; k <= TP_DESIGN_OPEN && **at != ','; k++) {
    const char *name = tp_design_name((tp_design)k);
    const size_t length = strlen(name);
    if (strncmp(*at, name, length) == 0 && (*at)[length] == ',') *design = k;
  }
  return (**at == ',' || *design >= 0) && skip(at);
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

/* Of a sample that makes no scene it is the outcome. */
static bool read_status(tp_study_row *row, const char **at) {
  const bool invalid = row->at[0].outcome == TP_STUDY_INVALID;
  const size_t length = strcspn(*at, ",");
  row->open = length == 4 && strncmp(*at, "open", length) == 0;
  const bool certain = length == 7 && strncmp(*at, "certain", length) == 0;
  const bool told = length == 7 && strncmp(*at, "invalid", length) == 0;
  return (invalid ? told : row->open || certain) && skip(at);
}

static bool read_field(const tp_study_place *own, tp_study_row *row, const char **at) {
  if (own->whole != NULL) return read_sample(own->whole, at);
  if (own->number != NULL) return read_number(own->number, at);
  if (own->words != NULL) return read_words(own->words, at);
  if (own->outcome != NULL) return read_outcome(own->outcome, at);
  if (own->definition != NULL) return read_definition(own->definition, at);
  if (own->design != NULL) return read_design(own->design, at);
  return read_status(row, at);
}

/* What has no field in it is none. */
static void begin(tp_study_row *row) {
  row->why = NULL;
  row->told_by = TP_TOLD_UNKNOWN;
  row->tilt_deg = row->fos_moments = row->fos_sliding = row->pivot_x_m = row->pivot_y_m = NAN;
  for (size_t k = 0; k < TP_STUDY_QUANTITIES; k++) row->quantities[k] = NAN;
  row->first = row->limit_mechanism = row->fos_mechanism = "";
  row->fos_definition = row->design = -1;
}

/* All but the last field, which tells why a row is invalid. */
static bool read_fields(tp_study_row *row, const tp_study *study, const char **at) {
  const size_t count = tp_study_field_count(study);
  bool read = true;
  for (size_t k = 0; k + 1 < count && read; k++) {
    const tp_study_place own = tp_study_field_place(study, row, k);
    read = read_field(&own, row, at);
  }
  return read;
}

bool tp_study_read_row(tp_study_row *row, bool *no_memory, const tp_study *study,
                       const char *line) {
  const char *at = line;
  *no_memory = false;
  begin(row);
  if (!read_fields(row, study, &at)) return false;
  row->at[0].fos = row->quantities[TP_STUDY_FOS];
  if (row->at[0].outcome != TP_STUDY_INVALID) return *at == '\0';
  row->why = read_text(at);
  *no_memory = row->why == NULL;
  return row->why != NULL;
}
