/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The public calls that ask for numbers of a scene by their keys, and put others in their place. */

#include "common/host.h"
#include "common/outside.h"
#include "number/ball.h"
#include "number/ratio.h"
#include "scene/exact.h"
#include "scene_varying/vary.h"

#include <stdlib.h>
#include <string.h>

static tp_status read_own(fmpq_t value, const tp_scene *scene, const char *text,
                          tp_message *message) {
  tp_scene_key key;
  const tp_status status = tp_scene_key_find(&key, scene, text, message);
  return status == TP_OK ? tp_scene_key_value(value, &key, scene, message) : status;
}

/* More than a double holds: what is one is told exactly. */
enum { BITS = 128 };

tp_status tp_scene_number(tp_bounded *number, const tp_scene *scene, const char *key,
                          tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, number);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, key);
  fmpq_t value;
  arb_t ball;
  fmpq_init(value);
  arb_init(ball);
  const tp_status status = read_own(value, scene, key, message);
  arb_set_fmpq(ball, value, BITS);
  if (status == TP_OK) *number = tp_ball_bounded(ball);
  arb_clear(ball);
  fmpq_clear(value);
  return status;
}

tp_status tp_scene_number_text(char **text, const tp_scene *scene, const char *key,
                               tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, key);
  fmpq_t value;
  fmpq_init(value);
  tp_status status = read_own(value, scene, key, message);
  if (status == TP_OK) {
    char *own = tp_ratio_exact_text(value);
    if (own != NULL) {
      *text = own;
    } else {
      status = tp_fail_memory(message, "a number");
    }
  }
  fmpq_clear(value);
  return status;
}

/* The keys of the call of that name, and its numbers. */
static tp_status read_all(tp_scene_key *found, fmpq *numbers, const tp_scene *scene,
                          const char *const *keys, const tp_exact *values, size_t count,
                          const char *call, tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    if (keys[k] == NULL) {
      return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "%s: key %zu must not be NULL",
                       call, k + 1);
    }
    status = tp_scene_key_find(found + k, scene, keys[k], message);
    for (size_t j = 0; j < k && status == TP_OK; j++) {
      if (!tp_scene_key_same(found + j, found + k)) continue;
      status = tp_refuse(message, TP_FAULT_KEY, (tp_place){call, 0, 0},
                         "'%s' is given twice; leave out one of them", tp_quote_all(keys[k]).text);
    }
    if (status == TP_OK) {
      status = tp_exact_read(numbers + k, values[k], tp_quote_all(keys[k]).text, call, message);
    }
  }
  return status;
}

static tp_status vary(tp_scene **varied, const tp_scene *scene, const char *const *keys,
                      const tp_exact *values, size_t count, const char *call, tp_message *message) {
  enum { MOST = 10000 }; /* of which each is compared with all others */
  if (count > MOST) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){call, 0, 0},
                     "at most %d numbers are varied at once", MOST);
  }
  tp_scene_key *found = calloc(count + 1, sizeof *found);
  fmpq *numbers = calloc(count + 1, sizeof *numbers);
  if (found == NULL || numbers == NULL) {
    free(found);
    free(numbers);
    return tp_fail_memory(message, "the scene");
  }
  for (size_t k = 0; k < count; k++) fmpq_init(numbers + k);
  tp_status status = read_all(found, numbers, scene, keys, values, count, call, message);
  if (status == TP_OK) status = tp_scene_vary(varied, scene, found, numbers, count, message);
  for (size_t k = 0; k < count; k++) fmpq_clear(numbers + k);
  free(numbers);
  free(found);
  return status;
}

tp_status tp_scene_with(tp_scene **varied, const tp_scene *scene, const char *key, tp_exact value,
                        tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, varied);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, key);
  return vary(varied, scene, &key, &value, 1, __func__, message);
}

tp_status tp_scene_with_numbers(tp_scene **varied, const tp_scene *scene, const char *const *keys,
                                const tp_exact *values, size_t count, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, varied);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, keys);
  TP_REFUSE_NULL(message, values);
  return vary(varied, scene, keys, values, count, __func__, message);
}
