/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The calculation sheet of many blocks: what it is of, and its sections. */

#ifndef TP_REPORT_SHEET_SYSTEM_H
#define TP_REPORT_SHEET_SYSTEM_H

#include "report/sheet.h"
#include "topple_block_system.h"

typedef struct tp_system_sheet {
  tp_document document;
  const tp_scene *scene;
  const tp_block_system *system;
  const tp_sheet_options *options;
} tp_system_sheet;

/* The whole document of what `sheet` is of. `picture` and the logo of `head` are taken over. */
void tp_sheet_build_system(tp_document *document, const tp_system_sheet *sheet,
                           const tp_sheet_files *files, tp_sheet_head *head, tp_picture picture);

/* The first page: what was given, the factors of each direction, what follows. */
void tp_system_sheet_add_inputs(tp_system_sheet *sheet);
void tp_system_sheet_add_governing(tp_system_sheet *sheet);
void tp_system_sheet_add_conclusion(tp_system_sheet *sheet, const tp_system_case *own);

/* Sentences on the estimates of a direction, behind a text; nothing where there are none. */
void tp_system_sheet_add_estimate(tp_text *text, const tp_system_sheet *sheet,
                                  const tp_system_case *one);

/* Of a direction, nothing where there is none: loads besides weights, and the support that is asked
 * for. */
void tp_system_sheet_add_loads(tp_system_sheet *sheet, const tp_system_case *own);
void tp_system_sheet_add_support(tp_system_sheet *sheet, const tp_system_case *own);

/* Of a direction: how the blocks begin to move, the forces before that, columns by Goodman and
 * Bray; nothing where there is none. */
void tp_system_sheet_add_motions(tp_system_sheet *sheet, const tp_system_case *own);
void tp_system_sheet_add_forces(tp_system_sheet *sheet, const tp_system_case *own);
void tp_system_sheet_add_columns(tp_system_sheet *sheet, const tp_system_case *own);

/* A cell with the factor by Goodman and Bray, if there is one. */
void tp_system_sheet_add_goodman_bray(tp_document *document, const tp_goodman_bray *own);

/* In the appendix. */
void tp_system_sheet_add_blocks(tp_system_sheet *sheet);
void tp_system_sheet_add_contacts(tp_system_sheet *sheet);

#endif
