/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What kind of file a sheet is to be, by its name. */

#ifndef TP_FIGURE_SHEET_NAME_H
#define TP_FIGURE_SHEET_NAME_H

#include "topple.h"

typedef enum tp_sheet_kind {
  TP_SHEET_UNKNOWN,
  TP_SHEET_HTML,
  TP_SHEET_MARKDOWN,
  TP_SHEET_PDF
} tp_sheet_kind;

tp_sheet_kind tp_sheet_kind_of(const char *path);

#endif
