/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Figures: Cairo is loaded when one is asked for, not at every start. */

#include "cli/cli.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define LIBRARY "libtopple-figure.so"

typedef tp_status (*draw_function)(const char *path, const tp_scene *scene,
                                   const tp_solution *solution, tp_message *message);

/* Beside the program, as it is built; else where it is installed. It stays loaded: Fontconfig keeps
 * what it knows until the process ends. */
static void *load_library(void) {
  char path[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path - sizeof LIBRARY - 1);
  if (length > 0) {
    path[length] = '\0';
    char *slash = strrchr(path, '/');
    if (slash != NULL) strcpy(slash + 1, LIBRARY);
    if (slash != NULL && access(path, R_OK) == 0) return dlopen(path, RTLD_NOW);
  }
  return dlopen(TP_LIBRARY_FOLDER "/" LIBRARY, RTLD_NOW);
}

tp_status tp_cli_draw(const char *path, const tp_scene *scene, const tp_solution *solution,
                      tp_message *message) {
  void *library = load_library();
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
