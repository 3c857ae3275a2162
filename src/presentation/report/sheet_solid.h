/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The calculation sheet of a solid: what it is of, and its sections. */

#ifndef TP_REPORT_SHEET_SOLID_H
#define TP_REPORT_SHEET_SOLID_H

#include "report/sheet.h"

typedef struct tp_solid_sheet {
  tp_document document;
  const tp_scene *scene;
  const tp_solid *solid;
  const tp_sheet_options *options;
} tp_solid_sheet;

/* Bands that page 1 has; --json has all. */
enum { TP_SOLID_SHEET_BANDS = 12 };

/* The whole document of what `sheet` is of. `picture` and the logo of `head` are taken over. */
void tp_sheet_build_solid(tp_document *document, const tp_solid_sheet *sheet,
                          const tp_sheet_files *files, tp_sheet_head *head, tp_picture picture);

/* The first page: what was given, factors, what follows. */
void tp_solid_sheet_add_inputs(tp_solid_sheet *sheet);
void tp_solid_sheet_add_governing(tp_solid_sheet *sheet);
void tp_solid_sheet_add_conclusion(tp_solid_sheet *sheet);

/* The account: of a mesh on a plane, on contacts, or of a wedge; nothing of another. */
void tp_solid_sheet_add_bands(tp_solid_sheet *sheet);
void tp_solid_sheet_add_contacts(tp_solid_sheet *sheet);
void tp_solid_sheet_add_wedge(tp_solid_sheet *sheet);

/* In the appendix: moments, and how the solid can rest. */
void tp_solid_sheet_add_moments(tp_solid_sheet *sheet);
void tp_solid_sheet_add_poses(tp_solid_sheet *sheet);

#endif
