/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sets up the symbols of a subject (parameters, declared symbols, angles with sine and cosine,
 * weights), its field and its names, and chooses direction and pivot. */

#include "verify/subject_init.h"

#include "common/outside.h"
#include "formula/spelling.h"
#include "verify/quantities.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_WEIGHTS = 1000 };

/* Elements of the block, which the paper's sums weigh one by one: of teeth and slabs those of
 * Appendix A, of a plain outline its triangles. */
static long count_weights(const tp_scene *scene) {
  const tp_block_description *block = &scene->block;
  if (block->hole_count > 0 || block->part_count > 0) return 0;
  long count = block->outline.count - 2;
  if (block->form == TP_OUTLINE_TEETH) count = 2 * block->teeth.count;
  if (block->form == TP_OUTLINE_SLAB) count = 1;
  return count <= MOST_WEIGHTS ? count : 0;
}

/* printf into new memory, appended to the symbols' names, all of which are short enough. */
static bool add_symbol(tp_subject *s, const char *format, const char *name, long number) {
  char text[TP_NAME_SIZE + sizeof "sin()"];
  snprintf(text, sizeof text, format, name, number);
  s->symbol_names[s->symbol_count] = strdup(text);
  return s->symbol_names[s->symbol_count++] != NULL;
}

static bool add_angle(tp_subject *s, const char *name) {
  tp_angle *angle = s->angles + s->angle_count++;
  *angle = (tp_angle){s->symbol_count, s->symbol_count + 1, s->symbol_count + 2};
  return add_symbol(s, "%s", name, 0) && add_symbol(s, "sin(%s)", name, 0) &&
         add_symbol(s, "cos(%s)", name, 0);
}

/* Names of the symbols that are added to the scene's parameters. */
static bool name_symbols(tp_subject *s, const tp_subject_options *options) {
  const long declared = options->declared_count;
  s->symbol_names = calloc((size_t)(3 * (declared + TP_OWN_ANGLES) + s->weight_count + 3),
                           sizeof *s->symbol_names);
  s->angles = calloc((size_t)(declared + TP_OWN_ANGLES), sizeof *s->angles);
  if (s->symbol_names == NULL || s->angles == NULL) return false;
  bool done = add_angle(s, "alpha") && add_angle(s, "i");
  s->length = s->symbol_count;
  done = done && add_symbol(s, "r", "", 0);
  s->mend = s->symbol_count;
  done = done && add_symbol(s, "?", "", 0);
  s->first_weight = s->symbol_count;
  for (long k = 0; k < s->weight_count && done; k++) done = add_symbol(s, "w%s_%ld", "", k + 1);
  for (long k = 0; k < declared && done; k++) {
    const tp_declared *d = options->declared + k;
    done = d->angle ? add_angle(s, d->name) : add_symbol(s, "%s", d->name, 0);
  }
  return done;
}

static tp_status init_field(tp_subject *s, tp_message *message) {
  const tp_symbol_names names = {s->symbol_count, (const char *const *)s->symbol_names};
  if (s->scene != NULL && s->members == TP_MEMBERS_ONE) {
    const tp_status status = tp_model_init(&s->model, s->scene, true, &names, message);
    if (status != TP_OK) return status;
    s->has_model = true;
    s->field = &s->model.symbols.field;
    return TP_OK;
  }
  const tp_status status = tp_field_init(&s->own.field, s->scene, &names, message);
  if (status == TP_OK) s->field = &s->own.field;
  return status;
}

/* Indices among the added symbols become indices of the field. */
static void shift_symbols(tp_subject *s) {
  for (long k = 0; k < s->angle_count; k++) {
    tp_angle *a = s->angles + k;
    *a = (tp_angle){tp_field_added(s->field, a->degrees), tp_field_added(s->field, a->sine),
                    tp_field_added(s->field, a->cosine)};
  }
  s->length = tp_field_added(s->field, s->length);
  s->mend = tp_field_added(s->field, s->mend);
  s->first_weight = tp_field_added(s->field, s->first_weight);
}

/* Values of the symbols, where they have one. */
static bool init_values(tp_subject *s, const tp_subject_options *options) {
  const tp_field *field = s->field;
  s->values = calloc((size_t)field->symbol_count, sizeof *s->values);
  s->given = calloc((size_t)field->symbol_count, sizeof *s->given);
  if (s->values == NULL || s->given == NULL) return false;
  for (long k = 0; k < field->symbol_count; k++) fmpq_init(s->values + k);
  for (long k = 0; k < field->parameters->count; k++) {
    fmpq_set(s->values + k, field->parameters->values + k);
    s->given[k] = true;
  }
  if (s->scene != NULL && s->scene->block.form != TP_OUTLINE_VERTICES) {
    const long count = field->parameters->count;
    fmpq_set_si(s->values + count, s->scene->block.teeth.count, 1);
    s->given[count] = true;
  }
  const long alpha = s->angles[TP_ANGLE_ALPHA].degrees;
  if (s->scene != NULL && s->scene->tilt_angle_deg.given) {
    fmpq_set(s->values + alpha, s->scene->tilt_angle_deg.value);
    s->given[alpha] = true;
  }
  for (long k = s->first_weight + s->weight_count, d = 0; d < options->declared_count; d++) {
    fmpq_set(s->values + k, options->declared[d].value);
    s->given[k] = true;
    k += options->declared[d].angle ? 3 : 1;
  }
  return true;
}

