/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of fields with name, unit and kind, among them two for each tilt and one for each measure
 * of the base; values are taken from a row by the same index. */

#include "study/field.h"

#include "number/shortest.h"
#include "scene/unit.h"
#include "study/outcome.h"
#include "study/roughness.h"
#include "terms/names.h"

#include <string.h>

typedef enum own_field {
  OUTCOME,
  FOS,
  FOS_MECHANISM,
  FOS_DEFINITION,
  FOS_MOMENTS,
  FOS_SLIDING,
  FOS_GOODMAN_BRAY,
  FIRST,
  MOMENTS,
  PIVOT_X,
  PIVOT_Y,
  ONSET,
  LIMIT,
  LIMIT_MECHANISM,
  ACCELERATION,
  SUPPORT,
  COLLAPSE,
  DESIGN,
  STATUS,
  WHY,
  SAMPLE,
  VARIABLE,
  TILT_OUTCOME,
  TILT_FOS,
  MEASURE
} own_field;

/* After the sample and its numbers those of a block, or of many; then two at each tilt, and what is
 * measured of the base; then status, and why. */
static const own_field of_block[] = {
    OUTCOME, FOS,     FOS_MECHANISM, FOS_DEFINITION, FOS_MOMENTS, FOS_SLIDING,    FIRST,
    MOMENTS, PIVOT_X, PIVOT_Y,       ONSET,          LIMIT,       LIMIT_MECHANISM};
static const own_field of_many[] = {OUTCOME, FOS,          FOS_DEFINITION, FOS_GOODMAN_BRAY,
                                    LIMIT,   ACCELERATION, COLLAPSE,       DESIGN};
static const own_field of_solid[] = {OUTCOME,         FOS,          FOS_MECHANISM,
                                     FOS_MOMENTS,     FOS_SLIDING,  LIMIT,
                                     LIMIT_MECHANISM, ACCELERATION, DESIGN};
static const own_field of_supported[] = {
    OUTCOME, FOS, FOS_DEFINITION, FOS_GOODMAN_BRAY, LIMIT, ACCELERATION, COLLAPSE, SUPPORT, DESIGN};
enum { LAST_FIELDS = 2 };

typedef struct own_fields {
  const own_field *items;
  size_t count;
} own_fields;

/* A support stands where the scene asks for one, and whether a factor is met where one is required.
 */
static own_fields fields_of(const tp_study *study) {
  const size_t required = study->scene->required_fos.given ? 0 : 1;
  if (tp_study_is_of_solid(study)) {
    return (own_fields){of_solid, sizeof of_solid / sizeof of_solid[0] - required};
  }
  if (!tp_study_is_of_many(study)) {
    return (own_fields){of_block, sizeof of_block / sizeof of_block[0]};
  }
  return tp_study_has_quantity(study, TP_STUDY_SUPPORT_N_M)
             ? (own_fields){of_supported, sizeof of_supported / sizeof of_supported[0] - required}
             : (own_fields){of_many, sizeof of_many / sizeof of_many[0] - required};
}

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
    [FOS_GOODMAN_BRAY] = {"fos_goodman_bray", NULL, TP_FIELD_NUMBER},
    [FIRST] = {"first", NULL, TP_FIELD_WORDS},
    [MOMENTS] = {"moments_deg", "deg", TP_FIELD_NUMBER},
    [PIVOT_X] = {"pivot_x_m", "m", TP_FIELD_NUMBER},
    [PIVOT_Y] = {"pivot_y_m", "m", TP_FIELD_NUMBER},
    [ONSET] = {"onset_deg", "deg", TP_FIELD_NUMBER},
    [LIMIT] = {"limit_deg", "deg", TP_FIELD_NUMBER},
    [LIMIT_MECHANISM] = {"limit_mechanism", NULL, TP_FIELD_WORDS},
    [ACCELERATION] = {"critical_acceleration_g", "g", TP_FIELD_NUMBER},
    [SUPPORT] = {"support_n_m", "N/m", TP_FIELD_NUMBER},
    [COLLAPSE] = {"collapse", NULL, TP_FIELD_WORDS},
    [DESIGN] = {"meets_required", NULL, TP_FIELD_WORDS},
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
  const own_fields own = fields_of(study);
  if (left < own.count) return own.items[left];
  left -= own.count;
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
  return 1 + study->variable_count + fields_of(study).count + 2 * study->tilt_count +
         study->measure_count + LAST_FIELDS;
}

