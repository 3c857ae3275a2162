/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads KEY=FIRST:LAST:STEP or a list as exact expressions, counts the values, and writes each as a
 * setting. */

#include "sweep/axis.h"

#include "common/outside.h"
#include "number/ratio.h"
#include "scene/setting.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static tp_status fail(const char *text, tp_message *message, const char *why) {
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){text, 0, 0}, "%s", why);
}

/* The formula of so many bytes. */
static tp_status evaluate(fmpq_t value, const tp_scene *scene, const char *text,
                          const char *formula, size_t length, tp_message *message) {
  char *own = strndup(formula, length);
  if (own == NULL) return tp_fail_memory(message, "the sweep");
  const tp_place place = {text, 0, 0};
  tp_status status = tp_expression_evaluate(value, own, place, &scene->parameters, message);
  if (status == TP_OK) status = tp_check_range(value, "a value", place, message);
  free(own);
  return status;
}

/* count = floor((last - first) / step) + 1 */
static tp_status count_range(tp_axis *axis, const fmpq_t last, const char *text,
                             tp_message *message) {
  if (fmpq_is_zero(axis->step)) return fail(text, message, "the step must not be 0");
  fmpq_t steps;
  fmpz_t whole;
  fmpq_init(steps);
  fmpz_init(whole);
  fmpq_sub(steps, last, axis->first);
  fmpq_div(steps, steps, axis->step);
  fmpz_fdiv_q(whole, fmpq_numref(steps), fmpq_denref(steps));
  tp_status status = TP_OK;
  if (fmpz_sgn(whole) < 0) {
    status = fail(text, message, "the step leads away from the last value; change its sign");
  } else if (fmpz_cmp_si(whole, TP_SWEEP_MOST) >= 0) {
    status = fail(text, message, "there are more than 100 million values; take a larger step");
  } else {
    axis->count = (size_t)fmpz_get_si(whole) + 1;
  }
  fmpz_clear(whole);
  fmpq_clear(steps);
  return status;
}

static tp_status read_range(tp_axis *axis, const tp_scene *scene, const char *text,
                            const char *values, tp_message *message) {
  const size_t first = strcspn(values, ":");
  const char *rest = values + first + 1;
  const size_t middle = strcspn(rest, ":");
  if (rest[middle] == '\0' || strchr(rest + middle + 1, ':') != NULL) {
    return fail(text, message, "a range is written FIRST:LAST:STEP, as 20:40:0.5");
  }
  fmpq_t last;
  fmpq_init(last);
  const char *step = rest + middle + 1;
  tp_status status = evaluate(axis->first, scene, text, values, first, message);
  if (status == TP_OK) status = evaluate(last, scene, text, rest, middle, message);
  if (status == TP_OK) status = evaluate(axis->step, scene, text, step, strlen(step), message);
  if (status == TP_OK) status = count_range(axis, last, text, message);
  fmpq_clear(last);
  return status;
}

static tp_status read_list(tp_axis *axis, const tp_scene *scene, const char *text,
                           const char *values, tp_message *message) {
  size_t count = 1;
  for (const char *c = values; *c != '\0'; c++) count += *c == ',';
  axis->list = calloc(count, sizeof *axis->list);
  if (axis->list == NULL) return tp_fail_memory(message, "the sweep");
  tp_status status = TP_OK;
  while (axis->count < count && status == TP_OK) {
    const size_t length = strcspn(values, ",");
    fmpq_init(axis->list + axis->count);
    status = evaluate(axis->list + axis->count++, scene, text, values, length, message);
    values += length + 1;
  }
  return status;
}

tp_status tp_axis_read(tp_axis *axis, const tp_scene *scene, const char *text,
                       tp_message *message) {
  *axis = (tp_axis){.count = 0};
  fmpq_init(axis->first);
  fmpq_init(axis->step);
  const size_t length = tp_setting_key_length(text);
  if (length == 0 || text[length] == '\0' || text[length + 1] == '\0') {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "'%s' sweeps nothing; write KEY=FIRST:LAST:STEP, as "
                     "friction_angle_deg=20:40:0.5, or KEY=VALUE,VALUE",
                     tp_quote_all(text).text);
  }
  axis->name = strndup(text, length);
  if (axis->name == NULL) return tp_fail_memory(message, "the sweep");
  const tp_status status = tp_scene_key_find(&axis->key, scene, axis->name, message);
  if (status != TP_OK) return status;
  const char *values = text + length + 1;
  return strchr(values, ':') != NULL ? read_range(axis, scene, text, values, message)
                                     : read_list(axis, scene, text, values, message);
}

void tp_axis_clear(tp_axis *axis) {
  for (size_t k = 0; axis->list != NULL && k < axis->count; k++) fmpq_clear(axis->list + k);
  free(axis->list);
  free(axis->name);
  fmpq_clear(axis->first);
  fmpq_clear(axis->step);
}

char *tp_axis_setting(const tp_axis *axis, size_t value) {
  fmpq_t number;
  fmpq_init(number);
  if (axis->list != NULL) {
    fmpq_set(number, axis->list + value);
  } else {
    fmpq_mul_ui(number, axis->step, value);
    fmpq_add(number, number, axis->first);
  }
  char *digits = tp_ratio_exact_text(number);
  fmpq_clear(number);
  const size_t size = strlen(axis->name) + (digits != NULL ? strlen(digits) : 0) + 2;
  char *setting = digits != NULL ? malloc(size) : NULL;
  if (setting != NULL) snprintf(setting, size, "%s=%s", axis->name, digits);
  free(digits);
  return setting;
}
