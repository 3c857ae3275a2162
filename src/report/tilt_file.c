/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "host.h"
#include "output/file.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

tp_status tp_report_tilt_file(const tp_tilt_test *test, const char *path, bool moving,
                              tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, test);
  TP_REFUSE_NULL(message, path);
  const char *ending = strrchr(path, '.');
  if (ending == NULL || strcasecmp(ending, ".svg") != 0) {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){path, 0, 0},
                   "drawings of a tilt test are SVG: give a name that ends in .svg");
  }
  char *text = NULL;
  tp_status status =
      moving ? tp_report_tilt_animation(&text, test) : tp_report_tilt_frames(&text, test);
  if (status == TP_OUT_OF_MEMORY) return tp_fail_memory(message, "the drawing");
  if (status == TP_OK) {
    status = tp_file_write(path, text, strlen(text), (tp_file_sources){0, NULL}, message);
  }
  free(text);
  return status;
}
