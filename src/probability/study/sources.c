/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Access to the list of source files by number, and the comparison of a file with all of them by
 * device and inode. */

#include "study/sources.h"

size_t tp_study_source_count(const tp_study *study) {
  size_t count = 1 + tp_scene_source_count(study->scene);
  for (size_t k = 0; k < study->variable_count; k++) count += study->variables[k].file != NULL;
  return count;
}

const char *tp_study_source(const tp_study *study, size_t k) {
  const size_t of_scene = tp_scene_source_count(study->scene);
  if (k == 0) return study->path;
  if (k - 1 < of_scene) return tp_scene_source(study->scene, k - 1);
  size_t left = k - 1 - of_scene, variable = 0;
  while (study->variables[variable].file == NULL || left-- > 0) variable++;
  return study->variables[variable].file;
}

bool tp_study_reads(const tp_study *study, const struct stat *file) {
  struct stat own;
  const size_t count = tp_study_source_count(study);
  for (size_t k = 0; k < count; k++) {
    if (stat(tp_study_source(study, k), &own) == 0 && own.st_dev == file->st_dev &&
        own.st_ino == file->st_ino) {
      return true;
    }
  }
  return false;
}
