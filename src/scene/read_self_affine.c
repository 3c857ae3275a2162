/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A self-affine base. Where a JRC is asked for, the profile gets the Z2 that has it by the
 * regression of Tse and Cruden (1979), JRC = 32.2 + 32.47 log10 Z2, for steps of 0.508 mm (1.27 mm
 * on profiles enlarged 2.5 times). */

#include "generate/generate.h"
#include "number/ball.h"
#include "number/ratio.h"
#include "scene/read_generated.h"

#include <string.h>

/* Z2 = 10^((JRC - 32.2) / 32.47), by a ball that is narrower than a double, to the nearest one. */
static void find_z2(fmpq_t z2, const fmpq_t jrc) {
  enum { BITS = 160 };
  fmpq_t number;
  arb_t power, ten;
  fmpq_init(number);
  arb_init(power);
  arb_init(ten);
  fmpq_set_si(number, 322, 10);
  fmpq_sub(z2, jrc, number);
  fmpq_set_si(number, 3247, 100);
  fmpq_div(z2, z2, number);
  arb_set_fmpq(power, z2, BITS);
  arb_set_ui(ten, 10);
  arb_pow(power, ten, power, BITS);
  arf_t nearest;
  arf_init(nearest);
  arf_set_round(nearest, arb_midref(power), 53, ARF_RND_NEAR);
  arf_get_fmpq(z2, nearest);
  arf_clear(nearest);
  fmpq_clear(number);
  arb_clear(power);
  arb_clear(ten);
}

/* The profile is none of Barton's, and its JRC holds by that regression. */
static tp_status note_jrc(const tp_reader *reader, const tp_self_affine_options *o,
                          const tp_node *node) {
  fmpq_t step_mm;
  fmpq_init(step_mm);
  fmpq_mul(step_mm, o->step, reader->scene->metres_per_unit);
  fmpq_mul_si(step_mm, step_mm, 1000);
  const double mm = fmpq_get_d(step_mm);
  fmpq_clear(step_mm);
  return tp_notes_add(
      &reader->scene->notes, reader->message, TP_NOTE, tp_read_place(reader, node),
      "the base is generated, self-affine, and none of Barton's profiles: its Z2 of "
      "%.4g is what the JRC asked for has by Tse and Cruden (1979), whose points "
      "were 0.508 mm apart; these are %.4g mm apart",
      fmpq_get_d(o->size), mm);
}

static tp_status read_target(const tp_reader *reader, tp_self_affine_options *o,
                             const tp_node *node) {
  const tp_node *rms = tp_node_get(node, "rms_height"), *z2 = tp_node_get(node, "z2");
  const tp_node *jrc = tp_node_get(node, "jrc");
  if ((rms != NULL) + (z2 != NULL) + (jrc != NULL) != 1) {
    return tp_read_fail(reader, node,
                        "how rough a self-affine profile is, one of rms_height, z2 and jrc says");
  }
  o->target = rms != NULL ? TP_TARGET_RMS_HEIGHT : TP_TARGET_Z2;
  if (rms != NULL) return tp_read_by_rule(reader, o->size, rms, rms->key, TP_RULE_ABOVE_ZERO);
  if (z2 != NULL) return tp_read_within(reader, o->size, node, "z2", "0.000001", "1000", false);
  fmpq_t value;
  fmpq_init(value);
  tp_status status = tp_read_within(reader, value, node, "jrc", "0", "20", false);
  if (status == TP_OK) {
    find_z2(o->size, value);
    status = note_jrc(reader, o, jrc);
  }
  fmpq_clear(value);
  return status;
}

