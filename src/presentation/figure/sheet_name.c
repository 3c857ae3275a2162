/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Kind of a sheet by the ending of its file name, case ignored: HTML, PDF or Markdown. */

#include "figure/sheet_name.h"

#include <string.h>
#include <strings.h>

tp_sheet_kind tp_sheet_kind_of(const char *path) {
  const char *ending = strrchr(path, '.');
  if (ending == NULL || ending == path || ending[-1] == '/') return TP_SHEET_UNKNOWN;
  if (strcasecmp(ending, ".html") == 0 || strcasecmp(ending, ".htm") == 0) return TP_SHEET_HTML;
  if (strcasecmp(ending, ".pdf") == 0) return TP_SHEET_PDF;
  return strcasecmp(ending, ".md") == 0 ? TP_SHEET_MARKDOWN : TP_SHEET_UNKNOWN;
}

bool tp_sheet_is_file_name(const char *path) {
  return path != NULL && tp_sheet_kind_of(path) != TP_SHEET_UNKNOWN;
}
