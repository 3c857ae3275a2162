/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers that are accepted, yet look as if they stood in another unit.
 *
 * A rock weighs between 5 (pumice) and 80 kN/m3 (galena, 7.5 t/m3); a number beyond that is often
 * its density in kg/m3 or t/m3, or its weight in N/m3 or MN/m3. A block is between 1 cm, smaller
 * than any on a tilting table, and 300 m; beyond that its lengths are often off by a thousand. */

#include "scene/rule_jrc.h"
#include "scene/scene.h"
#include "scene/unit_cautions.h"

static const long lightest = 5, heaviest = 80; /* kN/m3 */
static const double likely[2] = {10, 60};      /* what a number in another unit is guessed for */
static const long most_m = 300, least_cm = 1;  /* of a block */
static const double gravity = 9.81;            /* m/s2, as for water; in the words of a caution */

/* What the number may have been meant as; false where nothing comes near a rock. */
static bool likely_meaning(double *kn_m3, const char **unit, double given) {
  const struct {
    const char *unit;
    double factor;
  } units[] = {{"kg/m³", gravity / 1000}, {"t/m³", gravity}, {"N/m³", 0.001}, {"MN/m³", 1000}};
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    *kn_m3 = given * units[k].factor;
    *unit = units[k].unit;
    if (*kn_m3 >= likely[0] && *kn_m3 <= likely[1]) return true;
  }
  return false;
}

static tp_status check_unit_weight(tp_notes *notes, const tp_quantity *quantity,
                                   tp_message *message) {
  if (!quantity->given || (fmpq_cmp_si(quantity->value, lightest) >= 0 &&
                           fmpq_cmp_si(quantity->value, heaviest) <= 0)) {
    return TP_OK;
  }
  const double given = fmpq_get_d(quantity->value);
  double meant = 0;
  const char *unit = NULL;
  if (!likely_meaning(&meant, &unit, given)) {
    return tp_notes_add(notes, message, TP_CAUTION, quantity->place,
                        "%.6g kN/m³ is far from any rock, which weighs %ld to %ld", given, lightest,
                        heaviest);
  }
  return tp_notes_add(notes, message, TP_CAUTION, quantity->place,
                      "%.6g kN/m³ is far from any rock, which weighs %ld to %ld; if it is in %s, "
                      "write %.3g",
                      given, lightest, heaviest, unit, meant);
}

/* The larger of width and height in scene lengths; arcs may reach farther. */
static void block_extent(fmpq_t extent, const tp_block_description *block) {
  fmpq_t other;
  fmpq_init(other);
  switch (block->form) {
  case TP_OUTLINE_VERTICES:
    tp_polyline_size(extent, other, &block->outline);
    break;
  case TP_OUTLINE_TEETH:
  case TP_OUTLINE_SLAB:
    fmpq_mul_si(extent, block->teeth.width, block->teeth.count);
    fmpq_add(other, block->teeth.height, block->teeth.depth);
    break;
  case TP_OUTLINE_OF_EACH:
  case TP_OUTLINE_OF_SOLID:
    fmpq_zero(extent);
    break;
  case TP_OUTLINE_ELLIPSE:
    fmpq_set(extent, block->ellipse.width.value);
    fmpq_set(other, block->ellipse.height.value);
    break;
  }
  if (fmpq_cmp(other, extent) > 0) fmpq_swap(extent, other);
  fmpq_clear(other);
}

/* `length` is in scene lengths; it is all of the length, or as much of it as is known here. */
static tp_status check_length(tp_notes *notes, const tp_scene *scene, const fmpq_t length,
                              bool whole, const char *what, tp_place place, tp_message *message) {
  fmpq_t metres, least;
  fmpq_init(metres);
  fmpq_init(least);
  fmpq_mul(metres, length, scene->metres_per_unit);
  fmpq_set_si(least, least_cm, 100);
  const bool large = fmpq_cmp_si(metres, most_m) > 0, small = fmpq_cmp(metres, least) < 0;
  const double size = fmpq_get_d(metres);
  fmpq_clear(metres);
  fmpq_clear(least);
  if (!large && !(small && whole)) return TP_OK;
  const char *unit = small ? "mm" : size < 1000 ? "m" : "km";
  return tp_notes_add(notes, message, TP_CAUTION, place,
                      "%s %.4g %s, which is implausible; is 'length_unit: %s' right?", what,
                      small         ? 1000 * size
                      : size < 1000 ? size
                                    : size / 1000,
                      unit, scene->length_unit);
}

