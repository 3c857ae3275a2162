/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls on solids say: of a block that stands, and of a file that is no solid. */

#include "sayings.h"

#define EXAMPLE(name) TP_EXAMPLES "/" name

void say_solids(sayings *s) {
  static const char *const files[] = {EXAMPLE("meshes/balanced_rock.obj"),
                                      EXAMPLE("meshes/hollow_block.obj")};
  for (size_t k = 0; k < 2; k++) {
    tp_solid *solid = NULL;
    tp_message message = {.text = ""};
    tp_solid_options options = tp_solid_options_default();
    options.friction_angle_deg = 30.5;
    options.unit_weight_kn_m3 = 26.5;
    note_status(s, tp_solid_of_file(&solid, files[k], &options, &message), &message);
    if (solid == NULL) continue;
    if (tp_report_solid(next_saying(s), solid) != TP_OK) s->count--;
    if (tp_report_solid_json(next_saying(s), solid) != TP_OK) s->count--;
    if (tp_report_solid_csv(next_saying(s), solid) != TP_OK) s->count--;
    tp_solid_free(solid);
  }
}
