/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks that were surveyed, a row of a table each, solved and put in order, the worst first
 * (docs/batch.md). Included by topple.h.
 *
 *     tp_batch *batch = NULL;
 *     const tp_batch_options options = tp_batch_options_default();
 *     status = tp_batch_solve(&batch, "survey.csv", &options, &message);
 *
 * Each row makes a scene: that of its column `scene`, or of the options, or an empty one, with the
 * cells of the row at the keys that the head of the table names. What is told of a row is what
 * tp_solve says of that scene. */

#ifndef TOPPLE_BATCH_H
#define TOPPLE_BATCH_H

#include "topple_governing.h"
#include "topple_scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a row is solved. */
typedef struct tp_batch_options {
  size_t size;       /* of this struct, as `…_default()` has it */
  const char *scene; /* the file over which a row's cells are put, where it names none; or NULL */
  size_t threads;    /* that compute; 0: as many as the process may run on; 1: none is started */
  int digits;        /* as in tp_solve_options */
  tp_level level;    /* likewise */
  void *context;     /* of the call below */
  void (*forecast)(void *context, size_t rows, double seconds,
                   double bytes); /* called once by the thread that runs it, after the first of
                                     many rows, or NULL: how long the other `rows` will take by
                                     these, and how much memory the scenes of all */
} tp_batch_options;

/* The defaults: no scene, all threads, and those of tp_solve. */
void tp_batch_options_init(tp_batch_options *options, size_t size);
static inline tp_batch_options tp_batch_options_default(void) {
  tp_batch_options options;
  tp_batch_options_init(&options, sizeof options);
  return options;
}

/* How a block stands, the worst first. */
typedef enum tp_batch_standing {
  TP_BATCH_FAILS, /* a motion can begin as it lies */
  TP_BATCH_BELOW, /* it stands, and certainly lacks the factor required; or the scene has partial
                     factors, with which it certainly does */
  TP_BATCH_UNDECIDED, /* at the precision allowed */
  TP_BATCH_UNSOLVED,  /* the row makes no scene that can be solved */
  TP_BATCH_HOLDS      /* it certainly stands, with the factor required where one is given */
} tp_batch_standing;

/* How many there are. */
enum { TP_BATCH_STANDINGS = TP_BATCH_HOLDS + 1 };

/* fails, below required, undecided, not solved or holds. */
const char *tp_batch_standing_name(tp_batch_standing standing);

/* A block. Of the directions that its scene looks at it has the worst, and of load cases the one
 * that governs (topple_load_cases.h). */
typedef struct tp_batch_row {
  size_t line;                /* of its row in the file, from 1 */
  TP_OUTSIDE char *name;      /* of the block; where the row has none, "row" and its line */
  tp_batch_standing standing; /* what is found */
  tp_status status;           /* TP_OK; TP_UNDECIDED; or why it was not solved */
  TP_OUTSIDE char *remark;    /* why it was not solved, with its place and what to do; else the
                                 cautions of its solution; empty: none */
  bool has_case;              /* it was solved: */
  bool as_it_lies;            /* if has_case: it lies on a slope, and is not on a table */
  tp_bounded dip_deg;         /* if has_case: the dip, or the tilt, at which it lies */
  tp_direction towards;       /* if has_case: the direction that is told of */
  tp_mechanism verdict;       /* if has_case: what the block does as it lies */
  tp_fos fos;                 /* if has_case: the governing factor of safety */
  bool has_fos_mechanism;     /* it is against one: */
  tp_mechanism fos_mechanism; /* if has_fos_mechanism: the motion that the factor is against */
  bool has_required_fos;      /* its scene gives one: */
  tp_bounded required_fos;    /* if has_required_fos: the factor required */
  tp_design meets_required;   /* if has_required_fos: has it that? */
  bool has_margin;            /* there is one: */
  tp_bounded margin_deg; /* if has_margin: by how much it may steepen and is certain to stand; below
                            0 beyond that */
  TP_OUTSIDE char *load_case;    /* the name of the load case that is told of; NULL: its scene has
                                    none */
  bool has_design_utilisation;   /* it has a factor, and one is required: */
  tp_bounded design_utilisation; /* if has_design_utilisation: required_fos / fos, at most 1 where
                                    that is met; with partial factors E_d / R_d */
  TP_OUTSIDE char *scene_name;   /* the file that its scene is over, beside which it names others */
  TP_OUTSIDE char *scene; /* the scene that was solved, with all its load cases, as the text of a
                             scene file; NULL: there is none */
  double at_least; /* if has_case: a proven lower bound of the factor; 0: nothing is proven */
  double at_most;  /* if has_case: a proven upper bound of it; an infinity where there is none */
} tp_batch_row;

