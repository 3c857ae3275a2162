/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Creates the file under a temporary name with reproducible properties, collects HDF5's error stack
 * as one reason, and renames the file when it is complete. */

#include "hdf5/file.h"

#include "output/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- what went wrong ---------------------------------------------------------------------------
 */

/* From the innermost on: the words of the system where they are told, else of HDF5. */
static herr_t take_reason(unsigned level, const H5E_error2_t *error, void *context) {
  static const char begins[] = "error message = '";
  tp_hdf5_file *file = context;
  const char *system = error->desc != NULL ? strstr(error->desc, begins) : NULL;
  if (system != NULL) {
    system += strlen(begins);
    snprintf(file->reason, sizeof file->reason, "%.*s", (int)strcspn(system, "'"), system);
  } else if (level == 0 && error->desc != NULL) {
    snprintf(file->reason, sizeof file->reason, "%s", error->desc);
  }
  return 0;
}

/* Called by HDF5 where a call fails, instead of printing: later calls forget why. */
static herr_t note_failure(hid_t stack, void *context) {
  const tp_hdf5_file *file = context;
  return file->reason[0] == '\0' ? H5Ewalk2(stack, H5E_WALK_UPWARD, take_reason, context) : 0;
}

tp_status tp_hdf5_fail(const tp_hdf5_file *file, tp_message *message) {
  return tp_fail(
      message, TP_SYSTEM_FAILED, (tp_place){file->path, 0, 0},
      "cannot be written: %s; the rows stay in '%.300s', and the same command makes this "
      "file of them",
      file->reason[0] != '\0' ? file->reason : "memory is exhausted", file->csv);
}

static tp_status fail_system(const tp_hdf5_file *file, int why, tp_message *message) {
  return tp_fail(
      message, TP_SYSTEM_FAILED, (tp_place){file->path, 0, 0},
      "cannot be written: %s; the rows stay in '%.300s', and the same command makes this "
      "file of them",
      strerror(why), file->csv);
}

/* ---- the file ----------------------------------------------------------------------------------
 */

/* The same rows give the same bytes, whenever; columns stay in their order. */
static hid_t create(const char *path, hid_t access) {
  const hid_t plan = H5Pcreate(H5P_FILE_CREATE);
  hid_t file = H5I_INVALID_HID;
  if (plan < 0) return plan;
  if (H5Pset_link_creation_order(plan, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED) >= 0 &&
      H5Pset_obj_track_times(plan, false) >= 0) {
    file = H5Fcreate(path, H5F_ACC_TRUNC, plan, access);
  }
  (void)H5Pclose(plan);
  return file;
}

bool tp_hdf5_file_is_ours(const char *path) {
  (void)H5dont_atexit();
  (void)H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
  const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file < 0) return false;
  const bool ours = H5Aexists(file, "topple") > 0 && H5Aexists(file, "planned") > 0;
  (void)H5Fclose(file);
  return ours;
}

static void begin(tp_hdf5_file *file, const char *path, const char *csv) {
  *file = (tp_hdf5_file){.path = path, .csv = csv, .id = H5I_INVALID_HID};
  /* what could not be written is not tried again as the program ends */
  (void)H5dont_atexit();
  (void)H5Eset_auto2(H5E_DEFAULT, note_failure, file);
}

tp_status tp_hdf5_file_begin(tp_hdf5_file *file, const char *path, const char *csv,
                             tp_message *message) {
  begin(file, path, csv);
  file->target = realpath(path, NULL);
  if (file->target == NULL && errno == ENOENT) file->target = strdup(path);
  if (file->target == NULL) return fail_system(file, errno, message);
  const int own = tp_file_create_beside(&file->part, file->target);
  if (own < 0) return fail_system(file, errno, message);
  (void)close(own);
  file->id = create(file->part, H5P_DEFAULT);
  return file->id >= 0 ? TP_OK : tp_hdf5_fail(file, message);
}

tp_status tp_hdf5_file_begin_in_memory(tp_hdf5_file *file, const char *path, const char *csv,
                                       tp_message *message) {
  enum { INCREMENT = 1 << 20 };
  begin(file, path, csv);
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  if (access >= 0 && H5Pset_fapl_core(access, INCREMENT, false) >= 0)
    file->id = create(path, access);
  if (access >= 0) (void)H5Pclose(access);
  return file->id >= 0 ? TP_OK : tp_hdf5_fail(file, message);
}

static tp_status put_in_place(const tp_hdf5_file *file, tp_message *message) {
  struct stat before;
  if (stat(file->target, &before) == 0) (void)chmod(file->part, before.st_mode & 07777);
  return rename(file->part, file->target) == 0 ? TP_OK : fail_system(file, errno, message);
}

tp_status tp_hdf5_file_end(tp_hdf5_file *file, tp_status status, bool whole, tp_message *message) {
  if (file->id >= 0) {
    const bool kept = H5Fflush(file->id, H5F_SCOPE_GLOBAL) >= 0;
    if (status == TP_OK && !kept) status = tp_hdf5_fail(file, message);
    if (H5Fclose(file->id) < 0 && status == TP_OK) status = tp_hdf5_fail(file, message);
  }
  if (status == TP_OK && whole) status = put_in_place(file, message);
  if (file->part != NULL && (status != TP_OK || !whole)) (void)unlink(file->part);
  (void)H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
  free(file->part);
  free(file->target);
  return status;
}

/* ---- attributes --------------------------------------------------------------------------------
 */

static bool note(hid_t object, const char *name, hid_t type, const void *value) {
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t own = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  const bool noted = own >= 0 && H5Awrite(own, type, value) >= 0;
  if (own >= 0) (void)H5Aclose(own);
  if (space >= 0) (void)H5Sclose(space);
  return noted;
}

bool tp_hdf5_note_text(hid_t object, const char *name, const char *text) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  const bool noted = H5Tset_size(type, H5T_VARIABLE) >= 0 &&
                     H5Tset_cset(type, H5T_CSET_UTF8) >= 0 && note(object, name, type, &text);
  if (type >= 0) (void)H5Tclose(type);
  return noted;
}

bool tp_hdf5_note_count(hid_t object, const char *name, uint64_t count) {
  return note(object, name, H5T_NATIVE_UINT64, &count);
}