/* The direction of tilt and the pivot. */
static tp_status choose_pivot(tp_subject *s, const tp_subject_options *options, tp_place place,
                              tp_message *message) {
  s->towards = options->has_direction   ? options->towards
               : s->scene->towards_left ? TP_TOWARDS_LEFT
                                        : TP_TOWARDS_RIGHT;
  if (!s->has_model) return tp_family_check(s->scene, message);
  const tp_solution *solution = s->model.solution;
  for (size_t c = 0; c < solution->case_count; c++) {
    if (solution->cases[c].towards == s->towards) s->at = solution->cases + c;
  }
  if (s->at == NULL) {
    return tp_refuse(message, TP_FAULT_KEY, place, "the scene does not tilt this way");
  }
  s->pivot = options->has_pivot ? options->pivot : s->at->toppling_pivot;
  if (options->has_pivot ? s->pivot >= s->at->pivot_count : !s->at->has_toppling_pivot) {
    return tp_refuse(message, TP_FAULT_KEY, place, "the scene has no such pivot");
  }
  return TP_OK;
}

static bool add_symbol_name(tp_subject *s, long symbol) {
  tp_name *name = tp_subject_add_name(s, s->field->names[symbol], TP_NAME_FORMULA);
  if (name != NULL) fmpz_mpoly_q_gen(name->value, symbol, s->field->ring);
  return name != NULL;
}

static bool add_angle_name(tp_subject *s, long angle) {
  tp_name *name = tp_subject_add_name(s, s->field->names[s->angles[angle].degrees], TP_NAME_ANGLE);
  if (name != NULL) name->angle = angle;
  return name != NULL;
}

/* The names of the program itself, then those of the claims file, then those of the scene; none of
 * the latter may hide one of the former. */
static tp_status add_names(tp_subject *s, const tp_subject_options *options, tp_place place,
                           tp_message *message) {
  const tp_field *field = s->field;
  const long parameters = field->parameters->count;
  bool done = true;
  for (long k = 0; k < TP_OWN_ANGLES && done; k++) done = add_angle_name(s, k);
  for (long k = 0; k < s->weight_count && done; k++) done = add_symbol_name(s, s->first_weight + k);
  done = done && add_symbol_name(s, s->length) && add_symbol_name(s, parameters) &&
         (s->scene == NULL || tp_quantities_add(s));
  const long ours = s->name_count;
  long symbol = s->first_weight + s->weight_count, angle = TP_OWN_ANGLES;
  for (long d = 0; d < options->declared_count && done; d++) {
    const bool is_angle = options->declared[d].angle;
    done = is_angle ? add_angle_name(s, angle++) : add_symbol_name(s, symbol);
    symbol += is_angle ? 3 : 1;
  }
  const long declared = s->name_count;
  for (long k = 0; k < parameters && done; k++) {
    tp_name *name = tp_subject_add_name(s, field->parameters->names[k], TP_NAME_FORMULA);
    done = name != NULL;
    if (done) fmpz_mpoly_q_set(name->value, field->values + k, field->ring);
  }
  if (!done) return tp_fail_memory(message, "the symbols");
  for (long k = ours; k < s->name_count; k++) {
    if (strlen(s->names[k].text) >= TP_NAME_SIZE) {
      return tp_refuse(message, TP_FAULT_KEY, place,
                       "rename the parameter '%s' of this geometry: a formula has names of at most "
                       "%d letters",
                       tp_quote_all(s->names[k].text).text, TP_NAME_SIZE - 1);
    }
    for (long j = 0; j < k && j < declared; j++) {
      if (strcmp(s->names[j].text, s->names[k].text) != 0) continue;
      return tp_refuse(message, TP_FAULT_KEY, place,
                       "'%s' is %s; rename the %s '%s' of this geometry",
                       tp_quote_all(s->names[k].text).text,
                       j < ours ? "a name that claims use for something else" : "declared already",
                       k < declared ? "symbol" : "parameter", tp_quote_all(s->names[k].text).text);
    }
  }
  return TP_OK;
}

tp_status tp_subject_init(tp_subject *s, const tp_subject_options *options, tp_place place,
                          tp_message *message) {
  memset(s, 0, sizeof *s);
  s->rounded = options->rounded;
  s->members = options->members;
  tp_status status = TP_OK;
  if (options->scene != NULL) status = tp_scene_read(&s->scene, options->scene, message);
  if (status == TP_OK && s->scene != NULL) s->weight_count = count_weights(s->scene);
  if (status == TP_OK && !name_symbols(s, options)) status = tp_fail_memory(message, "the symbols");
  if (status == TP_OK) status = init_field(s, message);
  if (status == TP_OK && s->scene != NULL) status = choose_pivot(s, options, place, message);
  if (status == TP_OK) {
    shift_symbols(s);
    if (!tp_subject_init_ones(s) || !init_values(s, options))
      status = tp_fail_memory(message, "the symbols");
  }
  if (status == TP_OK) status = add_names(s, options, place, message);
  if (status == TP_OK && !tp_quantities_example_values(s)) {
    status = tp_fail_memory(message, "the symbols");
  }
  s->permanent = s->name_count;
  if (status != TP_OK) tp_subject_clear(s);
  return status;
}
