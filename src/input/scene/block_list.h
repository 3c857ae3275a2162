/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The blocks of a scene of many blocks, and what its joints have instead of the scene's friction.
 * Included by scene/scene.h. */

#ifndef TP_SCENE_BLOCK_LIST_H
#define TP_SCENE_BLOCK_LIST_H

/* Of the name of a block, in bytes. */
enum { TP_MOST_BLOCK_NAME = 60 };

/* One block, shifted by `at`. */
typedef struct tp_listed_block {
  tp_place place;
  TP_OUTSIDE char *name;
  bool fixed; /* ground */
  long layer; /* of a drawing that it is from, counted from 1 as its keys list them; 0: from none */
  tp_quantity at_x, at_y;
  tp_block_description shape;
  int *edge_sets; /* of a slope that joints cut, for each edge of the outline: the set that made it,
                     TP_EDGE_OF_BASE or TP_EDGE_OF_NONE; NULL: none did */
} tp_listed_block;

/* All contacts between two blocks, by their numbers in the list; or between those of layers of a
 * drawing, which are numbers below 0: -1 the first. */
typedef struct tp_joint_description {
  tp_place place;
  long between[2];
  tp_quantity friction_angle_deg, cohesion_kpa, tension_kpa; /* not given: the scene's */
} tp_joint_description;

/* Columns side by side on steps that Goodman and Bray (1976) describe, or of the area of a slope:
 * the key columns, of which blocks and joints are made as it is read
 * (scene_reading/read_columns.c). */
typedef struct tp_columns_description {
  tp_quantity width, step, rise, fall, below_crest, above_crest;
  tp_quantity face_dip_deg, height, upper_dip_deg, base_dip_deg; /* of equal_area */
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

/* A set of joints that cut a slope: parallel traces at equal distances, but for their scatter. */
typedef struct tp_joint_set {
  tp_place place;
  TP_OUTSIDE char *name; /* NULL: its number */
  bool left;             /* the side that it dips towards */
  tp_quantity dip_deg, spacing, offset, persistence, length, spacing_scatter, dip_scatter_deg;
  tp_quantity friction_angle_deg, cohesion_kpa, tension_kpa; /* not given: the scene's */
} tp_joint_set;

enum { TP_EDGE_OF_NONE = -1, TP_EDGE_OF_BASE = -2 };

/* A slope in jointed rock: the key jointed_slope, of which blocks are made as it is read
 * (jointing/). The face rises from the toe towards the right, or the left; below the base all is
 * ground. */
typedef struct tp_jointed_slope {
  tp_place place; /* no file: there is none */
  bool right;     /* the face dips to the right */
  tp_quantity toe_x, toe_y, face_dip_deg, height, upper_dip_deg, front, behind, seed;
  tp_polyline surface;        /* points from left to right; none: by the numbers of the face */
  tp_joint_set base;          /* a plane that dips as the face does, and the strength along it */
  tp_polyline base_line;      /* or points of it */
  tp_quantity base_x, base_y; /* where the plane begins; not given: in the toe */
  long stepped_by;           /* a set: the plane is the mean of steps along its joints; -1: plane */
  tp_quantity tread_dip_deg; /* of those steps; not given: normal to the set */
  long set_count;
  tp_joint_set *sets;
} tp_jointed_slope;

/* No blocks: the scene is of one block on its base. */
typedef struct tp_block_list {
  tp_place place;
  long count, joint_count;
  tp_listed_block *blocks;
  tp_joint_description *joints;
  tp_columns_description columns;
  tp_support_description support;
  tp_jointed_slope slope;
} tp_block_list;

/* The set, or the base, that made an edge of a listed block, counted along its outline; NULL: none.
 */
const tp_joint_set *tp_block_list_set(const tp_block_list *many, long block, long edge);

#endif
