/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Eqs. (15) and (16) of Alejano et al. for any base: tan alpha = (dx/y) / (1 -+ A/y - A^2 / (12
 * y^2)), about a peak and a valley, with dx the width of the block, y its mean height above the
 * mean line of the base (its area over dx, of a block that fits its base) and A from the lowest to
 * the highest point of the base. They are for a block with upright sides and a level top; of any
 * other there are none, nor beyond A = y / 2. */

#include "study/roughness.h"

#include "block/section.h"
#include "common/outside.h"
#include "number/ratio.h"
#include "paper/teeth.h"
#include "study/outcome.h"
#include "topple_profile.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[TP_MEASURES] = {
    "amplitude", "rms_height", "z2", "effective_angle_deg", "jrc", "peak_deg", "valley_deg"};

const char *tp_study_measure_name(tp_study_measure_kind kind) {
  return names[kind];
}

bool tp_study_measure_is_length(tp_study_measure_kind kind) {
  return kind == TP_MEASURE_AMPLITUDE || kind == TP_MEASURE_RMS_HEIGHT;
}

const char *tp_study_measure_unit(const tp_study *study, size_t measure) {
  const tp_study_measure_kind kind = study->measures[measure];
  if (tp_study_measure_is_length(kind)) return study->scene->length_unit;
  return kind == TP_MEASURE_Z2 || kind == TP_MEASURE_JRC ? NULL : "deg";
}

/* ---- what is asked for -------------------------------------------------------------------------
 */

static tp_status read_one(const tp_study_reader *reader, const tp_node *node) {
  tp_study *study = reader->study;
  const char *known[TP_MEASURE_PEAK + 1] = {NULL};
  for (int k = 0; k < TP_MEASURE_PEAK; k++) {
    known[k] = names[k];
    if (node->kind != TP_NODE_SCALAR || strcmp(node->text, names[k]) != 0) continue;
    for (size_t j = 0; j < study->measure_count; j++) {
      if (study->measures[j] != (tp_study_measure_kind)k) continue;
      return tp_study_fail(reader, node, "'%s' stands here twice", names[k]);
    }
    study->measures[study->measure_count++] = (tp_study_measure_kind)k;
    return TP_OK;
  }
  const char *nearest = node->kind == TP_NODE_SCALAR ? tp_nearest(node->text, known) : NULL;
  return tp_study_fail(reader, node,
                       "a number of roughness is amplitude, rms_height, z2, effective_angle_deg or "
                       "jrc%s%s%s",
                       nearest != NULL ? "; did you mean '" : "", nearest != NULL ? nearest : "",
                       nearest != NULL ? "'?" : "");
}

tp_status tp_study_read_roughness(const tp_study_reader *reader, const tp_node *root) {
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "roughness");
  if (node == NULL) return TP_OK;
  if (tp_study_is_of_many(study) || tp_study_is_of_solid(study)) {
    return tp_study_fail(
        reader, node,
        "roughness is measured on the base of one block in a section, and this scene has none; "
        "leave it out");
  }
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0) {
    return tp_study_fail(reader, node, "roughness is a list of numbers to measure, as '[z2, jrc]'");
  }
  tp_status status = TP_OK;
  for (const tp_node *own = node->first; own != NULL && status == TP_OK; own = own->next) {
    status = read_one(reader, own);
  }
  study->measures[study->measure_count++] = TP_MEASURE_PEAK;
  study->measures[study->measure_count++] = TP_MEASURE_VALLEY;
  return status;
}

/* ---- a block and its base ----------------------------------------------------------------------
 */

/* Width and mean height, in scene lengths; zero where its sides are not upright or its top is not
 * level. */
typedef struct upright {
  double width, height;
} upright;

/* The edge from a vertex, counter-clockwise. */
static bool is_along(const tp_polyline *ring, long from, bool upright_edge) {
  const long to = (from + 1) % ring->count;
  const fmpq *at = upright_edge ? ring->x : ring->y;
  return fmpq_equal(at + from, at + to) != 0;
}

/* Of the vertices with the greatest y that the leftmost, or the rightmost, is; -1: that vertex of
 * the outline is not as far out as any. */
static long find_top(const tp_polyline *ring, int side) {
  long top = 0;
  for (long k = 1; k < ring->count; k++) {
    const int higher = fmpq_cmp(ring->y + k, ring->y + top);
    const int outer = side * fmpq_cmp(ring->x + k, ring->x + top);
    if (higher > 0 || (higher == 0 && outer > 0)) top = k;
  }
  for (long k = 0; k < ring->count; k++) {
    if (side * fmpq_cmp(ring->x + k, ring->x + top) > 0) return -1;
  }
  return top;
}

/* Twice the area of the ring, counter-clockwise above zero. */
static double area_of(const tp_polyline *ring) {
  fmpq_t sum, term;
  fmpq_init(sum);
  fmpq_init(term);
  for (long k = 0; k < ring->count; k++) {
    const long next = (k + 1) % ring->count;
    fmpq_mul(term, ring->x + k, ring->y + next);
    fmpq_add(sum, sum, term);
    fmpq_mul(term, ring->x + next, ring->y + k);
    fmpq_sub(sum, sum, term);
  }
  const double twice = tp_study_double(sum);
  fmpq_clear(sum);
  fmpq_clear(term);
  return fabs(twice) / 2;
}

