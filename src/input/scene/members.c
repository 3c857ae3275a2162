/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tables of offsets of all numbers, chains and lists in a scene and in the items of its lists;
 * whatever is done to all members walks these. */

#include "scene/members.h"

#include <stdlib.h>
#include <string.h>

#define IN_SCENE(member) offsetof(tp_scene, member)
#define IN_RULE(member) offsetof(tp_scene, base.rule.member.value)
#define IN_TEST(member) offsetof(tp_scene, tilt_test.member.value)
#define IN_SHAKING(axis, member) offsetof(tp_scene, shaking[axis].member.value)
#define OFFSETS(array)                                                                             \
  { array, sizeof(array) / sizeof(array)[0] }

static const size_t numbers[] = {IN_SCENE(metres_per_unit),
                                 IN_SCENE(block.teeth.width),
                                 IN_SCENE(block.teeth.height),
                                 IN_SCENE(block.teeth.depth),
                                 IN_SCENE(block.teeth.block_width.value),
                                 IN_SCENE(block.teeth.mean_height.value),
                                 IN_SCENE(block.ellipse.width.value),
                                 IN_SCENE(block.ellipse.height.value),
                                 IN_SCENE(block.ellipse.flat.value),
                                 IN_SCENE(block.thickness.value),
                                 IN_SCENE(block.unit_weight_kn_m3.value),
                                 IN_SCENE(base.beyond_left.value),
                                 IN_SCENE(base.beyond_right.value),
                                 IN_SCENE(base.below.value),
                                 IN_SCENE(base.start_x.value),
                                 IN_SCENE(base.within.value),
                                 IN_SCENE(friction.contact_width.value),
                                 IN_SCENE(base.shift.value),
                                 IN_SCENE(base.matching.value),
                                 IN_SCENE(base.closure.value),
                                 IN_SCENE(base.left_of.value),
                                 IN_SCENE(base.right_of.value),
                                 IN_RULE(count),
                                 IN_RULE(wavelength),
                                 IN_RULE(amplitude),
                                 IN_RULE(skew),
                                 IN_RULE(scatter[0]),
                                 IN_RULE(scatter[1]),
                                 IN_RULE(scatter[2]),
                                 IN_RULE(length),
                                 IN_RULE(step),
                                 IN_RULE(hurst),
                                 IN_RULE(shortest),
                                 IN_RULE(longest),
                                 IN_RULE(roughness[0]),
                                 IN_RULE(roughness[1]),
                                 IN_RULE(roughness[2]),
                                 IN_RULE(start_x),
                                 IN_RULE(start_y),
                                 IN_RULE(seed),
                                 IN_RULE(standard),
                                 IN_RULE(deviation),
                                 IN_RULE(noise_seed),
                                 IN_RULE(scaled[0]),
                                 IN_RULE(scaled[1]),
                                 IN_RULE(scaled[2]),
                                 IN_RULE(worn[0]),
                                 IN_RULE(worn[1]),
                                 IN_RULE(worn[2]),
                                 IN_SCENE(loads.horizontal.value),
                                 IN_SCENE(loads.vertical.value),
                                 IN_SCENE(loads.water.height.value),
                                 IN_SCENE(loads.water.unit_weight_kn_m3.value),
                                 IN_SCENE(loads.bond_kpa.value),
                                 IN_SCENE(loads.cohesion_kpa.value),
                                 IN_SCENE(friction_angle_deg.value),
                                 IN_SCENE(friction.basic_angle_deg.value),
                                 IN_SCENE(friction.jrc.value),
                                 IN_SCENE(friction.jcs_mpa.value),
                                 IN_SCENE(friction.roughness_angle_deg.value),
                                 IN_SCENE(friction.test_angle_deg.value),
                                 IN_SCENE(friction.test_stress_kpa.value),
                                 IN_SCENE(tilt_angle_deg.value),
                                 IN_TEST(speed_deg_min),
                                 IN_TEST(until_deg),
                                 IN_TEST(tolerance_deg),
                                 IN_TEST(duration_s),
                                 IN_TEST(normal_stiffness_gpa_m),
                                 IN_TEST(shear_stiffness_gpa_m),
                                 IN_TEST(damping),
                                 IN_TEST(rounding),
                                 IN_TEST(time_step_s),
                                 IN_TEST(restitution),
                                 IN_SHAKING(0, peak_g),
                                 IN_SHAKING(0, frequency_hz),
                                 IN_SHAKING(0, scale),
                                 IN_SHAKING(0, column),
                                 IN_SHAKING(1, peak_g),
                                 IN_SHAKING(1, frequency_hz),
                                 IN_SHAKING(1, scale),
                                 IN_SHAKING(1, column)};
static const size_t lines[] = {IN_SCENE(block.outline),    IN_SCENE(base.between),
                               IN_SCENE(base.profile),     IN_SCENE(base.rule.measured),
                               IN_SCENE(mean_plane),       IN_SCENE(shaking[0].record),
                               IN_SCENE(shaking[1].record)};

const tp_offsets tp_scene_numbers = OFFSETS(numbers), tp_scene_lines = OFFSETS(lines);

static const size_t of_part[] = {offsetof(tp_part, unit_weight_kn_m3.value)};
static const size_t of_arc[] = {
    offsetof(tp_arc_description, x.value), offsetof(tp_arc_description, y.value),
    offsetof(tp_arc_description, through_x.value), offsetof(tp_arc_description, through_y.value),
    offsetof(tp_arc_description, bulge.value)};
static const size_t of_corner[] = {offsetof(tp_corner_description, x.value),
                                   offsetof(tp_corner_description, y.value),
                                   offsetof(tp_corner_description, radius.value)};
static const size_t of_line_load[] = {
    offsetof(tp_line_load, x0.value),        offsetof(tp_line_load, y0.value),
    offsetof(tp_line_load, x1.value),        offsetof(tp_line_load, y1.value),
    offsetof(tp_line_load, first_kpa.value), offsetof(tp_line_load, last_kpa.value)};
static const size_t of_anchor[] = {offsetof(tp_anchor_description, x.value),
                                   offsetof(tp_anchor_description, y.value),
                                   offsetof(tp_anchor_description, direction_deg.value),
                                   offsetof(tp_anchor_description, force_kn.value)};

static const size_t of_facets[] = {offsetof(tp_facet_friction_description, x0.value),
                                   offsetof(tp_facet_friction_description, x1.value),
                                   offsetof(tp_facet_friction_description, angle_deg.value)};

static const size_t of_traction[] = {offsetof(tp_traction_description, first_kpa.value),
                                     offsetof(tp_traction_description, last_kpa.value),
                                     offsetof(tp_traction_description, shear_kpa.value)};

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
    [TP_LIST_ANCHORS] = {ITEMS(loads.anchors, loads.anchor_count, tp_anchor_description),
                         .numbers = OFFSETS(of_anchor)},
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