size_t tp_study_field_of_variable(size_t variable) {
  return 1 + variable;
}

size_t tp_study_field_of_measure(const tp_study *study, size_t measure) {
  return 1 + study->variable_count + fields_of(study).count + 2 * study->tilt_count + measure;
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

static double *quantity_at(tp_study_row *row, tp_study_quantity quantity) {
  return row->quantities + quantity;
}

tp_study_place tp_study_field_place(const tp_study *study, tp_study_row *row, size_t field) {
  size_t of = 0;
  switch (find(&of, study, field)) {
  case SAMPLE:
    return (tp_study_place){.whole = &row->sample};
  case VARIABLE:
    return (tp_study_place){.number = row->values + of};
  case OUTCOME:
    return (tp_study_place){.outcome = &row->at[0].outcome};
  case FOS:
    return (tp_study_place){.number = quantity_at(row, TP_STUDY_FOS)};
  case FOS_MECHANISM:
    return (tp_study_place){.words = &row->fos_mechanism};
  case FOS_DEFINITION:
    return (tp_study_place){.definition = &row->fos_definition};
  case FOS_MOMENTS:
    return (tp_study_place){.number = &row->fos_moments};
  case FOS_SLIDING:
    return (tp_study_place){.number = &row->fos_sliding};
  case FOS_GOODMAN_BRAY:
    return (tp_study_place){.number = quantity_at(row, TP_STUDY_FOS_GOODMAN_BRAY)};
  case FIRST:
    return (tp_study_place){.words = &row->first};
  case MOMENTS:
    return (tp_study_place){.number = quantity_at(row, TP_STUDY_MOMENTS_DEG)};
  case PIVOT_X:
    return (tp_study_place){.number = &row->pivot_x_m};
  case PIVOT_Y:
    return (tp_study_place){.number = &row->pivot_y_m};
  case ONSET:
    return (tp_study_place){.number = quantity_at(row, TP_STUDY_ONSET_DEG)};
  case LIMIT:
    return (tp_study_place){.number = quantity_at(row, TP_STUDY_LIMIT_DEG)};
  case LIMIT_MECHANISM:
  case COLLAPSE:
    return (tp_study_place){.words = &row->limit_mechanism};
  case ACCELERATION:
    return (tp_study_place){.number = quantity_at(row, TP_STUDY_ACCELERATION_G)};
  case SUPPORT:
    return (tp_study_place){.number = quantity_at(row, TP_STUDY_SUPPORT_N_M)};
  case DESIGN:
    return (tp_study_place){.design = &row->design};
  case TILT_OUTCOME:
    return (tp_study_place){.outcome = &row->at[of + 1].outcome};
  case TILT_FOS:
    return (tp_study_place){.number = &row->at[of + 1].fos};
  case MEASURE:
    return (tp_study_place){.number = row->measures + of};
  case STATUS:
    return (tp_study_place){.is_status = true};
  default:
    return (tp_study_place){0};
  }
}

static tp_study_value words(const char *own) {
  return (tp_study_value){.words = own};
}

tp_study_value tp_study_field_value(const tp_study *study, const tp_study_row *row, size_t field) {
  const tp_study_place at = tp_study_field_place(study, (tp_study_row *)row, field);
  if (at.whole != NULL) return (tp_study_value){.whole = *at.whole};
  if (at.number != NULL) return (tp_study_value){.number = *at.number};
  if (at.words != NULL) return words(*at.words);
  if (at.outcome != NULL) return words(tp_study_outcome_name(*at.outcome));
  if (at.definition != NULL) {
    return words(*at.definition < 0 ? ""
                                    : tp_fos_definition_name((tp_fos_definition)*at.definition));
  }
  if (at.design != NULL) {
    return words(*at.design < 0 ? "" : tp_design_name((tp_design)*at.design));
  }
  if (at.is_status) return words(status_of(row));
  return words(row->at[0].outcome == TP_STUDY_INVALID ? row->why : NULL);
}
