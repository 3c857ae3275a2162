/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The version of libtopple as the loader finds it for the whole process, by dlsym, beside that
 * which is linked in here. */

#define _GNU_SOURCE /* RTLD_DEFAULT */
#include "figure/version.h"

#include "topple_figure.h"

#include <dlfcn.h>
#include <string.h>

const char *tp_figure_version(void) {
  return TP_VERSION;
}

tp_status tp_figure_check_version(tp_message *message) {
  const char *(*version)(void) = NULL;
  *(void **)&version = dlsym(RTLD_DEFAULT, "tp_version");
  if (version == NULL || strcmp(version(), TP_VERSION) == 0) return TP_OK;
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){"libtopple-figure", 0, 0},
                 "its version is " TP_VERSION
                 ", and that of libtopple %.40s: install both of the same version",
                 version());
}
