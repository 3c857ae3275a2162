/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What stands at the head of a sheet, and the language it is written in: of the scene, or what the
 * options have instead. */

#ifndef TP_REPORT_SHEET_HEAD_H
#define TP_REPORT_SHEET_HEAD_H

#include "document/logo.h"
#include "scene/letterhead.h"
#include "topple_sheet.h"

typedef struct tp_sheet_head {
  TP_OUTSIDE const char *texts[TP_LETTERHEAD_TEXTS]; /* NULL or empty: none */
  const tp_language *language;
  bool comma;
  tp_logo logo; /* owned until it is given to a document */
} tp_sheet_head;

/* `scene` NULL: only the options say. `paper`: for a PDF, which can hold no SVG as its logo. */
TP_MUST_USE tp_status tp_sheet_head_make(tp_sheet_head *head, const tp_letterhead *scene,
                                         const tp_sheet_options *options, bool paper,
                                         tp_message *message);

#endif
