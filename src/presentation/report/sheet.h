/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution as a calculation sheet: a document (document.h) that a reviewer can repeat by hand.
 * Every number on it is one of the solution, printed with certain digits alone; every formula has
 * its numbers put in, as they stand elsewhere on the sheet. */

#ifndef TP_REPORT_SHEET_H
#define TP_REPORT_SHEET_H

#include "document/document.h"
#include "report/page.h"
#include "report/settings.h"
#include "report/sheet_head.h"
#include "scene/scene.h"
#include "topple_sheet.h"

typedef struct tp_sheet {
  tp_document document;
  const tp_scene *scene;
  const tp_solution *solution;
  const tp_sheet_options *options;
  const tp_sheet_head *head;
} tp_sheet;

/* A file that a sheet rests on: as it is when the sheet is made. */
typedef struct tp_sheet_file {
  const char *path;
  int why;     /* not 0: it cannot be read, for this reason (errno) */
  char *bytes; /* with a zero behind them */
  size_t length;
} tp_sheet_file;

typedef struct tp_sheet_files {
  size_t count;
  tp_sheet_file *items;
  const char *logo; /* the path of the one that is told by its hash alone; NULL: none */
  bool only_scene;  /* so are all but the first: meshes */
} tp_sheet_files;

TP_MUST_USE tp_status tp_sheet_files_read(tp_sheet_files *files, const char *const *paths,
                                          size_t count, tp_message *message);
void tp_sheet_files_clear(tp_sheet_files *files);

/* The whole document of a solution. `picture` and the logo of `head` are taken over. */
void tp_sheet_build(tp_document *document, const tp_scene *scene, const tp_solution *solution,
                    const tp_sheet_files *files, const tp_sheet_options *options,
                    tp_sheet_head *head, tp_picture picture);

/* A picture with its words, taken over; one that is none is no figure. */
typedef struct tp_sheet_picture {
  tp_picture picture;
  const char *caption, *alternative;
} tp_sheet_picture;

/* Those of a study and of a tilt test, with `count` charts. */
void tp_sheet_build_study(tp_document *document, const tp_study_result *result,
                          const tp_sheet_files *files, const tp_sheet_options *options,
                          tp_sheet_head *head, const tp_sheet_picture *charts, size_t count);
void tp_sheet_build_tilt(tp_document *document, const tp_tilt_test *test,
                         const tp_sheet_files *files, const tp_sheet_options *options,
                         tp_sheet_head *head, tp_picture frames, const tp_sheet_picture *charts,
                         size_t count);

/* What a study found besides its samples; nothing where nothing was asked for. */
void tp_sheet_add_analyses(tp_document *document, const tp_study_result *result);

/* A heading, and the figures below it; nothing where there are none. */
void tp_sheet_add_charts(tp_document *document, const tp_sheet_picture *charts, size_t count);

/* ---- its sections ------------------------------------------------------------------------------
 */

/* Company and logo, which is taken over. */
void tp_sheet_set_letterhead(tp_document *document, tp_sheet_head *head);

/* The title, or words that stand for it where there is none to be seen. */
void tp_sheet_add_title(tp_document *document, const char *title, const char *otherwise);

/* Lines of the page for a terminal, which are taken over, without the empty ones before them. */
void tp_sheet_take_lines(tp_document *document, tp_text *lines);
/* Program, date, files with their hashes: what the sheet is of. */
void tp_sheet_add_origin(tp_document *document, const tp_sheet_files *files,
                         const tp_sheet_options *options);
/* The files themselves, and who has checked what. */
void tp_sheet_add_files(tp_document *document, const tp_sheet_files *files,
                        const tp_sheet_options *options);
void tp_sheet_add_signatures(tp_document *document, const tp_sheet_head *head);
/* Below each page on paper. */
void tp_sheet_add_foot(tp_document *document, const tp_sheet_files *files,
                       const tp_sheet_options *options);
/* What was noted of the input; nothing where there is nothing. How many cautions there are, as a
 * phrase that says where they stand. */
void tp_sheet_add_notes(tp_document *document, const tp_notes *notes);
void tp_sheet_count_cautions(tp_document *document, const tp_notes *notes, const char *phrase)
    __attribute__((format(printf, 3, 0)));

/* The first page: project and persons, what was given, each case's factor, what follows. */
void tp_sheet_add_persons(tp_document *document, const tp_sheet_head *head);
void tp_sheet_add_inputs(tp_sheet *sheet);
void tp_sheet_add_given_loads(tp_sheet *sheet);
void tp_sheet_add_governing(tp_sheet *sheet);
void tp_sheet_add_load_cases(tp_sheet *sheet);
/* In the appendix; nothing where there is nothing to add. */
void tp_sheet_add_load_case_details(tp_sheet *sheet);
void tp_sheet_add_conclusion(tp_sheet *sheet, const tp_case *own);

