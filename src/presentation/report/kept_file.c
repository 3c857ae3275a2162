/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes a report to a file that is none of those that its scene was read from. */

#include "report/kept_file.h"

#include "common/message.h"
#include "output/file.h"

#include <stdlib.h>

tp_status tp_report_keep_file(const tp_scene *scene, const char *path, const char *data,
                              size_t length, const char *what, tp_message *message) {
  const size_t count = tp_scene_source_count(scene);
  const char **paths = calloc(count + 1, sizeof *paths);
  if (paths == NULL) return tp_fail_memory(message, what);
  for (size_t k = 0; k < count; k++) paths[k] = tp_scene_source(scene, k);
  const tp_file_sources sources = {count, paths};
  const tp_status status = tp_file_write(path, data, length, sources, message);
  free(paths);
  return status;
}
