/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calculation sheets: a solution as a page that an engineer checks and signs (docs/report.md).
 * Included by topple.h; these calls are in the library topple-figure, which draws the figures. */

#ifndef TOPPLE_SHEET_H
#define TOPPLE_SHEET_H

#include "topple_block_system.h"
#include "topple_load_cases.h"
#include "topple_solid.h"
#include "topple_solve.h"
#include "topple_study.h"
#include "topple_tilt_test.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a sheet states besides results. */
typedef struct tp_sheet_options {
  size_t size;      /* of this struct, as `…_default()` has it */
  const char *date; /* when it was made, as it is to be printed; NULL: it has none */
  int times;        /* not 0: how long each effect took, which no two runs have alike */
  int lines;        /* of each file that the scene was read from, at most; 0: none */
  /* Each instead of what the scene says under `report`; NULL: what that says. The call takes
   * copies. */
  const char *language; /* en, es or de */
  const char *decimal;  /* point or comma, before decimals */
  const char *company, *project, *job, *author, *checker, *issued; /* of the letterhead; an empty
                                                                      text: none */
  const char *logo; /* path of a PNG, JPEG or SVG file, which a PDF cannot have */
  /* Of the sheet of a solution: the load cases of its scene, of which it is that of the first;
   * NULL: none. The first page has a row for each. */
  const tp_load_cases *load_cases;
} tp_sheet_options;

/* The defaults: no date, times, 400 lines of each file. `size` is that of the struct as the caller
 * knows it. */
void tp_sheet_options_init(tp_sheet_options *options, size_t size);
static inline tp_sheet_options tp_sheet_options_default(void) {
  tp_sheet_options options;
  tp_sheet_options_init(&options, sizeof options);
  return options;
}

/* Does the name end in .html, .htm, .md or .pdf, the kinds of file that a sheet can be? */
bool tp_sheet_is_file_name(const char *path);

/* The languages that a sheet can be in, as "en, es, de", and is the code one? */
const char *tp_sheet_languages(void);
bool tp_sheet_is_language(const char *code);

/* The solution of the scene as a sheet, into the file `path` of the kind that its ending names: one
 * file that needs no other. The scene is as it was when it was solved; the files that it was read
 * from are read once more, to be shown and named by their SHA-256. It has the account by elements
 * where the solution has. A file of that name is replaced, and stays as it was where the call
 * fails; one that the scene was read from is bad input. Without a date and times the same solution
 * gives the same bytes. TP_SYSTEM_FAILED where a file cannot be read or written;
 * TP_DEPENDENCY_FAILED where Cairo fails. */
TP_MUST_USE tp_status tp_report_sheet(const char *path, const tp_scene *scene,
                                      const tp_solution *solution, const tp_sheet_options *options,
                                      tp_message *message);

/* The result of a scene of many blocks likewise, with its figure; of the options `load_cases` does
 * not count. */
TP_MUST_USE tp_status tp_report_sheet_block_system(const char *path, const tp_scene *scene,
                                                   const tp_block_system *system,
                                                   const tp_sheet_options *options,
                                                   tp_message *message);

/* The solid of a scene likewise, whose mesh is named by its hash alone. */
TP_MUST_USE tp_status tp_report_sheet_solid(const char *path, const tp_scene *scene,
                                            const tp_solid *solid, const tp_sheet_options *options,
                                            tp_message *message);

/* The result of the study likewise, with its charts, drawn by gnuplot: of probability against tilt
 * and so on, and of each sample's angle. */
TP_MUST_USE tp_status tp_report_sheet_study(const char *path, const tp_study *study,
                                            const tp_study_result *result,
                                            const tp_sheet_options *options, tp_message *message);

/* The tilt test of the scene likewise, with the block at some moments, and charts of its reactions
 * and of its motion. */
TP_MUST_USE tp_status tp_report_sheet_tilt(const char *path, const tp_scene *scene,
                                           const tp_tilt_test *test,
                                           const tp_sheet_options *options, tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
