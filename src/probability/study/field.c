/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of fields with name, unit and kind, among them two for each tilt and one for each measure
 * of the base; values are taken from a row by the same index. */

#include "study/field.h"

#include "number/shortest.h"
#include "scene/unit.h"
#include "study/roughness.h"

#include <string.h>

/* Those of every study, after the sample and its numbers; then two at each tilt, and what is
 * measured of the base; then the last. */
typedef enum own_field {
  OUTCOME,
  FOS,
  FOS_MECHANISM,
  FOS_DEFINITION,
  FOS_MOMENTS,
  FOS_SLIDING,
  FIRST,
  MOMENTS,
  PIVOT_X,
  PIVOT_Y,
  ONSET,
  LIMIT,
  LIMIT_MECHANISM,
  BEFORE_TILTS,
  STATUS = BEFORE_TILTS,
  WHY,
  OWN_FIELDS,
  SAMPLE,
  VARIABLE,
  TILT_OUTCOME,
  TILT_FOS,
  MEASURE
} own_field;

typedef struct own_column {
  const char *name, *unit; /* the name ends in the unit */
  tp_study_field_kind kind;
} own_column;

static const own_column own_columns[] = {
    [OUTCOME] = {"outcome", NULL, TP_FIELD_WORDS},
    [FOS] = {"fos", NULL, TP_FIELD_NUMBER},
    [FOS_MECHANISM] = {"fos_mechanism", NULL, TP_FIELD_WORDS},
    [FOS_DEFINITION] = {"fos_definition", NULL, TP_FIELD_WORDS},
    [FOS_MOMENTS] = {"fos_moments", NULL, TP_FIELD_NUMBER},
    [FOS_SLIDING] = {"fos_sliding", NULL, TP_FIELD_NUMBER},
    [FIRST] = {"first", NULL, TP_FIELD_WORDS},
    [MOMENTS] = {"moments_deg", "deg", TP_FIELD_NUMBER},
    [PIVOT_X] = {"pivot_x_m", "m", TP_FIELD_NUMBER},
    [PIVOT_Y] = {"pivot_y_m", "m", TP_FIELD_NUMBER},
    [ONSET] = {"onset_deg", "deg", TP_FIELD_NUMBER},
    [LIMIT] = {"limit_deg", "deg", TP_FIELD_NUMBER},
    [LIMIT_MECHANISM] = {"limit_mechanism", NULL, TP_FIELD_WORDS},
    [STATUS] = {"status", NULL, TP_FIELD_WORDS},
    [WHY] = {"why", NULL, TP_FIELD_TEXT},
    [SAMPLE] = {"sample", NULL, TP_FIELD_WHOLE},
    [VARIABLE] = {NULL, NULL, TP_FIELD_NUMBER},
    [TILT_OUTCOME] = {"outcome", NULL, TP_FIELD_WORDS},
    [TILT_FOS] = {"fos", NULL, TP_FIELD_NUMBER},
    [MEASURE] = {NULL, NULL, TP_FIELD_NUMBER},
};

/* Which field it is, and of which variable or tilt. */
static own_field find(size_t *of, const tp_study *study, size_t field) {
  *of = 0;
  if (field == 0) return SAMPLE;
  size_t left = field - 1;
  if (left < study->variable_count) {
    *of = left;
    return VARIABLE;
  }
  left -= study->variable_count;
  if (left < BEFORE_TILTS) return (own_field)left;
  left -= BEFORE_TILTS;
  if (left < 2 * study->tilt_count) {
    *of = left / 2;
    return left % 2 == 0 ? TILT_OUTCOME : TILT_FOS;
  }
  left -= 2 * study->tilt_count;
  if (left < study->measure_count) {
    *of = left;
    return MEASURE;
  }
  return left == study->measure_count ? STATUS : WHY;
}

size_t tp_study_field_count(const tp_study *study) {
  return 1 + study->variable_count + OWN_FIELDS + 2 * study->tilt_count + study->measure_count;
}

size_t tp_study_field_of_variable(size_t variable) {
  return 1 + variable;
}

