/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene solved and reported. Included by topple.h. */

#ifndef TOPPLE_SOLVE_H
#define TOPPLE_SOLVE_H

#include "topple_scene.h"
#include "topple_solution.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most digits that can be asked for. */
enum { TP_DIGITS_MAX = 1000 };

/* Which pivots get their numbers, and are listed: all; those that can govern or hold the block
 * alone, by which are meant the admissible ones, those at rounded corners, those that bear the
 * limit's reactions and the TP_PIVOTS_NEAR_TOE nearest to the toe; or all up to TP_PIVOTS_MANY,
 * beyond that those. */
typedef enum tp_pivots_listed {
  TP_PIVOTS_BY_COUNT,
  TP_PIVOTS_ALL,
  TP_PIVOTS_GOVERNING
} tp_pivots_listed;

/* Pivots listed near the toe, and the count above which fewer are listed. */
enum { TP_PIVOTS_NEAR_TOE = 16, TP_PIVOTS_MANY = 300 };

/* The options of a solve. */
typedef struct tp_solve_options {
  size_t size;             /* of this struct, as `…_default()` has it */
  bool elements;           /* draw up the account of moments by elements */
  bool limit;              /* find the static limit, where the scene gives a friction angle */
  bool strength_reduction; /* and its factor of safety, where the scene gives a tilt angle */
  bool motion_ranges;      /* find which motions can begin at every tilt (tp_onset.ranges) */
  int digits;     /* relative accuracy asked of every number: 10^-digits, 1 to TP_DIGITS_MAX */
  tp_level level; /* the costliest arithmetic allowed; TP_UNDECIDED where it is not enough */
  tp_pivots_listed pivots; /* a number for each of a million pivots takes a fifth of the time */
  size_t threads; /* that compute; 0: as many as the process may run on; 1: none is started. They
                     share the moments of a ring of more than 800 000 edges, at most 16 of them */
} tp_solve_options;

/* The defaults: the limit with strength reduction, 9 digits, every level, all pivots. `size` is
 * that of the struct as the caller knows it. */
void tp_solve_options_init(tp_solve_options *options, size_t size);
static inline tp_solve_options tp_solve_options_default(void) {
  tp_solve_options options;
  tp_solve_options_init(&options, sizeof options);
  return options;
}

/* Stability of the scene's block in each direction of tilt that the scene asks for: moments about
 * every pivot (Eq. 2), sliding (Eq. 6), the static limit and the onset of motion, and which of them
 * comes first (mechanics.md). `*solution` is the caller's, to be freed by tp_solution_free; it does
 * not need the scene any more. The same scene gives the same numbers each time. TP_UNDECIDED where
 * the costliest arithmetic allowed leaves a number open; TP_DEPENDENCY_FAILED. What no
 * arithmetic decides is undecided in the solution (tp_solution_is_undecided), with TP_OK. */
TP_MUST_USE tp_status tp_solve(tp_solution **solution, const tp_scene *scene,
                               const tp_solve_options *options, tp_message *message);

/* The block of one outline, x0, y0, x1, y1, ... of `vertices` points, on its mated base at a tilt:
 * what tp_solve says, with the default options, of a scene of tp_scene_set_outline,
 * tp_scene_set_friction_angle_deg and tp_scene_set_tilt_angle_deg, whose names its messages bear.
 * The block tilts both ways: cases[0] of the solution is towards the left, cases[1] towards the
 * right. `length_unit` is mm, cm, m, km, in or ft; the angles are in degrees. Statuses as of
 * tp_solve. */
TP_MUST_USE tp_status tp_solve_outline(tp_solution **solution, const double *outline,
                                       size_t vertices, const char *length_unit,
                                       double friction_angle_deg, double tilt_angle_deg,
                                       tp_message *message);

/* Free it with all that it points to; NULL is allowed. */
void tp_solution_free(tp_solution *solution);

/* Did the precision allowed leave a mechanism undecided, or a number less certain than requested?
 * Every other number is certain all the same, and each has its proven bound. */
bool tp_solution_is_undecided(const tp_solution *solution);

/* Does every case meet the factor of safety `design_fos`: is its governing one certainly as much,
 * at a tilt at which the block stands? Cautious: without a tilt or a friction angle, and where a
 * motion can begin, it is not met; what is not decided, or as near to the factor as its bound, is
 * open. */
tp_design tp_solution_meets(const tp_solution *solution, double design_fos);

/* The same of one case. */
tp_design tp_case_meets(const tp_case *one, double design_fos);

/* Reports, as `topple solve` prints them: the page, the account of moments by elements, JSON
 * (docs/json.md). Of every report `*text` is allocated with malloc and is the caller's to free; it
 * is UTF-8, and ends with a line end. */
TP_MUST_USE tp_status tp_report_text(char **text, const tp_solution *solution);
TP_MUST_USE tp_status tp_report_elements(char **text, const tp_solution *solution);
TP_MUST_USE tp_status tp_report_json(char **text, const tp_solution *solution);

/* What was set in the scene, notes and cautions of a solution, as on its page; an empty text where
 * there are none. */
TP_MUST_USE tp_status tp_report_notes(char **text, const tp_solution *solution);

/* Which object of the scene's drawing became what, an object a line with its place in the file; an
 * empty text where it has no drawing. */
TP_MUST_USE tp_status tp_report_drawing(char **text, const tp_scene *scene);

/* What ran: effects, what called for each, and what each cost. */
TP_MUST_USE tp_status tp_report_effects(char **text, const tp_solution *solution);

/* JSON with all pivots, or with those that can govern or hold the block alone: they bear their
 * index. tp_report_json lists them by count. Pivots that the solve left without numbers are not
 * listed. */
TP_MUST_USE tp_status tp_report_json_pivots(char **text, const tp_solution *solution,
                                            tp_pivots_listed listed);

/* The same, with the geometry of the scene that was solved, for programs that draw it: outlines as
 * path data of SVG, in metres from an origin, y up, without a bound (docs/solve.md). */
TP_MUST_USE tp_status tp_report_json_outlines(char **text, const tp_scene *scene,
                                              const tp_solution *solution, tp_pivots_listed listed,
                                              tp_message *message);

/* A table of `count` solutions, a row for each direction of each: tilt, verdict, governing factor,
 * and the angles by every way. In Markdown, with the limit on a base that ends at the toe and on
 * one that extends past it; in CSV, each number followed by its bound, with the limit on the
 * scene's base. A factor that is but an upper bound, since another is undecided, is left out of
 * CSV. */
TP_MUST_USE tp_status tp_report_table(char **text, const tp_solution *const *solutions,
                                      size_t count);
TP_MUST_USE tp_status tp_report_csv(char **text, const tp_solution *const *solutions, size_t count);

#ifdef __cplusplus
}
#endif

#endif
