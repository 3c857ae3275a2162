/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks of a scene of many blocks, and what its joints have instead of the scene's friction.
 * Included by scene/scene.h. */

#ifndef TP_SCENE_BLOCK_LIST_H
#define TP_SCENE_BLOCK_LIST_H

/* One block, shifted by `at`. */
typedef struct tp_listed_block {
  tp_place place;
  TP_OUTSIDE char *name;
  bool fixed; /* ground */
  tp_quantity at_x, at_y;
  tp_block_description shape;
} tp_listed_block;

/* All contacts between two blocks, by their numbers in the list. */
typedef struct tp_joint_description {
  tp_place place;
  long between[2];
  tp_quantity friction_angle_deg, cohesion_kpa, tension_kpa; /* not given: the scene's */
} tp_joint_description;

/* Columns side by side on steps that Goodman and Bray (1976) describe: the key columns, of which
 * blocks and joints are made as it is read (scene_reading/read_columns.c). */
typedef struct tp_columns_description {
  tp_quantity width, step, rise, fall, below_crest, above_crest;
  tp_quantity side_friction_angle_deg; /* given: between columns, instead of the scene's */
} tp_columns_description;

/* The force on a point of a block that is asked for: what is needed for a factor of safety. */
typedef struct tp_support_description {
  tp_place place; /* no file: none is asked for */
  long block;
  tp_quantity x, y;
  tp_quantity direction_deg; /* not given: horizontal, against the side that a case goes to */
  tp_quantity fos;           /* not given: the scene's required_fos, else 1 */
} tp_support_description;

/* No blocks: the scene is of one block on its base. */
typedef struct tp_block_list {
  tp_place place;
  long count, joint_count;
  tp_listed_block *blocks;
  tp_joint_description *joints;
  tp_columns_description columns;
  tp_support_description support;
} tp_block_list;

#endif
