/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The names that formulas about a subject may use, and the dialect in which they are written. */

#include "verify/subject.h"

#include "common/outside.h"
#include "derive/field_work.h"
#include "formula/read.h"
#include "formula/spelling.h"

#include <stdlib.h>
#include <string.h>

/* Of one formula, as a message says. */
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

/* Take away the names after the first `keep`. */
static void drop_names(tp_subject *s, long keep) {
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
  drop_names(subject, subject->permanent);
}

tp_status tp_subject_lacks(const tp_subject *s, tp_message *message, const char *problem) {
  return tp_fail(message, TP_NO_ANSWER, s->scene->block.place, "%s", problem);
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

/* By names alone, so that it holds for what is not rational too. */
tp_status tp_subject_used(int *used, const tp_formula *formula, tp_subject *s,
                          tp_message *message) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  int *own = calloc((size_t)s->field->symbol_count, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "a formula");
  tp_status status = TP_OK;
  for (long k = 0; k < formula->count && status == TP_OK; k++) {
    const tp_formula_node *node = formula->nodes + k;
    const tp_name *name = NULL;
    if (node->kind != TP_FORMULA_NAME) continue;
    status = tp_subject_name(&name, s, node->name, message);
    if (status != TP_OK) break;
    if (name->kind == TP_NAME_DEFINITION) {
      for (long j = 0; j < s->field->symbol_count; j++) used[j] |= name->used[j];
      continue;
    }
    if (name->kind == TP_NAME_ANGLE) used[s->angles[name->angle].degrees] = 1;
    fmpz_mpoly_q_used_vars(own, name->value, ring);
    for (long j = 0; j < s->field->symbol_count; j++) used[j] |= own[j];
    if (name->kind != TP_NAME_DIRECTION) continue;
    fmpz_mpoly_q_used_vars(own, name->run, ring);
    for (long j = 0; j < s->field->symbol_count; j++) used[j] |= own[j];
  }
  free(own);
  return status;
}

tp_status tp_subject_define(tp_subject *s, const char *name, const char *text, tp_place place,
                            tp_message *message) {
  char spelt[TP_NAME_SIZE];
  const size_t used = tp_name_spell(spelt, sizeof spelt, name, sizeof spelt);
  if (used == 0 || name[used] != '\0') {
    return tp_refuse(message, TP_FAULT_KEY, place, "'%s' cannot be a name",
                     tp_quote_all(name).text);
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
  return tp_subject_used(added->used, &added->definition, s, message);
}

void tp_subject_clear(tp_subject *s) {
  if (s->field != NULL) {
    drop_names(s, 0);
    for (long k = 0; s->ones != NULL && k < s->angle_count; k++) {
      fmpz_mpoly_clear(s->ones[k], s->field->ring);
    }
    for (long k = 0; s->values != NULL && k < s->field->symbol_count; k++) {
      fmpq_clear(s->values + k);
    }
    if (s->has_model) {
      tp_model_clear(&s->model);
    } else {
      tp_field_clear(&s->own.field);
    }
  }
  free(s->names);
  free(s->ones);
  free(s->values);
  free(s->given);
  for (long k = 0; k < s->symbol_count; k++) free(s->symbol_names[k]);
  free(s->symbol_names);
  free(s->angles);
  tp_scene_free(s->scene);
  memset(s, 0, sizeof *s);
}
