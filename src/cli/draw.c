/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Figures: Cairo is loaded when one is asked for, not at every start. */

#include "cli/cli.h"

#include <dlfcn.h>
#include <stdio.h>

#define LIBRARY "libtopple-figure.so"

typedef tp_status (*draw_function)(const char *path, const tp_scene *scene,
                                   const tp_solution *solution, tp_message *message);

tp_status tp_cli_draw(const char *path, const tp_scene *scene, const tp_solution *solution,
                      tp_message *message) {
  /* stays loaded: Fontconfig keeps what it knows until the process ends */
  void *library = dlopen(LIBRARY, RTLD_NOW);
  draw_function draw = NULL;
  if (library != NULL) *(void **)&draw = dlsym(library, "tp_report_figure");
  if (draw != NULL) return draw(path, scene, solution, message);
  const char *why = dlerror();
  snprintf(message->text, sizeof message->text,
           "figures are drawn by " LIBRARY ", which does not load (%s); install it beside Topple's "
           "other files",
           why != NULL ? why : "no reason is given");
  return TP_DEPENDENCY_FAILED;
}
