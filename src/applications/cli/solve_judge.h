/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What topple solve ends with, after its report. */

#ifndef TP_CLI_SOLVE_JUDGE_H
#define TP_CLI_SOLVE_JUDGE_H

#include "cli/solve_words.h"

/* What the solution of a scene of this name ends with, told on stderr. */
int tp_cli_judge(const tp_solution *solution, const tp_solve_words *words, const char *scene);
/* The most severe of all cases. */
int tp_cli_judge_cases(const tp_load_cases *cases, const tp_solve_words *words, const char *scene);

/* Whether a scene of many blocks or of a solid meets the factor it must; 0: it does. `open` goes on
 * where that is undecided. */
int tp_cli_judge_required(tp_design meets, double required, const char *scene, const char *open);

/* "scene.yaml, case wet" */
enum { TP_CLI_CASE_NAME = 4200 };
void tp_cli_case_name(char name[TP_CLI_CASE_NAME], const char *scene, const char *load_case);

#endif