/* Each unit weight once: that of all blocks has the place where it stands for all. */
static tp_status check_blocks(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const tp_quantity *all = &scene->block.unit_weight_kn_m3;
  tp_status status = check_unit_weight(notes, all, message);
  for (long k = 0; k < scene->many.count && status == TP_OK; k++) {
    const tp_quantity *own = &scene->many.blocks[k].shape.unit_weight_kn_m3;
    if (all->given && own->place.line == all->place.line) continue;
    status = check_unit_weight(notes, own, message);
  }
  return status;
}

/* The largest block that is free, by the greater side of its box: one caution for all. */
static tp_status check_extents(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const tp_listed_block *largest = NULL;
  fmpq_t most, own;
  fmpq_init(most);
  fmpq_init(own);
  for (long k = 0; k < scene->many.count; k++) {
    const tp_listed_block *listed = scene->many.blocks + k;
    if (listed->fixed) continue;
    block_extent(own, &listed->shape);
    if (largest != NULL && fmpq_cmp(own, most) <= 0) continue;
    largest = listed;
    fmpq_swap(most, own);
  }
  const tp_status status =
      largest == NULL ? TP_OK
                      : check_length(notes, scene, most, largest->shape.arc_count == 0,
                                     "the largest block measures", largest->place, message);
  fmpq_clear(most);
  fmpq_clear(own);
  return status;
}

static tp_status check_solid(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const tp_solid_description *solid = &scene->solid;
  tp_status status = check_unit_weight(notes, &solid->unit_weight_kn_m3, message);
  for (long k = 0; k < solid->part_count && status == TP_OK; k++) {
    status = check_unit_weight(notes, &solid->parts[k].unit_weight_kn_m3, message);
  }
  if (status == TP_OK && solid->wedge.height.given) {
    status = check_length(notes, scene, solid->wedge.height.value, true, "the wedge's height is",
                          solid->wedge.height.place, message);
  }
  return status == TP_OK ? tp_scene_unit_cautions(notes, scene, message) : status;
}

tp_status tp_scene_cautions(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const tp_block_description *block = &scene->block;
  if (scene->many.count > 0) {
    tp_status own = check_extents(notes, scene, message);
    if (own == TP_OK) own = check_blocks(notes, scene, message);
    return own == TP_OK ? tp_scene_unit_cautions(notes, scene, message) : own;
  }
  if (scene->solid.place.file != NULL) {
    return check_solid(notes, scene, message);
  }
  fmpq_t extent;
  fmpq_init(extent);
  block_extent(extent, block);
  tp_status status = check_length(notes, scene, extent, block->arc_count == 0, "the block measures",
                                  block->place, message);
  fmpq_clear(extent);
  if (status == TP_OK && block->thickness.given) {
    status = check_length(notes, scene, block->thickness.value, true, "the block's thickness is",
                          block->thickness.place, message);
  }
  if (status == TP_OK) status = check_unit_weight(notes, &block->unit_weight_kn_m3, message);
  for (long k = 0; k < block->part_count && status == TP_OK; k++) {
    status = check_unit_weight(notes, &block->parts[k].unit_weight_kn_m3, message);
  }
  return status == TP_OK ? tp_scene_unit_cautions(notes, scene, message) : status;
}

tp_status tp_scene_notes(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  if (scene->source != NULL) return tp_notes_append(notes, &scene->notes, message);
  const tp_status status =
      tp_profile_rule_notes(notes, &scene->base.rule, scene->metres_per_unit, message);
  return status == TP_OK ? tp_scene_cautions(notes, scene, message) : status;
}
