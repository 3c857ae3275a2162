/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Derives the CSV beside an HDF5 file, and calls libtopple-hdf5 by dlsym to check and to write
 * it. */

#define _GNU_SOURCE /* asprintf */
#include "cli/study_rows.h"

#include "cli/library.h"
#include "cli/signals.h"
#include "cli/words.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* Those of src/applications/hdf5/hdf5.h. */
typedef bool stop_function(void);
typedef tp_status (*check_function)(const char *path, const tp_study *study, const char *csv,
                                    bool restart, tp_message *message);
typedef tp_status (*write_function)(const char *path, const tp_study *study, const char *csv,
                                    stop_function *stop, tp_message *message);

bool tp_cli_study_file_name(tp_study_file *file, const char *path) {
  const char *ending = strrchr(path, '.');
  *file = (tp_study_file){.hdf5 = NULL};
  if (ending == NULL || (strcasecmp(ending, ".h5") != 0 && strcasecmp(ending, ".hdf5") != 0)) {
    return true;
  }
  file->hdf5 = path;
  if (asprintf(&file->csv, "%s.csv", path) >= 0) return true;
  file->csv = NULL;
  return false;
}

/* One of its functions, into `*function`. */
static tp_status load(void **function, const char *name, tp_message *message) {
  void *library = tp_cli_load_library(TP_HDF5_LIBRARY);
  *function = library != NULL ? dlsym(library, name) : NULL;
  if (*function != NULL) return TP_OK;
  const char *why = dlerror();
  snprintf(message->text, sizeof message->text,
           "HDF5 is written by " TP_HDF5_LIBRARY
           ", which does not load (%s); './run --with hdf5' in Topple's folder installs HDF5 "
           "(libhdf5-dev) and builds "
           "it, or name a file that ends in .csv",
           why != NULL ? why : "no reason is given");
  return TP_DEPENDENCY_FAILED;
}

tp_status tp_cli_study_file_check(const tp_study_file *file, const tp_study *study, bool restart,
                                  tp_message *message) {
  check_function check = NULL;
  if (file->hdf5 == NULL) return TP_OK;
  const tp_status status = load((void **)&check, "tp_hdf5_check", message);
  return status == TP_OK ? check(file->hdf5, study, file->csv, restart, message) : status;
}

static bool is_interrupted(void) {
  return tp_cli_signal() != 0;
}

tp_status tp_cli_study_file_write(const tp_study_file *file, const tp_study *study,
                                  const tp_study_result *result, tp_message *message) {
  write_function write = NULL;
  if (file->hdf5 == NULL) return TP_OK;
  tp_status status = TP_OK;
  if (result->end != TP_STUDY_INTERRUPTED) {
    status = load((void **)&write, "tp_hdf5_write", message);
    if (status == TP_OK) status = write(file->hdf5, study, file->csv, is_interrupted, message);
  }
  if (status == TP_OK && is_interrupted()) {
    tp_cli_complain("interrupted: the rows so far are in '%s', and '%s' is made from them once "
                    "the same command has been run to the end",
                    file->csv, file->hdf5);
  }
  return status;
}
