/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a scene holds, by offsets: single numbers, chains of points, and lists of items that have
 * numbers and a chain of their own. One table for what is done with all of them. */

#ifndef TP_SCENE_MEMBERS_H
#define TP_SCENE_MEMBERS_H

#include "scene/scene.h"

#include <stddef.h>

typedef struct tp_offsets {
  const size_t *items;
  size_t count;
} tp_offsets;

/* Numbers (fmpq_t) and chains (tp_polyline) of a scene. */
extern const tp_offsets tp_scene_numbers, tp_scene_lines;

/* Numbers of an item of the lists of blocks, of joint sets, and of contacts and parts of a solid.
 */
extern const tp_offsets tp_listed_block_numbers, tp_joint_set_numbers, tp_contact_numbers,
    tp_solid_part_numbers;

typedef enum tp_list_kind {
  TP_LIST_HOLES,
  TP_LIST_PARTS,
  TP_LIST_ARCS,
  TP_LIST_CORNERS,
  TP_LIST_PRESSURES,
  TP_LIST_SURCHARGES,
  TP_LIST_SUPPORTS,
  TP_LIST_ANCHORS,
  TP_LIST_FORCES,
  TP_LIST_JOINTS,
  TP_LIST_FRICTIONS,
  TP_LIST_TRACTIONS,
  TP_LISTS
} tp_list_kind;

/* A list: where the scene has its items and their count (long), and what is in an item. */
typedef struct tp_list {
  size_t items, count, size;
  tp_offsets numbers;
  bool has_line;
  size_t line;
} tp_list;

extern const tp_list tp_scene_lists[TP_LISTS];

fmpq *tp_member_number(void *of, size_t offset);
tp_polyline *tp_member_line(void *of, size_t offset);

/* The items of a list, and how many there are. */
char *tp_member_items(const tp_scene *scene, tp_list_kind list);
long tp_member_count(const tp_scene *scene, tp_list_kind list);
void tp_member_set_count(tp_scene *scene, tp_list_kind list, long count);
void tp_member_set_items(tp_scene *scene, tp_list_kind list, void *items);

/* Room for `more` holes of the block behind those that it has; false when memory is exhausted. */
TP_MUST_USE bool tp_scene_hole_room(tp_scene *scene, long more);

#endif
