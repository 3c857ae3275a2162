/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls libtopple-xlsx by dlsym, to read and to write worksheets. */

#include "cli/batch_xlsx.h"

#include "cli/library.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

typedef tp_status (*read_function)(char **csv, const char *path, tp_message *message);
typedef tp_status (*write_function)(const char *path, const tp_batch *batch, tp_message *message);

bool tp_cli_is_xlsx(const char *path) {
  const char *ending = strrchr(path, '.');
  return ending != NULL && strcasecmp(ending, ".xlsx") == 0;
}

/* One of its functions, into `*function`. */
static tp_status load(void **function, const char *name, tp_message *message) {
  tp_cli_why why;
  *function = tp_cli_load_call(TP_XLSX_LIBRARY, name, &why);
  if (*function != NULL) return TP_OK;
  snprintf(message->text, sizeof message->text,
           "worksheets are read and written by " TP_XLSX_LIBRARY
           ", which does not load (%s); './run --with xlsx' in Topple's folder installs libzip and "
           "libxlsxwriter (libzip-dev, libxlsxwriter-dev) and builds it, or use files that end in "
           ".csv",
           why.text);
  return TP_DEPENDENCY_FAILED;
}

tp_status tp_cli_may_write_xlsx(tp_message *message) {
  void *write = NULL;
  return load(&write, "tp_xlsx_write", message);
}

tp_status tp_cli_read_xlsx(char **csv, const char *path, tp_message *message) {
  read_function read = NULL;
  const tp_status status = load((void **)&read, "tp_xlsx_read", message);
  return status == TP_OK ? read(csv, path, message) : status;
}

tp_status tp_cli_write_xlsx(const char *path, const tp_batch *batch, tp_message *message) {
  write_function write = NULL;
  const tp_status status = load((void **)&write, "tp_xlsx_write", message);
  return status == TP_OK ? write(path, batch, message) : status;
}
