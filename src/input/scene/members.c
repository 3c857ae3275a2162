/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tables of offsets of all numbers, chains and lists in a scene and in the items of its lists;
 * whatever is done to all members walks these. */

#include "scene/members.h"

#include "scene_keys.h"

#include <stdlib.h>
#include <string.h>

#define IN_SCENE(member) offsetof(tp_scene, member)
#define OFFSET(type, member) offsetof(type, member),
#define OFFSETS(array)                                                                             \
  { array, sizeof(array) / sizeof(array)[0] }

static const size_t numbers[] = {IN_SCENE(metres_per_unit),
                                 IN_SCENE(solid.metres_per_unit),
                                 IN_SCENE(solid.ground.metres_per_unit),
                                 IN_SCENE(solid.up[0]),
                                 IN_SCENE(solid.up[1]),
                                 IN_SCENE(solid.up[2]),
                                 TP_SCENE_NUMBERS(OFFSET)};
static const size_t lines[] = {IN_SCENE(block.outline),      IN_SCENE(base.between),
                               IN_SCENE(base.profile),       IN_SCENE(base.rule.measured),
                               IN_SCENE(mean_plane),         IN_SCENE(loads.water.surface),
                               IN_SCENE(shaking[0].record),  IN_SCENE(shaking[1].record),
                               IN_SCENE(many.slope.surface), IN_SCENE(many.slope.base_line)};

const tp_offsets tp_scene_numbers = OFFSETS(numbers), tp_scene_lines = OFFSETS(lines);

static const size_t of_part[] = {TP_NUMBERS_OF_PART(OFFSET)};
static const size_t of_arc[] = {TP_NUMBERS_OF_ARC_DESCRIPTION(OFFSET)};
static const size_t of_corner[] = {TP_NUMBERS_OF_CORNER_DESCRIPTION(OFFSET)};
static const size_t of_line_load[] = {TP_NUMBERS_OF_LINE_LOAD(OFFSET)};
static const size_t of_anchor[] = {TP_NUMBERS_OF_ANCHOR_DESCRIPTION(OFFSET)};
static const size_t of_facets[] = {TP_NUMBERS_OF_FACET_FRICTION_DESCRIPTION(OFFSET)};
static const size_t of_traction[] = {TP_NUMBERS_OF_TRACTION_DESCRIPTION(OFFSET)};
static const size_t of_listed_block[] = {TP_NUMBERS_OF_LISTED_BLOCK(OFFSET)};
static const size_t of_joint[] = {TP_NUMBERS_OF_JOINT_DESCRIPTION(OFFSET)};
static const size_t of_joint_set[] = {TP_NUMBERS_OF_JOINT_SET(OFFSET)};
static const size_t of_contact[] = {TP_NUMBERS_OF_CONTACT_DESCRIPTION(OFFSET)};
static const size_t of_solid_part[] = {TP_NUMBERS_OF_SOLID_PART_DESCRIPTION(OFFSET)};

const tp_offsets tp_listed_block_numbers = OFFSETS(of_listed_block);
const tp_offsets tp_joint_set_numbers = OFFSETS(of_joint_set);
const tp_offsets tp_contact_numbers = OFFSETS(of_contact);
const tp_offsets tp_solid_part_numbers = OFFSETS(of_solid_part);

#define ITEMS(list, number, type)                                                                  \
  .items = IN_SCENE(list), .count = IN_SCENE(number), .size = sizeof(type)

const tp_list tp_scene_lists[TP_LISTS] = {
    [TP_LIST_HOLES] = {ITEMS(block.holes, block.hole_count, tp_polyline), .has_line = true},
    [TP_LIST_PARTS] = {ITEMS(block.parts, block.part_count, tp_part), .numbers = OFFSETS(of_part),
                       .has_line = true, .line = offsetof(tp_part, outline)},
    [TP_LIST_ARCS] = {ITEMS(block.arcs, block.arc_count, tp_arc_description),
                      .numbers = OFFSETS(of_arc)},
    [TP_LIST_CORNERS] = {ITEMS(block.rounded.corners, block.rounded.count, tp_corner_description),
                         .numbers = OFFSETS(of_corner)},
    [TP_LIST_PRESSURES] = {ITEMS(loads.pressures, loads.pressure_count, tp_line_load),
                           .numbers = OFFSETS(of_line_load)},
    [TP_LIST_SURCHARGES] = {ITEMS(loads.surcharges, loads.surcharge_count, tp_line_load),
                            .numbers = OFFSETS(of_line_load)},
    [TP_LIST_SUPPORTS] = {ITEMS(loads.supports, loads.support_count, tp_line_load),
                          .numbers = OFFSETS(of_line_load)},
    [TP_LIST_ANCHORS] = {ITEMS(loads.anchors, loads.anchor_count, tp_anchor_description),
                         .numbers = OFFSETS(of_anchor)},
    [TP_LIST_FORCES] = {ITEMS(loads.forces, loads.force_count, tp_anchor_description),
                        .numbers = OFFSETS(of_anchor)},
    [TP_LIST_JOINTS] = {ITEMS(many.joints, many.joint_count, tp_joint_description),
                        .numbers = OFFSETS(of_joint)},
    [TP_LIST_FRICTIONS] = {ITEMS(friction.facets, friction.facet_count,
                                 tp_facet_friction_description),
                           .numbers = OFFSETS(of_facets)},
    [TP_LIST_TRACTIONS] = {
        ITEMS(tilt_test.tractions, tilt_test.traction_count, tp_traction_description),
        .numbers = OFFSETS(of_traction)}};

fmpq *tp_member_number(void *of, size_t offset) {
  return (fmpq *)(void *)((char *)of + offset);
}

tp_polyline *tp_member_line(void *of, size_t offset) {
  return (tp_polyline *)(void *)((char *)of + offset);
}

/* The pointers are of as many types as there are lists: copied, not read through one of them. */
char *tp_member_items(const tp_scene *scene, tp_list_kind list) {
  char *items = NULL;
  memcpy(&items, (const char *)scene + tp_scene_lists[list].items, sizeof items);
  return items;
}

long tp_member_count(const tp_scene *scene, tp_list_kind list) {
  long count = 0;
  memcpy(&count, (const char *)scene + tp_scene_lists[list].count, sizeof count);
  return count;
}

void tp_member_set_count(tp_scene *scene, tp_list_kind list, long count) {
  memcpy((char *)scene + tp_scene_lists[list].count, &count, sizeof count);
}

void tp_member_set_items(tp_scene *scene, tp_list_kind list, void *items) {
  memcpy((char *)scene + tp_scene_lists[list].items, &items, sizeof items);
}

bool tp_scene_hole_room(tp_scene *scene, long more) {
  tp_block_description *block = &scene->block;
  if (more == 0) return true;
  tp_polyline *holes = realloc(block->holes, (size_t)(block->hole_count + more) * sizeof *holes);
  if (holes != NULL) block->holes = holes;
  return holes != NULL;
}
