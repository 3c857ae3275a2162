/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What all sheets share on their way into a file. */

#ifndef TP_FIGURE_SHEET_FILE_H
#define TP_FIGURE_SHEET_FILE_H

#include "figure/drawn_page.h"
#include "figure/paper.h"
#include "figure/sheet_name.h"
#include "output/file.h"
#include "report/sheet.h"

/* Bad input where the name is none of a sheet. */
TP_MUST_USE tp_status tp_sheet_check(const char *path, tp_message *message);

/* The files that a scene was read from, none of one built in memory; `paths` is to be freed. */
TP_MUST_USE tp_status tp_sheet_sources(tp_file_sources *sources, const tp_scene *scene,
                                       tp_message *message);

/* The document into the file, not over one of its sources. */
TP_MUST_USE tp_status tp_sheet_write(const char *path, const tp_document *document,
                                     const tp_vector_picture *drawing, tp_file_sources sources,
                                     tp_message *message);

/* A sheet of a scene with one figure, which is drawn on a page. */
typedef struct tp_figured_sheet {
  const char *path;
  const tp_scene *scene;
  bool only_scene; /* the other files that it was read from are told by their hash alone */
  tp_sheet_head head;
  /* The document of `what`; picture and logo are taken over. */
  void (*build)(tp_document *document, const void *what, const tp_sheet_files *files,
                tp_sheet_head *head, tp_picture picture);
  const void *what;
} tp_figured_sheet;

/* Checks the name and makes the head; the logo of that is to be cleared also on failure. Then the
 * document with the page, drawn in the language of the head, into the file. */
TP_MUST_USE tp_status tp_figured_sheet_begin(tp_figured_sheet *sheet,
                                             const tp_sheet_options *options, tp_message *message);
TP_MUST_USE tp_status tp_figured_sheet_write(tp_figured_sheet *sheet, const tp_drawn_page *page,
                                             tp_message *message);

/* A chart as a picture for the file, in the language of its head, and the chart is freed; where
 * `made` is TP_NO_ANSWER there is none. */
TP_MUST_USE tp_status tp_sheet_chart(tp_picture *picture, tp_chart *chart, tp_status made,
                                     const char *path, const tp_sheet_head *head,
                                     tp_message *message);

#endif
