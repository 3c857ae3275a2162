/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks built in memory, with all that they can have which one block has not. */

#include "sayings.h"

#define E(number) tp_exact_of(number)
#define T(text) tp_exact_text(text)
#define SAY(call) note_status(s, call, &message)

void say_built_blocks(sayings *s) {
  static const double ground[] = {-9.5, -1, 9, -1, 9, 0, -9.5, 0}, low[] = {0, 0, 2, 0, 2, 1, 0, 1},
                      hole[] = {0.5, 0.25, 1, 0.25, 1, 0.75};
  static const char *const column[] = {"2", "0", "3", "0", "3", "10/2", "2", "5.0"};
  static const char *const part[] = {"2.25", "1", "2.75", "1", "2.5", "2"};
  const tp_solve_options options = tp_solve_options_default();
  tp_message message = {.text = ""};
  tp_block_system *system = NULL;
  tp_scene *scene = NULL;
  SAY(tp_scene_new(&scene, "m", &message));
  if (scene == NULL) return;
  SAY(tp_scene_add_block(scene, tp_coordinates_of(ground, 4), "ground", true, &message));
  SAY(tp_scene_add_block(scene, tp_coordinates_of(low, 4), NULL, false, &message));
  SAY(tp_scene_add_block(scene, tp_coordinates_text(column, 4), "1,5 m", false, &message));
  SAY(tp_scene_set_unit_weight_kn_m3(scene, E(25.5), &message));
  SAY(tp_scene_set_friction_angle_deg(scene, T("100/3"), &message));
  SAY(tp_scene_set_tilt_towards(scene, true, false, &message));
  SAY(tp_scene_set_block_unit_weight_kn_m3(scene, 2, T("20.5"), &message));
  SAY(tp_scene_add_block_hole(scene, 2, tp_coordinates_of(hole, 3), &message));
  SAY(tp_scene_add_block_part(scene, 3, tp_coordinates_text(part, 3), T("19.5"), &message));
  SAY(tp_scene_add_joint(scene, 2, 3, &message));
  SAY(tp_scene_set_joint_friction_angle_deg(scene, 1, E(17.5), &message));
  SAY(tp_scene_set_joint_cohesion_kpa(scene, 1, T("4.5"), &message));
  SAY(tp_scene_set_joint_tension_kpa(scene, 1, E(1.5), &message));
  SAY(tp_scene_add_bolt_to(scene, E(2), T("3.9"), E(8), E(-0.5), T("30.5"), false, &message));
  SAY(tp_scene_add_bolt(scene, E(0), T("0.5"), E(20.5), E(5), true, &message));
  SAY(tp_scene_set_bolt_into(scene, 2, 1, &message));
  SAY(tp_scene_add_force(scene, E(0), T("0.75"), E(1.5), T("3.5"), &message));
  SAY(tp_scene_set_load_block(scene, TP_PLACED_FORCE, 1, 2, &message));
  SAY(tp_scene_set_support(scene, 2, E(0), T("0.5"), &message));
  SAY(tp_scene_set_number(scene, "support.fos", T("1.25"), &message));
  SAY(tp_solve_block_system(&system, scene, &options, &message));
  if (system != NULL && tp_report_block_system_json(next_saying(s), system) != TP_OK) s->count--;
  tp_block_system_free(system);
  tp_scene_free(scene);
}