/* From the right corner up top to the left one, and down from there; up to the right one. */
static upright measure_ring(const tp_polyline *ring) {
  const upright none = {0, 0};
  const long left = find_top(ring, -1), right = find_top(ring, 1);
  if (left < 0 || right < 0 || left == right) return none;
  for (long k = right; k != left; k = (k + 1) % ring->count) {
    if (!is_along(ring, k, false)) return none;
  }
  if (!is_along(ring, left, true) ||
      !is_along(ring, (right + ring->count - 1) % ring->count, true)) {
    return none;
  }
  fmpq_t width;
  fmpq_init(width);
  fmpq_sub(width, ring->x + right, ring->x + left);
  const double own = tp_study_double(width);
  fmpq_clear(width);
  return (upright){own, area_of(ring) / own};
}

static tp_status measure_block(upright *block, const tp_scene *scene, tp_message *message) {
  tp_section section;
  *block = (upright){0, 0};
  const tp_status status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  if (section.ring_count == 1 && scene->block.arc_count == 0 && scene->frame != TP_FRAME_WORLD) {
    *block = measure_ring(section.rings);
  }
  tp_section_clear(&section);
  return TP_OK;
}

static double angle_of(const upright *block, double amplitude, tp_toe_kind toe) {
  const tp_toothed own = {block->width / block->height, amplitude / block->height, 0};
  if (!(own.amplitude <= 0.5)) return NAN;
  return atan(tp_toothed_tangent(&own, toe).value) * tp_degrees_of_radian;
}

/* A block that fits a part of its width only is none of the paper's. */
static bool spans(const upright *block, const tp_profile *profile) {
  const double off = fabs(profile->length.value - block->width);
  return block->width > 0 && (profile->origin != TP_PROFILE_MATED_BASE ||
                              off <= profile->length.error + DBL_EPSILON * block->width);
}

static double number_of(tp_study_measure_kind kind, const tp_profile *profile,
                        const upright *block) {
  switch (kind) {
  case TP_MEASURE_AMPLITUDE:
    return profile->amplitude.value;
  case TP_MEASURE_RMS_HEIGHT:
    return profile->rms_height.value;
  case TP_MEASURE_Z2:
    return profile->z2.value;
  case TP_MEASURE_INCLINATION:
    return profile->effective_angle_deg.value;
  case TP_MEASURE_JRC:
    return profile->jrc_meant > 0 ? profile->jrc_median.value : NAN;
  case TP_MEASURE_PEAK:
  case TP_MEASURE_VALLEY:
    break;
  default:
    return NAN;
  }
  if (!spans(block, profile)) return NAN;
  return angle_of(block, profile->amplitude.value,
                  kind == TP_MEASURE_PEAK ? TP_TOE_PEAK : TP_TOE_VALLEY);
}

/* ---- a sample ----------------------------------------------------------------------------------
 */

static tp_status make_scene(tp_scene **scene, const tp_study *study, const double *values,
                            tp_message *message) {
  const size_t count = study->variable_count;
  tp_scene_key *keys = calloc(count, sizeof *keys);
  fmpq *numbers = calloc(count, sizeof *numbers);
  bool read = keys != NULL && numbers != NULL;
  if (!read) {
    free(keys);
    free(numbers);
    return tp_fail_memory(message, "a sample");
  }
  for (size_t k = 0; k < count; k++) fmpq_init(numbers + k);
  for (size_t k = 0; k < count; k++) {
    keys[k] = study->variables[k].key;
    read = read && tp_ratio_read_double(numbers + k, values[k]);
  }
  const tp_status status =
      read ? tp_scene_vary(scene, study->scene, keys, numbers, count, message)
           : tp_refuse(message, TP_FAULT_RANGE, (tp_place){0}, "a number is out of range");
  for (size_t k = 0; k < count; k++) fmpq_clear(numbers + k);
  free(numbers);
  free(keys);
  return status;
}

static tp_status measure(tp_study_row *row, const tp_study *study, const tp_scene *scene,
                         tp_message *message) {
  const tp_profile_options options = tp_profile_options_default();
  tp_profile *profile = NULL;
  upright block;
  tp_status status = tp_profile_of_scene(&profile, scene, &options, message);
  if (status == TP_OK) status = measure_block(&block, scene, message);
  for (size_t k = 0; k < study->measure_count && status == TP_OK; k++) {
    row->measures[k] = number_of(study->measures[k], profile, &block);
  }
  tp_profile_free(profile);
  return status;
}

tp_status tp_study_measure_roughness(tp_study_row *row, const tp_study *study,
                                     tp_message *message) {
  for (size_t k = 0; k < TP_MEASURES; k++) row->measures[k] = NAN;
  if (study->measure_count == 0 || row->at[0].outcome == TP_STUDY_INVALID) return TP_OK;
  tp_scene *scene = NULL;
  tp_message why = {.text = ""};
  tp_status status = make_scene(&scene, study, row->values, &why);
  if (status == TP_OK) status = measure(row, study, scene, &why);
  tp_scene_free(scene);
  if (status == TP_BAD_INPUT || status == TP_NO_ANSWER || status == TP_UNDECIDED) return TP_OK;
  if (status != TP_OK && message != NULL) *message = why;
  return status;
}
