/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The load cases of a scene: one block under several loads, each held against a factor of safety or
 * partial factors of its own (docs/cases.md). Included by topple.h. */

#ifndef TOPPLE_LOAD_CASES_H
#define TOPPLE_LOAD_CASES_H

#include "topple_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How many load cases a scene has, 0 for none; and the name of one in the order of the scene, which
 * stays the scene's, NULL beyond the last. */
size_t tp_scene_load_case_count(const tp_scene *scene);
const char *tp_scene_load_case_name(const tp_scene *scene, size_t index);

/* The scene of a load case by its name: what the case says over what the scene says, and no cases.
 * It does not need the other scene, and is freed by tp_scene_free. Numbers that were set in the
 * scene go along, where the case does not give its own. */
TP_MUST_USE tp_status tp_scene_load_case(tp_scene **own, const tp_scene *scene, const char *name,
                                         tp_message *message);

/* A load case solved, and what governs it. */
typedef struct tp_load_case {
  TP_OUTSIDE char *name;         /* as the scene names it */
  tp_direction towards;          /* the direction of tilt that governs */
  tp_mechanism mechanism;        /* what the block does */
  tp_fos fos;                    /* its governing factor of safety, with partial factors that of the
                                    factored scene */
  bool has_factor;               /* it is against one way to move: */
  tp_mechanism against;          /* if has_factor: that way */
  bool has_utilisation;          /* the factor is a number certainly above 0, and complete: */
  tp_bounded utilisation;        /* 1 / FoS */
  bool has_required_fos;         /* the case asks for one: */
  tp_bounded required_fos;       /* if has_required_fos: what the factor must reach */
  tp_design meets_required;      /* if has_required_fos: does it? */
  bool has_design_utilisation;   /* both are there: */
  tp_bounded design_utilisation; /* required_fos / FoS, at most 1 where it is met; with partial
                                    factors E_d / R_d */
  tp_solution *solution;         /* the whole; owned */
  size_t direction;              /* index of the direction that governs in solution->cases */
} tp_load_case;

/* All load cases of a scene. */
typedef struct tp_load_cases {
  size_t size;         /* of this struct, as the library has it (TP_HAS_MEMBER) */
  size_t count;        /* of the cases, 1 at least */
  tp_load_case *cases; /* count of them: the one that governs first: those that do not meet what is
                          required, then those of which it is open, each by required_fos / FoS from
                          the greatest on, by their names where that is the same */
} tp_load_cases;

/* Solve all load cases of a scene that has some. `count` settings "KEY=FORMULA" are numbers that
 * hold in every case, whatever that says. All cases are read before the first is solved. Statuses
 * as of tp_solve; the message of a case begins with its name. */
TP_MUST_USE tp_status tp_solve_load_cases(tp_load_cases **cases, const tp_scene *scene,
                                          const char *const *settings, size_t count,
                                          const tp_solve_options *options, tp_message *message);

/* Free them with all that they point to; NULL is allowed. */
void tp_load_cases_free(tp_load_cases *cases);

/* Do all cases meet what is required of them? Met where none requires anything. */
tp_design tp_load_cases_meet(const tp_load_cases *cases);

/* Their table, a row a case, the one that governs first; and JSON, with the list of cases, each
 * with its solution, beside the solution of the one that governs (docs/json.md). Texts are as of
 * tp_report_text. */
TP_MUST_USE tp_status tp_report_load_cases(char **text, const tp_load_cases *cases);
TP_MUST_USE tp_status tp_report_load_cases_json(char **text, const tp_load_cases *cases,
                                                tp_pivots_listed listed);

#ifdef __cplusplus
}
#endif

#endif
