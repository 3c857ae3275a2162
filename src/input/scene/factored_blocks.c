/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Partial factors of many blocks: of the unit weights of blocks and of their parts, as of what
 * holds for all (scene/factored.c); of cohesion and tensile strength of joints, of the sets that
 * cut a slope and of its base. What has no number of its own has the scene's, which is factored
 * there. */

#include "scene/factored.h"

#include <stdlib.h>

static void scale_block(tp_listed_block *own, const fmpq_t weight) {
  tp_factored_scale(own->shape.unit_weight_kn_m3.value, weight);
  for (long k = 0; k < own->shape.part_count; k++) {
    tp_factored_scale(own->shape.parts[k].unit_weight_kn_m3.value, weight);
  }
}

static bool own_blocks(tp_block_list *many, const fmpq_t weight) {
  const long count = many->count;
  many->count = 0; /* of those that are its own by now */
  many->blocks = tp_factored_copy(many->blocks, count, sizeof *many->blocks);
  if (many->blocks == NULL) return false;
  for (; many->count < count; many->count++) {
    tp_block_description *own = &many->blocks[many->count].shape;
    own->parts = tp_factored_copy(own->parts, own->part_count, sizeof *own->parts);
    if (own->parts == NULL) return false;
    scale_block(many->blocks + many->count, weight);
  }
  return true;
}

static void scale_set(tp_joint_set *set, const fmpq_t cohesion) {
  tp_factored_scale_over(set->cohesion_kpa.value, cohesion);
  tp_factored_scale_over(set->tension_kpa.value, cohesion);
}

static void clear_set(tp_joint_set *set) {
  fmpq_clear(set->cohesion_kpa.value);
  fmpq_clear(set->tension_kpa.value);
}

bool tp_factored_blocks_init(tp_scene *factored, const fmpq_t weight, const fmpq_t cohesion) {
  tp_block_list *many = &factored->many;
  const bool done = own_blocks(many, weight);
  many->joints = tp_factored_copy(many->joints, many->joint_count, sizeof *many->joints);
  many->slope.sets =
      tp_factored_copy(many->slope.sets, many->slope.set_count, sizeof *many->slope.sets);
  for (long k = 0; k < many->joint_count && many->joints != NULL; k++) {
    tp_factored_scale_over(many->joints[k].cohesion_kpa.value, cohesion);
    tp_factored_scale_over(many->joints[k].tension_kpa.value, cohesion);
  }
  for (long k = 0; k < many->slope.set_count && many->slope.sets != NULL; k++) {
    scale_set(many->slope.sets + k, cohesion);
  }
  scale_set(&many->slope.base, cohesion);
  return done && many->joints != NULL && many->slope.sets != NULL;
}

void tp_factored_blocks_clear(tp_scene *factored) {
  tp_block_list *many = &factored->many;
  for (long k = 0; k < many->count; k++) {
    tp_block_description *own = &many->blocks[k].shape;
    fmpq_clear(own->unit_weight_kn_m3.value);
    for (long n = 0; n < own->part_count; n++) fmpq_clear(own->parts[n].unit_weight_kn_m3.value);
    free(own->parts);
  }
  for (long k = 0; k < many->joint_count && many->joints != NULL; k++) {
    fmpq_clear(many->joints[k].cohesion_kpa.value);
    fmpq_clear(many->joints[k].tension_kpa.value);
  }
  for (long k = 0; k < many->slope.set_count && many->slope.sets != NULL; k++) {
    clear_set(many->slope.sets + k);
  }
  clear_set(&many->slope.base);
  free(many->blocks);
  free(many->joints);
  free(many->slope.sets);
}