/* A whole number of steps. */
static tp_status read_length(const tp_reader *reader, tp_self_affine_options *o, fmpq_t length,
                             const tp_node *node) {
  static const char example[] =
      "self_affine: {length: 100, step: 0.5, hurst: 0.8, rms_height: 1, seed: 1}";
  tp_status status = tp_read_rule_of(reader, length, node, "length", example, TP_RULE_ABOVE_ZERO);
  if (status == TP_OK) {
    status = tp_read_rule_of(reader, o->step, node, "step", example, TP_RULE_ABOVE_ZERO);
  }
  if (status != TP_OK) return status;
  fmpq_t steps;
  fmpq_init(steps);
  fmpq_div(steps, length, o->step);
  if (!fmpz_is_one(fmpq_denref(steps)) || fmpq_cmp_si(steps, TP_SELF_AFFINE_LEAST) < 0 ||
      fmpq_cmp_si(steps, TP_SELF_AFFINE_MOST) >= 0) {
    char text[80];
    tp_ratio_text(text, sizeof text, steps);
    status = tp_read_fail(reader, tp_node_get(node, "step"),
                          "the length must be a whole number of steps, from %d to %d; it is %s",
                          TP_SELF_AFFINE_LEAST, TP_SELF_AFFINE_MOST - 1, text);
  } else {
    o->steps = fmpz_get_si(fmpq_numref(steps));
  }
  fmpq_clear(steps);
  return status;
}

/* 2 step <= shortest < longest <= length, which the two are at their ends unless given. */
static tp_status read_band(const tp_reader *reader, tp_self_affine_options *o, const fmpq_t length,
                           const tp_node *node) {
  const tp_node *shortest = tp_node_get(node, "shortest"), *longest = tp_node_get(node, "longest");
  fmpq_t twice;
  fmpq_init(twice);
  fmpq_mul_2exp(twice, o->step, 1);
  fmpq_set(o->shortest, twice);
  fmpq_set(o->longest, length);
  tp_status status = TP_OK;
  if (shortest != NULL) status = tp_read_number(reader, o->shortest, shortest, "shortest");
  if (status == TP_OK && longest != NULL) {
    status = tp_read_number(reader, o->longest, longest, "longest");
  }
  const bool in_order = fmpq_cmp(twice, o->shortest) <= 0 &&
                        fmpq_cmp(o->shortest, o->longest) < 0 && fmpq_cmp(o->longest, length) <= 0;
  fmpq_clear(twice);
  if (status != TP_OK || in_order) return status;
  return tp_read_fail(reader, shortest != NULL ? shortest : longest,
                      "wavelengths go from 'shortest', at least two steps, to 'longest', above it "
                      "and at most the length");
}

static tp_status read_options(const tp_reader *reader, tp_self_affine_options *o,
                              const tp_node *node) {
  static const char *const keys[] = {"length",   "step",    "hurst", "rms_height", "z2", "jrc",
                                     "shortest", "longest", "start", "seed",       NULL};
  fmpq_t value;
  tp_status status =
      tp_node_expect_keys(node, keys, "self_affine", reader->scene->path, reader->message);
  if (status != TP_OK) return status;
  fmpq_init(value);
  status = read_length(reader, o, value, node);
  if (status == TP_OK) status = read_band(reader, o, value, node);
  if (status == TP_OK) {
    const tp_node *hurst = NULL;
    status = tp_read_required(reader, &hurst, node, "hurst", "hurst: 0.8");
  }
  if (status == TP_OK) status = tp_read_within(reader, value, node, "hurst", "0", "1", true);
  if (status == TP_OK) o->hurst = fmpq_get_d(value);
  fmpq_clear(value);
  if (status == TP_OK) status = read_target(reader, o, node);
  if (status == TP_OK) status = tp_read_start(reader, o->x, o->y, node);
  return status == TP_OK ? tp_read_seed(reader, &o->seed, node, true) : status;
}

tp_status tp_read_self_affine(const tp_reader *reader, tp_polyline *line, const tp_node *node) {
  tp_self_affine_options o;
  bool no_wave = false;
  tp_self_affine_options_init(&o);
  tp_status status = read_options(reader, &o, node);
  if (status == TP_OK && !tp_generate_self_affine(line, &no_wave, &o)) {
    status = tp_fail_memory(reader->message, "the profile");
  }
  if (status == TP_OK && no_wave) {
    status = tp_read_fail(reader, node,
                          "no wave of the profile's period lies between 'shortest' and 'longest'; "
                          "set them farther apart");
  }
  tp_self_affine_options_clear(&o);
  return status;
}
