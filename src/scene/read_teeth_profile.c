/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A base of teeth, and what all profiles made by rule are read by. */

#include "generate/generate.h"
#include "number/ratio.h"
#include "scene/read_generated.h"

#include <string.h>

tp_status tp_read_rule_of(const tp_reader *reader, fmpq_t value, const tp_node *map,
                          const char *key, const char *example, tp_rule rule) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, map, key, example);
  return status == TP_OK ? tp_read_by_rule(reader, value, node, key, rule) : status;
}

tp_status tp_read_within(const tp_reader *reader, fmpq_t value, const tp_node *map, const char *key,
                         const char *low, const char *high, bool strictly) {
  const tp_node *node = tp_node_get(map, key);
  if (node == NULL) return TP_OK;
  tp_status status = tp_read_number(reader, value, node, key);
  if (status != TP_OK) return status;
  const char *problem = NULL;
  bool within = true;
  fmpq_t bound;
  fmpq_init(bound);
  for (int end = 0; end < 2; end++) {
    const char *text = end == 0 ? low : high;
    (void)tp_ratio_read_field(bound, text, strlen(text), &problem);
    const int side = fmpq_cmp(value, bound) * (end == 0 ? 1 : -1);
    within = within && (strictly ? side > 0 : side >= 0);
  }
  fmpq_clear(bound);
  if (within) return TP_OK;
  char text[80];
  tp_ratio_text(text, sizeof text, value);
  return tp_read_fail(reader, node, "%s must lie %s %s and %s; it is %s", key,
                      strictly ? "strictly between" : "between", low, high, text);
}

tp_status tp_read_seed(const tp_reader *reader, uint64_t *seed, const tp_node *map, bool draws) {
  const tp_node *node = tp_node_get(map, "seed");
  if (node == NULL && !draws) return TP_OK;
  fmpq_t value;
  fmpq_init(value);
  tp_status status = tp_read_rule_of(reader, value, map, "seed", "seed: 1", TP_RULE_NOT_NEGATIVE);
  if (status == TP_OK && (!fmpz_is_one(fmpq_denref(value)) || fmpz_bits(fmpq_numref(value)) > 63)) {
    status = tp_read_fail(reader, node, "a seed is a whole number from 0 to 9223372036854775807");
  }
  if (status == TP_OK) *seed = fmpz_get_ui(fmpq_numref(value));
  fmpq_clear(value);
  return status;
}

tp_status tp_read_start(const tp_reader *reader, fmpq_t x, fmpq_t y, const tp_node *map) {
  const tp_node *node = tp_node_get(map, "start");
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_read_fail(reader, node, "'start' is a point, written [x, y]");
  }
  const tp_status status = tp_read_number(reader, x, node->first, "x");
  return status == TP_OK ? tp_read_number(reader, y, node->last, "y") : status;
}

static tp_status read_left_end(const tp_reader *reader, bool *valley, const tp_node *map) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, map, "left_end", "left_end: valley");
  if (status != TP_OK) return status;
  const char *text = node->kind == TP_NODE_SCALAR ? node->text : "";
  *valley = strcmp(text, "valley") == 0;
  if (*valley || strcmp(text, "peak") == 0) return TP_OK;
  return tp_read_fail(reader, node, "left_end must be valley or peak");
}

/* Both facets of a tooth keep a run. */
static tp_status check_skew(const tp_reader *reader, const tp_teeth_options *o,
                            const tp_node *node) {
  fmpq_t most, limit;
  fmpq_init(most);
  fmpq_init(limit);
  fmpq_abs(most, o->skew);
  fmpq_add(most, most, o->skew_scatter);
  fmpq_set_si(limit, 9, 10);
  const bool fits = fmpq_cmp(most, limit) <= 0;
  fmpq_clear(most);
  fmpq_clear(limit);
  if (fits) return TP_OK;
  return tp_read_fail(reader, node,
                      "the skew and its scatter are together at most 0.9 in size: each facet of a "
                      "tooth keeps a part of its wavelength");
}

static tp_status read_scatter(const tp_reader *reader, tp_teeth_options *o, const tp_node *node) {
  static const char *const keys[] = {"wavelength", "amplitude", "skew", NULL};
  if (node == NULL) return TP_OK;
  tp_status status =
      tp_node_expect_keys(node, keys, "scatter", reader->scene->path, reader->message);
  if (status == TP_OK) {
    status = tp_read_within(reader, o->wavelength_scatter, node, keys[0], "0", "0.9", false);
  }
  if (status == TP_OK) {
    status = tp_read_within(reader, o->amplitude_scatter, node, keys[1], "0", "1", false);
  }
  if (status == TP_OK) {
    status = tp_read_within(reader, o->skew_scatter, node, keys[2], "0", "0.9", false);
  }
  return status;
}

static tp_status read_options(const tp_reader *reader, tp_teeth_options *o, const tp_node *node) {
  static const char *const keys[] = {"count",   "wavelength", "amplitude", "skew", "left_end",
                                     "scatter", "start",      "seed",      NULL};
  static const char example[] = "teeth: {count: 8, wavelength: 60, amplitude: 5, left_end: valley}";
  fmpq_t count;
  tp_status status = tp_node_expect_keys(node, keys, "teeth", reader->scene->path, reader->message);
  if (status != TP_OK) return status;
  fmpq_init(count);
  status = tp_read_rule_of(reader, count, node, keys[0], example, TP_RULE_ANY);
  if (status == TP_OK) {
    status =
        tp_check_tooth_count(&o->count, count, keys[0],
                             tp_read_place(reader, tp_node_get(node, keys[0])), reader->message);
  }
  fmpq_clear(count);
  if (status == TP_OK) {
    status = tp_read_rule_of(reader, o->wavelength, node, keys[1], example, TP_RULE_ABOVE_ZERO);
  }
  if (status == TP_OK) {
    status = tp_read_rule_of(reader, o->amplitude, node, keys[2], example, TP_RULE_ABOVE_ZERO);
  }
  if (status == TP_OK) {
    status = tp_read_within(reader, o->skew, node, keys[3], "-0.9", "0.9", false);
  }
  if (status == TP_OK) status = read_left_end(reader, &o->left_end_valley, node);
  if (status == TP_OK) status = read_scatter(reader, o, tp_node_get(node, "scatter"));
  if (status == TP_OK) status = check_skew(reader, o, node);
  return status == TP_OK ? tp_read_start(reader, o->x, o->y, node) : status;
}

tp_status tp_read_teeth_profile(const tp_reader *reader, tp_polyline *line, const tp_node *node) {
  tp_teeth_options o;
  tp_teeth_options_init(&o);
  tp_status status = read_options(reader, &o, node);
  const bool draws = !fmpq_is_zero(o.wavelength_scatter) || !fmpq_is_zero(o.amplitude_scatter) ||
                     !fmpq_is_zero(o.skew_scatter);
  if (status == TP_OK) status = tp_read_seed(reader, &o.seed, node, draws);
  if (status == TP_OK && !tp_generate_teeth(line, &o)) {
    status = tp_fail_memory(reader->message, "the profile");
  }
  tp_teeth_options_clear(&o);
  return status;
}
