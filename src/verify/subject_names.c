/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The names that formulas about a subject may use. */

#include "verify/evaluate.h"

#include "derive/field_work.h"
#include "outside.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 10000 };

static const tp_dialect dialect = {
    .letters = true,
    .products = true,
    .functions = true,
    .lines = true,
    .most_nodes = MOST_NODES,
    .formula = "a formula",
    .operand = "a number or a name",
    .no_operand = "does not begin a number, a name or a bracket",
    .continued = "a formula",
    .unknown_name = "names are the scene's parameters, the quantities, and what 'symbols', "
                    "'angles' and 'with' define",
    .quoted = 20,
};

/* Of names that are the same the last counts. */
long tp_subject_find(const tp_subject *s, const char *name, size_t length) {
  for (long k = s->name_count - 1; k >= 0; k--) {
    const char *text = s->names[k].text;
    if (text[0] == name[0] && strncmp(text, name, length) == 0 && text[length] == '\0') return k;
  }
  return -1;
}

static long find(const void *subject, const char *name, size_t length) {
  return tp_subject_find(subject, name, length);
}

/* Is a name an angle, by its form? */
static bool is_angle(const void *subject, long index) {
  const tp_subject *s = subject;
  const tp_name *name = s->names + index;
  if (name->kind != TP_NAME_DEFINITION) return name->kind != TP_NAME_FORMULA;
  for (long k = 0; k < name->definition.count; k++) { /* 90 - i, an arctangent */
    const tp_formula_node *n = name->definition.nodes + k;
    if (n->kind == TP_FORMULA_NAME && !is_angle(s, n->name)) return false;
    if (n->kind == TP_FORMULA_CALL) return n->function == TP_FUNCTION_ATAN;
  }
  return true;
}

tp_status tp_subject_read(tp_formula *formula, const char *text, tp_place place,
                          const tp_subject *s, tp_message *message) {
  const tp_vocabulary names = {find, is_angle, s};
  return tp_formula_read(formula, text, place, &dialect, &names, message);
}

tp_name *tp_subject_add_name(tp_subject *s, const char *text, tp_name_kind kind) {
  if (s->name_count == s->name_capacity) {
    const long capacity = 2 * s->name_capacity + 64;
    tp_name *names = realloc(s->names, (size_t)capacity * sizeof *names);
    if (names == NULL) return NULL;
    s->names = names;
    s->name_capacity = capacity;
  }
  tp_name *name = s->names + s->name_count;
  *name = (tp_name){.kind = kind, .text = strdup(text), .ready = true};
  if (name->text == NULL) return NULL;
  fmpz_mpoly_q_init(name->value, s->field->ring);
  fmpz_mpoly_q_init(name->run, s->field->ring);
  s->name_count++;
  return name;
}

void tp_subject_drop_names(tp_subject *s, long keep) {
  while (s->name_count > keep) {
    tp_name *name = s->names + --s->name_count;
    tp_formula_clear(&name->definition);
    free(name->used);
    fmpz_mpoly_q_clear(name->value, s->field->ring);
    fmpz_mpoly_q_clear(name->run, s->field->ring);
    free(name->text);
  }
}

void tp_subject_forget(tp_subject *subject) {
  tp_subject_drop_names(subject, subject->permanent);
}

tp_status tp_subject_define(tp_subject *s, const char *name, const char *text, tp_place place,
                            tp_message *message) {
  char spelt[TP_NAME_SIZE];
  const size_t used = tp_name_spell(spelt, sizeof spelt, name, sizeof spelt);
  if (used == 0 || name[used] != '\0') {
    return tp_fail(message, TP_BAD_INPUT, place, "'%s' cannot be a name", tp_quote_all(name).text);
  }
  tp_formula definition;
  const tp_status status = tp_subject_read(&definition, text, place, s, message);
  if (status != TP_OK) return status;
  tp_name *added = tp_subject_add_name(s, spelt, TP_NAME_DEFINITION);
  if (added == NULL) {
    tp_formula_clear(&definition);
    return tp_fail_memory(message, "a definition");
  }
  added->definition = definition;
  added->ready = false;
  added->used = calloc((size_t)s->field->symbol_count, sizeof *added->used);
  if (added->used == NULL) return tp_fail_memory(message, "a definition");
  return tp_evaluate_used(added->used, &added->definition, s, message);
}

tp_status tp_subject_name(const tp_name **name, tp_subject *s, long index, tp_message *message) {
  tp_name *found = s->names + index;
  if (!found->ready && found->kind != TP_NAME_DEFINITION) {
    const tp_status status = found->rule(found->value, found->run, s, message);
    if (status != TP_OK) return status;
    tp_subject_reduce(found->value, s);
    tp_subject_reduce(found->run, s);
    const tp_place place = s->scene != NULL ? s->scene->block.place : (tp_place){0};
    const tp_status within = tp_field_check(s->field, place, message);
    if (within != TP_OK) return within;
    found->ready = true;
  }
  *name = found;
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
tp_status tp_subject_add_names(tp_subject *s, const tp_subject_options *options, tp_place place,
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
      return tp_fail(message, TP_BAD_INPUT, place,
                     "rename the parameter '%s' of this geometry: a formula has names of at most "
                     "%d letters",
                     tp_quote_all(s->names[k].text).text, TP_NAME_SIZE - 1);
    }
    for (long j = 0; j < k && j < declared; j++) {
      if (strcmp(s->names[j].text, s->names[k].text) != 0) continue;
      return tp_fail(message, TP_BAD_INPUT, place,
                     "'%s' is %s; rename the %s '%s' of this geometry",
                     tp_quote_all(s->names[k].text).text,
                     j < ours ? "a name that claims use for something else" : "declared already",
                     k < declared ? "symbol" : "parameter", tp_quote_all(s->names[k].text).text);
    }
  }
  return TP_OK;
}