/* What is wrong with rows: the same with one or more. */
typedef struct tp_batch_fault {
  size_t line;           /* of the first row, */
  size_t column;         /* and the number of its cell, from 1; 0: of none */
  size_t row_count;      /* with how many rows */
  TP_OUTSIDE char *text; /* with the place of the first, what to do, and the lines of the others */
} tp_batch_fault;

/* A table solved. */
typedef struct tp_batch {
  size_t size;                       /* of this struct, as the library has it (TP_HAS_MEMBER) */
  TP_OUTSIDE char *file;             /* the table */
  size_t row_count;                  /* of the rows */
  tp_batch_row *rows;                /* the worst first */
  size_t counts[TP_BATCH_STANDINGS]; /* by batch_standing: how many of each */
  size_t short_of;                   /* of the rows that certainly lack the factor required */
  size_t source_count;               /* of the sources */
  TP_OUTSIDE char **sources; /* files that rows were read from, over which none is written */
  size_t fault_count;        /* of the faults: */
  tp_batch_fault *faults;    /* of rows that were not solved, in the order of the table */
} tp_batch;

/* Solve each row of the table in `path`: CSV with a head that names its columns. Order: what fails,
 * what lacks the factor required, what is undecided, what was not solved, what holds; each by the
 * factor over that required, or over 1, the least first, then by name and by line. An undecided
 * factor counts by its upper bound, then by its lower one. A row that is wrong stops nothing; a
 * head that is wrong, or a file that is no table, is bad input of the whole. The same by any number
 * of threads. The caller frees `*batch` with tp_batch_free. TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_batch_solve(tp_batch **batch, const char *path,
                                     const tp_batch_options *options, tp_message *message);

/* The same of a table in memory, in UTF-8; `name` is what messages call it, and files that rows
 * name are looked for beside a file of that name. */
TP_MUST_USE tp_status tp_batch_solve_text(tp_batch **batch, const char *text, const char *name,
                                          const tp_batch_options *options, tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_batch_free(tp_batch *batch);

/* The table as text for a terminal; in Markdown; as CSV, each number followed by its bound; as JSON
 * (docs/json.md). `*text` is allocated with malloc and is the caller's to free. */
TP_MUST_USE tp_status tp_report_batch(char **text, const tp_batch *batch);
TP_MUST_USE tp_status tp_report_batch_markdown(char **text, const tp_batch *batch);
TP_MUST_USE tp_status tp_report_batch_csv(char **text, const tp_batch *batch);
TP_MUST_USE tp_status tp_report_batch_json(char **text, const tp_batch *batch);

/* Does the name end in .csv, .json, .md, .html or .htm, the kinds of file that a table can be? */
bool tp_batch_is_file_name(const char *path);

/* The table into the file `path`, whose name ends in .csv, .json or .md. A file of that name is
 * replaced, and stays as it was where the call fails; one that rows were read from is bad input.
 * TP_SYSTEM_FAILED where it cannot be written. */
TP_MUST_USE tp_status tp_batch_write_file(const char *path, const tp_batch *batch,
                                          tp_message *message);

/* Likewise as one page of HTML that needs no other file, with figures of the first `figures` of the
 * blocks that were solved. This call and the next are in the library topple-figure, which draws
 * them. TP_DEPENDENCY_FAILED where Cairo fails. */
TP_MUST_USE tp_status tp_report_sheet_batch(const char *path, const tp_batch *batch, size_t figures,
                                            tp_message *message);

/* A figure of each block that was solved, into the folder `folder`, which is made where there is
 * none, a file each: the line of its row, an _, and of its name letters, digits, - and _, with the
 * `ending` .svg, .pdf, .png or .dxf. */
TP_MUST_USE tp_status tp_report_figures_batch(const char *folder, const char *ending,
                                              const tp_batch *batch, tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