/* Does the block lie at its place, so that angles from the level are dips; else it is on a table,
 * or angles count from how it lies. */
bool tp_sheet_tilts_are_dips(const tp_sheet *sheet);

/* What was set in the scene beside its files: a fact each. */
void tp_sheet_add_settings(tp_document *document, const tp_settings *settings);
/* Cells: a factor of safety or what stands for it, of one that is an upper bound "at most 1.2"; and
 * whether it is as required. */
void tp_sheet_add_fos(tp_sheet *sheet, tp_fos fos, bool at_most);
const char *tp_sheet_met_words(tp_design design);
/* A cell: "toppling about pivot 1". */
void tp_sheet_add_against(tp_sheet *sheet, const tp_factor *factor);

void tp_sheet_add_verdict(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_factors(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_window(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_pivots(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_formulas(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_sliding_formulas(tp_sheet *sheet, const tp_case *own);

/* The factors by strength reduction and by the tilt. */
void tp_sheet_add_strength_formulas(tp_sheet *sheet, const tp_case *own);
/* All forces at the limit, with their sums. */
void tp_sheet_add_balance(tp_sheet *sheet, const tp_case *own);

/* Where a formula gives the onset, that with its numbers; else why there is none. */
void tp_sheet_add_onset_formula(tp_sheet *sheet, const tp_case *c);
void tp_sheet_add_loads(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_account(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_limit(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_motions(tp_sheet *sheet, const tp_case *own);
void tp_sheet_add_poses(tp_sheet *sheet);
void tp_sheet_add_proof(tp_sheet *sheet);

/* Of tables: a head above each column, a number, that or a dash, and what is said below the rows
 * that there is room for. */
void tp_sheet_add_heads(tp_document *document, const char *const *heads, size_t count);
void tp_sheet_add_number(tp_document *document, tp_bounded number, int digits);
void tp_sheet_add_number_if(tp_document *document, bool has, tp_bounded number, int digits);
/* A factor of safety, rounded down. */
void tp_sheet_add_factor_if(tp_document *document, bool has, tp_bounded factor, int digits);
void tp_sheet_add_rest(tp_document *document, size_t rows, size_t most);

/* ---- words -------------------------------------------------------------------------------------
 */

/* A text as a page for a terminal has it, which is dropped: paragraphs, of lines that belong
 * together. Empty: nothing. */
void tp_sheet_prose(tp_document *document, tp_passage_kind kind, tp_text *text);

/* Likewise of lines that begin with a label of nine columns: a row of facts each; and of a row for
 * each line, with or without a label. */
void tp_sheet_facts(tp_document *document, tp_text *text);
void tp_sheet_fact_lines(tp_document *document, tp_text *text);

/* A number within a formula: in brackets where it is below 0, or has its bound beside it. */
typedef struct tp_sheet_number {
  char text[TP_NUMBER_SIZE + 4];
} tp_sheet_number;

/* Forces and moments on the first two pages are in the units that the scene asks for, else in kN
 * and kN m. */
tp_bounded tp_sheet_force(const tp_sheet *sheet, tp_bounded newtons);
const char *tp_sheet_force_unit(const tp_sheet *sheet);
tp_bounded tp_sheet_turning(const tp_sheet *sheet, tp_bounded newton_metres);
const char *tp_sheet_turning_unit(const tp_sheet *sheet);

tp_sheet_number tp_sheet_force_number(const tp_sheet *sheet, tp_bounded newtons);

/* Of the account by elements. */
tp_sheet_number tp_sheet_moment(const tp_sheet *sheet, tp_bounded moment);
tp_sheet_number tp_sheet_coordinate(const tp_sheet *sheet, tp_bounded metres);
tp_sheet_number tp_sheet_angle(tp_bounded degrees);
tp_sheet_number tp_sheet_factor(tp_bounded factor); /* of safety: rounded down */
tp_sheet_number tp_sheet_share(tp_bounded share);

/* Coordinates are those of the drawing. An angle in them and δ make one of those that tilts are
 * compared with: towards the case's side, from the axes of components; 0 where they are the same.
 * Before the angle in a formula: "δ + " and "32.276 + ", or nothing. */
typedef struct tp_sheet_turn {
  tp_bounded degrees;
  const char *letter;
  char number[TP_NUMBER_SIZE + 8];
} tp_sheet_turn;

tp_sheet_turn tp_sheet_turn_of(const tp_sheet *sheet, const tp_case *own);

#endif
