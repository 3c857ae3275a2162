/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Before the run, so that hours are not in vain: what is there under the name of an HDF5 file, and
 * beside it. */

#include "common/host.h"
#include "hdf5/file.h"
#include "hdf5/hdf5.h"
#include "study/progress.h"
#include "study/sources.h"

#include <sys/stat.h>

tp_status tp_hdf5_check(const char *path, const tp_study *study, const char *csv, bool restart,
                        tp_message *message) {
  TP_GUARD_HOST;
  const tp_place place = {path, 0, 0};
  struct stat own;
  tp_progress progress = {0};
  bool there = false;
  /* nobody named the CSV */
  if (lstat(csv, &own) == 0 && S_ISLNK(own.st_mode)) {
    return tp_refuse(
        message, TP_FAULT_ARGUMENT, (tp_place){csv, 0, 0},
        "this is a link, into which the rows would go first; remove it, or name another "
        "file");
  }
  if (stat(path, &own) != 0) {
    if (lstat(path, &own) != 0) return TP_OK;
    return tp_fail(message, TP_SYSTEM_FAILED, place,
                   "cannot be written: it is a link that leads nowhere");
  }
  if (!S_ISREG(own.st_mode)) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, place,
                     "HDF5 needs a separate file; name another one");
  }
  if (tp_study_reads(study, &own)) {
    return tp_refuse(
        message, TP_FAULT_ARGUMENT, place,
        "this is a file that the study reads, and would be lost; write to another name");
  }
  if (restart) {
    if (tp_hdf5_file_is_ours(path)) return TP_OK;
    return tp_refuse(message, TP_FAULT_ARGUMENT, place,
                     "this file is there, and is not the rows of a study, the only files that are "
                     "written over; remove it, or name another file");
  }
  const tp_status status = tp_progress_read(&progress, &there, csv, study, message);
  if (status != TP_OK || there) return status;
  return tp_refuse(
      message, TP_FAULT_ARGUMENT, place,
      "this file is there, and no '%.300s' to continue from; restart to write over it, or "
      "name another file",
      csv);
}