size_t tp_study_field_of_measure(const tp_study *study, size_t measure) {
  return 1 + study->variable_count + BEFORE_TILTS + 2 * study->tilt_count + measure;
}

tp_study_field_kind tp_study_field_kind_of(const tp_study *study, size_t field) {
  size_t of = 0;
  return own_columns[find(&of, study, field)].kind;
}

static void add_variable(tp_text *text, const tp_study *study, const char *key) {
  const char *unit = tp_scene_unit(study->scene, key);
  tp_text_append(text, key, strlen(key));
  if (unit != NULL) tp_text_add(text, "_%s", unit);
}

void tp_study_field_name(tp_text *text, const tp_study *study, size_t field) {
  char tilt[TP_SHORTEST_SIZE];
  size_t of = 0;
  const own_field own = find(&of, study, field);
  if (own == VARIABLE) {
    add_variable(text, study, study->variables[of].node->key);
    return;
  }
  if (own == MEASURE) {
    tp_text_add(text, "%s", tp_study_measure_name(study->measures[of]));
    if (tp_study_measure_is_length(study->measures[of])) {
      tp_text_add(text, "_%s", study->scene->length_unit);
    }
    return;
  }
  tp_text_add(text, "%s", own_columns[own].name);
  if (own == TILT_OUTCOME || own == TILT_FOS) {
    tp_text_add(text, "_at_%s_deg", tp_shortest(tilt, study->tilts[of]));
  }
}

const char *tp_study_field_unit(const tp_study *study, size_t field) {
  size_t of = 0;
  const own_field own = find(&of, study, field);
  if (own == MEASURE) return tp_study_measure_unit(study, of);
  return own == VARIABLE ? tp_key_unit(study->scene, study->variables[of].node->key)
                         : own_columns[own].unit;
}

static const char *status_of(const tp_study_row *row) {
  const bool invalid = row->at[0].outcome == TP_STUDY_INVALID;
  return invalid ? tp_study_outcome_name(TP_STUDY_INVALID) : row->open ? "open" : "certain";
}

static const char *definition_of(const tp_study_row *row) {
  return row->fos_definition < 0 ? ""
                                 : tp_fos_definition_name((tp_fos_definition)row->fos_definition);
}

static tp_study_value number(double own) {
  return (tp_study_value){.number = own};
}

static tp_study_value words(const char *own) {
  return (tp_study_value){.words = own};
}

tp_study_value tp_study_field_value(const tp_study *study, const tp_study_row *row, size_t field) {
  size_t of = 0;
  switch (find(&of, study, field)) {
  case SAMPLE:
    return (tp_study_value){.whole = row->sample};
  case VARIABLE:
    return number(row->values[of]);
  case OUTCOME:
    return words(tp_study_outcome_name(row->at[0].outcome));
  case FOS:
    return number(row->quantities[TP_STUDY_FOS]);
  case FOS_MECHANISM:
    return words(row->fos_mechanism);
  case FOS_DEFINITION:
    return words(definition_of(row));
  case FOS_MOMENTS:
    return number(row->fos_moments);
  case FOS_SLIDING:
    return number(row->fos_sliding);
  case FIRST:
    return words(row->first);
  case MOMENTS:
    return number(row->quantities[TP_STUDY_MOMENTS_DEG]);
  case PIVOT_X:
    return number(row->pivot_x_m);
  case PIVOT_Y:
    return number(row->pivot_y_m);
  case ONSET:
    return number(row->quantities[TP_STUDY_ONSET_DEG]);
  case LIMIT:
    return number(row->quantities[TP_STUDY_LIMIT_DEG]);
  case LIMIT_MECHANISM:
    return words(row->limit_mechanism);
  case TILT_OUTCOME:
    return words(tp_study_outcome_name(row->at[of + 1].outcome));
  case TILT_FOS:
    return number(row->at[of + 1].fos);
  case MEASURE:
    return number(row->measures[of]);
  case STATUS:
    return words(status_of(row));
  default:
    return words(row->at[0].outcome == TP_STUDY_INVALID ? row->why : NULL);
  }
}
