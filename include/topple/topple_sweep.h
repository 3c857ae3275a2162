/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sweeps: one scene solved at each point of a range of one of its numbers, or of two. Included by
 * topple.h.
 *
 *     tp_sweep_options options = tp_sweep_options_default();
 *     options.x = "friction_angle_deg=20:40:0.5";
 *     options.y = "b=60,90,120";
 *     status = tp_sweep(&summary, scene, &options, (tp_sweep_sink){take, &own}, &message);
 *
 * A point is what tp_solve, or of many blocks tp_solve_block_system, or of a solid tp_solve_solid,
 * says of the scene that tp_scene_with_settings makes of its two settings. The values are exact:
 * 0:1:0.1 goes by 0.3, which is no double. Points come in their order, whatever the number of
 * threads, x fastest; memory does not grow with their number. */

#ifndef TOPPLE_SWEEP_H
#define TOPPLE_SWEEP_H

#include "topple_block_system.h"
#include "topple_solid.h"
#include "topple_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most points that a sweep may have. */
enum { TP_SWEEP_MOST = 100000000 };

/* What is swept, and how it is solved. An axis is "KEY=FIRST:LAST:STEP", FIRST and each STEP from
 * it up or down to LAST, or a list, "KEY=VALUE,VALUE"; the numbers are formulas as the scene could
 * have them, in its parameters as they are. */
typedef struct tp_sweep_options {
  size_t size;    /* of this struct, as `…_default()` has it */
  const char *x;  /* the axis that runs fastest */
  const char *y;  /* a second one; or NULL */
  size_t threads; /* that compute; 0: as many as the process may run on; 1: none is started */
  int digits;     /* as in tp_solve_options */
  tp_level level; /* likewise */
} tp_sweep_options;

/* The defaults: all threads, and those of tp_solve; x is to be given. */
void tp_sweep_options_init(tp_sweep_options *options, size_t size);
static inline tp_sweep_options tp_sweep_options_default(void) {
  tp_sweep_options options;
  tp_sweep_options_init(&options, sizeof options);
  return options;
}

/* One point, while it is handed over. */
typedef struct tp_sweep_point {
  size_t index;           /* from 0 */
  const tp_settings *set; /* what was set: before the sweep, x, and y; the same keys in the same
                             order at all points; a value that is not known is NaN */
  tp_status status;       /* TP_OK; TP_UNDECIDED: some is, the rest holds; TP_BAD_INPUT,
                             TP_NO_ANSWER: */
  const tp_solution *solution;   /* is NULL, also where all is undecided, */
  const tp_block_system *system; /* of a scene of many blocks this instead, */
  const char *message;           /* and this is why; plain; else empty */
  const tp_solid *solid;         /* of a scene of a solid instead of the solution */
} tp_sweep_point;

/* Who takes the points, one after the other, in the thread that calls: false ends the sweep. */
typedef struct tp_sweep_sink {
  bool (*take)(void *context, const tp_sweep_point *point); /* not NULL */
  void *context;                                            /* handed to it */
} tp_sweep_sink;

/* Summary of the points: the last four add up to those that were taken. */
typedef struct tp_sweep_summary {
  size_t count;     /* of all points */
  size_t done;      /* TP_OK */
  size_t without;   /* TP_NO_ANSWER */
  size_t undecided; /* TP_UNDECIDED */
  size_t bad;       /* TP_BAD_INPUT */
} tp_sweep_summary;

/* Sweep. `scene` is not changed. A point that is bad input stops nothing; a key that the scene does
 * not have is bad input of the whole. TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_sweep(tp_sweep_summary *summary, const tp_scene *scene,
                               const tp_sweep_options *options, tp_sweep_sink sink,
                               tp_message *message);

/* As what a sweep is written: CSV, a row for each direction of each point, the numbers set first,
 * those of `topple solve --csv` after its status; or JSON (docs/json.md). */
typedef enum tp_sweep_format { TP_SWEEP_CSV, TP_SWEEP_JSON } tp_sweep_format;

/* Who takes a text piece by piece: false ends the writing. */
typedef struct tp_text_sink {
  bool (*take)(void *context, const char *text); /* not NULL */
  void *context;                                 /* handed to it */
} tp_text_sink;

/* Sweep, and hand each point over as text as it comes. */
TP_MUST_USE tp_status tp_sweep_write(tp_sweep_summary *summary, const tp_scene *scene,
                                     const tp_sweep_options *options, tp_sweep_format format,
                                     tp_text_sink sink, tp_message *message);

/* The same into the file `path`, which appears whole or not at all: until then the text is in
 * memory. TP_SYSTEM_FAILED where it cannot be written. */
TP_MUST_USE tp_status tp_sweep_write_file(tp_sweep_summary *summary, const char *path,
                                          const tp_scene *scene, const tp_sweep_options *options,
                                          tp_sweep_format format, tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
