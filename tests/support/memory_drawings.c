/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_drawings.h"

#include "memory_expect.h"

#include <stdlib.h>
#include <string.h>

static void read_drawing(const char *path, const char *setting) {
  tp_scene *scene = NULL, *varied = NULL;
  char *text = NULL;
  tp_message message = {.text = ""};
  tp_status status = tp_scene_read_with(&scene, path, "", &setting, 1, &message);
  /* without dxflib, RapidJSON or expat */
  if (status == TP_BAD_INPUT && strstr(message.text, "was built without") != NULL) return;
  if (done(status, scene, &message)) {
    status = tp_report_drawing(&text, scene);
    expect_report(status, text);
    status = tp_scene_with(&varied, scene, "friction_angle_deg", tp_exact_of(31), &message);
    (void)done(status, varied, &message);
  }
  tp_scene_free(varied);
  tp_scene_free(scene);
}

void read_drawings(void) {
  read_drawing(EXAMPLE("section_arcs.dxf"), "friction_angle_deg=30");
  read_drawing(EXAMPLE("boulder_traced.yaml"), "drawing.reference.length=1.5");
  read_drawing(EXAMPLE("block_with_seam.yaml"), "friction_angle_deg=30");
  read_drawing(EXAMPLE("block_e_wkt.yaml"), "friction_angle_deg=30");
}
