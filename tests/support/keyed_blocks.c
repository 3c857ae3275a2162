/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of many blocks, with a number for every key that scenes of one block have not. */

#include "keyed_scenes.h"

static void add_box(tp_scene *scene, bool ground, double x0, double y0, double x1, double y1) {
  const double box[] = {x0, y0, x1, y0, x1, y1, x0, y1};
  DO(tp_scene_add_block(scene, tp_coordinates_of(box, 4), NULL, ground, &message));
}

static void build_columns(tp_scene *scene, const double *n) {
  add_box(scene, true, -9, -1, 9, 0);
  add_box(scene, false, 0, 0, 2, 1);
  add_box(scene, false, 2, 0, 3, 5);
  DO(tp_scene_set_unit_weight_kn_m3(scene, E(25), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(31), &message));
  DO(tp_scene_add_joint(scene, 2, 3, &message));
  DO(tp_scene_set_joint_friction_angle_deg(scene, 1, E(n[0]), &message));
  DO(tp_scene_set_joint_cohesion_kpa(scene, 1, E(n[1]), &message));
  DO(tp_scene_set_joint_tension_kpa(scene, 1, E(n[2]), &message));
  DO(tp_scene_add_bolt_to(scene, E(2), E(4), E(n[3]), E(n[4]), E(5), false, &message));
  DO(tp_scene_add_force(scene, E(n[5]), E(n[6]), E(n[7]), E(n[8]), &message));
  DO(tp_scene_set_support(scene, 2, E(n[9]), E(n[10]), &message));
  DO(tp_scene_set_number(scene, "support.direction_deg", E(n[11]), &message));
  DO(tp_scene_set_number(scene, "support.fos", E(n[12]), &message));
}

/* What a file says by these keys is what calls say (input/test_scene_new_loads.c). */
static const keyed_scene columns = {
    build_columns, NULL, {17, 4, 1, 8, -0.5, 0, 0.75, 0, 3, 0, 0.5, 10, 1.25}};

const keyed_row keyed_block_rows[KEYED_BLOCK_ROWS] = {
    {&columns, "joints.1.friction_angle_deg", 'a', 20},
    {&columns, "joints.1.cohesion_kpa", 'b', 2},
    {&columns, "joints.1.tension_kpa", 'c', 0},
    {&columns, "loads.anchors.1.to.1", 'd', 7},
    {&columns, "loads.anchors.1.to.2", 'e', -0.25},
    {&columns, "loads.forces.1.at.1", 'f', 0.25},
    {&columns, "loads.forces.1.at.2", 'g', 0.5},
    {&columns, "loads.forces.1.direction_deg", 'h', 15},
    {&columns, "loads.forces.1.force_kn", 'i', 5},
    {&columns, "support.at.1", 'j', 0.5},
    {&columns, "support.at.2", 'k', 0.25},
    {&columns, "support.direction_deg", 'l', 0},
    {&columns, "support.fos", 'm', 1.5},
};
