/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads each source file again, checks that its hash is that of the study, and stores path and text
 * as attributes. */

#include "hdf5/texts.h"

#include "common/input_file.h"
#include "output/text.h"
#include "study/hash.h"
#include "study/sources.h"

#include <errno.h>
#include <stdio.h>

static tp_status read_text(tp_text *text, const char *path, tp_message *message) {
  char bytes[1 << 14];
  size_t count = 0;
  FILE *file = NULL;
  const tp_status status = tp_input_open(&file, path, message);
  if (status != TP_OK) return status;
  while ((count = fread(bytes, 1, sizeof bytes, file)) > 0) tp_text_append(text, bytes, count);
  const int problem = ferror(file) != 0 ? errno : 0;
  fclose(file);
  if (problem != 0) return tp_fail_file(message, path, "read", problem);
  return text->failed ? tp_fail_memory(message, "the files of a study") : TP_OK;
}

/* The k-th file; the group of those that the study and its scene name is made by the first. */
static bool note(const tp_hdf5_file *file, hid_t *group, const char *path, size_t k,
                 const char *text) {
  static const char *const names[] = {"study", "scene"}, *const files[] = {"study_file",
                                                                           "scene_file"};
  if (k < 2) {
    return tp_hdf5_note_text(file->id, files[k], path) &&
           tp_hdf5_note_text(file->id, names[k], text);
  }
  if (*group < 0) {
    *group = H5Gcreate2(file->id, "files", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  }
  /* several numbers may be of one file */
  return *group >= 0 && (H5Aexists(*group, path) > 0 || tp_hdf5_note_text(*group, path, text));
}

static tp_status note_all(const tp_hdf5_file *file, hid_t *group, const tp_study *study,
                          tp_message *message) {
  const size_t count = tp_study_source_count(study);
  uint64_t hash = TP_HASH_START;
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    tp_text text = {0};
    const char *path = tp_study_source(study, k);
    status = read_text(&text, path, message);
    const uint64_t length = text.length;
    hash = tp_hash_bytes(hash, text.data, text.length);
    hash = tp_hash_bytes(hash, &length, sizeof length);
    if (status == TP_OK && !note(file, group, path, k, text.data != NULL ? text.data : "")) {
      status = tp_hdf5_fail(file, message);
    }
    tp_text_drop(&text);
  }
  if (status != TP_OK || hash == study->hash) return status;
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){study->path, 0, 0},
                   "the study, its scene or a file that they name has changed since it was read; "
                   "restart, or name another file");
}

tp_status tp_hdf5_note_texts(const tp_hdf5_file *file, const tp_study *study, tp_message *message) {
  hid_t group = H5I_INVALID_HID;
  const tp_status status = note_all(file, &group, study, message);
  if (group >= 0) (void)H5Gclose(group);
  return status;
}
