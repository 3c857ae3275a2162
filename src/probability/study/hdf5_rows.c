/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Derives the CSV beside an HDF5 file, and calls libtopple-hdf5 by dlsym to check and to write
 * it. */

#define _GNU_SOURCE /* asprintf */
#include "study/hdf5_rows.h"

#include "common/library_beside.h"
#include "study/result.h"
#include "study/together.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool is_hdf5(const char *path) {
  const char *ending = path != NULL ? strrchr(path, '.') : NULL;
  return ending != NULL && (strcasecmp(ending, ".h5") == 0 || strcasecmp(ending, ".hdf5") == 0);
}

static tp_status load(tp_hdf5_rows *own, tp_message *message) {
  tp_library_why why = {.text = "it is another library of this name"};
  void *library = tp_library_beside("libtopple-hdf5.so", &why);
  void *check = library != NULL ? dlsym(library, "tp_hdf5_check") : NULL;
  void *write = check != NULL ? dlsym(library, "tp_hdf5_write") : NULL;
  memcpy(&own->check, &check, sizeof check);
  memcpy(&own->write, &write, sizeof write);
  if (write != NULL) return TP_OK;
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){own->path, 0, 0},
                 "HDF5 is written by libtopple-hdf5.so, which does not load (%s); './run --with "
                 "hdf5' in Topple's folder installs HDF5 (libhdf5-dev) and builds it, or name a "
                 "file that ends in .csv",
                 why.text);
}

tp_status tp_hdf5_rows_begin(tp_hdf5_rows *own, tp_study_options *options, const tp_study *study,
                             tp_message *message) {
  *own = (tp_hdf5_rows){.path = NULL};
  if (!is_hdf5(options->rows)) return TP_OK;
  if (options->shards > 1) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){options->rows, 0, 0},
                     "a shard writes CSV, of which HDF5 is made as all are merged; name a file "
                     "that ends in .csv");
  }
  if (asprintf(&own->csv, "%s.csv", options->rows) < 0) {
    own->csv = NULL;
    return tp_fail_memory(message, "the rows");
  }
  own->path = options->rows;
  options->rows = own->csv;
  const tp_status status = load(own, message);
  if (status != TP_OK || !tp_rank_is_first(options->ranks)) return status;
  return own->check(own->path, study, own->csv, options->restart, message);
}

tp_status tp_hdf5_rows_make(const tp_hdf5_rows *own, tp_study_result *result, const tp_study *study,
                            const tp_study_options *options, tp_message *message) {
  if (own->path == NULL) return TP_OK;
  tp_status status = own->write(own->path, study, own->csv, options->ranks, options->stop,
                                options->context, message);
  if (status != TP_OK || result == NULL) return status;
  status = tp_study_add_source(result, own->path, message);
  if (status == TP_OK && options->stop != NULL && options->stop(options->context)) {
    result->end = TP_STUDY_INTERRUPTED;
  }
  return status;
}

void tp_hdf5_rows_end(tp_hdf5_rows *own) {
  free(own->csv);
  own->csv = NULL;
}
