/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exit status of a solution: of a design factor that is not met, or of what is left open. */

#include "cli/solve_judge.h"

#include <stdio.h>

static const char *direction(const tp_case *c) {
  return c->towards == TP_TOWARDS_LEFT ? "left" : "right";
}

static const char *stance(const tp_solution *solution) {
  return solution->frame.world ? "as it lies," : "tilted";
}

/* What a case leaves open; NULL: nothing. */
static const char *what_is_open(const tp_case *c) {
  if (c->limit.kind == TP_LIMIT_UNDECIDED) return "the limit by contact forces";
  if (c->limit.fos.state == TP_FOS_UNDECIDED || c->onset.fos.state == TP_FOS_UNDECIDED)
    return "the factor of safety by contact forces";
  if (c->onset.kind == TP_ONSET_UNDECIDED) return "the tilt up to which it is certain to stand";
  if (c->mechanism == TP_MECHANISM_UNDECIDED || c->first == TP_MECHANISM_UNDECIDED) {
    return "the mechanism";
  }
  return NULL;
}

/* That, why, and what would help. */
static void print_open(const tp_case *c, const tp_solution *solution, const char *scene) {
  const char *what = what_is_open(c);
  if (what == NULL) return;
  tp_cli_complain(
      "%s: undecided at %ld bits: %s, %s towards the %s; %s", scene, solution->bits, what,
      stance(solution), direction(c),
      c->limit.too_dear || c->onset.too_dear
          ? "its proof exceeds the work allowed: coordinates and loads with fewer digits help, "
            "or a tilt farther from the critical one"
          : "the deciding quantity is too close to a tie for these bits, or the case holds at "
            "single tilts only: slightly different friction, cohesion or tilt decides it");
}

/* Why a case does not meet the design factor. */
static void print_short_of(const tp_case *c, const tp_solution *solution, double design_fos,
                           const char *scene) {
  const tp_governing_fos *g = &c->governing_fos;
  const char *why =
      g->fos.state == TP_FOS_NO_TILT ? "the scene gives no tilt, so no factor: add tilt.angle_deg"
      : !g->sliding_judged
          ? "sliding is not judged: the scene gives no friction angle; add friction_angle_deg"
      : c->mechanism != TP_STANDS && c->mechanism != TP_INTERLOCKED
          ? "at this tilt it is not certain to stand"
          : "its governing factor is below";
  tp_cli_complain("%s: %s towards the %s, the design factor of safety %g is not met: %s", scene,
                  stance(solution), direction(c), design_fos, why);
}

/* By the factor that is asked for, else by that of the scene. */
static int judge(const tp_solution *solution, const tp_solve_words *a, const char *scene) {
  const tp_governing_fos *g = &solution->cases[0].governing_fos;
  if (!a->has_design_fos && !g->has_required_fos) return 0;
  const double design_fos = a->has_design_fos ? a->design_fos : g->required_fos.value;
  const tp_design all = tp_solution_meets(solution, design_fos);
  if (all == TP_DESIGN_MET) return 0;
  if (all == TP_DESIGN_OPEN) {
    tp_cli_complain("%s: whether the design factor of safety %g is met is undecided", scene,
                    design_fos);
    return tp_status_exit(TP_UNDECIDED);
  }
  for (size_t k = 0; k < solution->case_count; k++) {
    if (tp_case_meets(solution->cases + k, design_fos) == TP_DESIGN_NOT_MET) {
      print_short_of(solution->cases + k, solution, design_fos, scene);
    }
  }
  return TP_EXIT_REFUTED;
}

int tp_cli_judge_required(tp_design meets, double required, const char *scene, const char *open) {
  switch (meets) {
  case TP_DESIGN_NOT_MET:
    tp_cli_complain("%s: the required factor of safety %g is not met", scene, required);
    return TP_EXIT_REFUTED;
  case TP_DESIGN_OPEN:
    tp_cli_complain("%s: whether the required factor of safety %g is met is undecided%s", scene,
                    required, open);
    return tp_status_exit(TP_UNDECIDED);
  case TP_DESIGN_MET:
    break;
  }
  return 0;
}

/* After the report: what it leaves open is a failure of its own, and so is a design factor that is
 * not met, which is certain and comes before it. */
int tp_cli_judge(const tp_solution *solution, const tp_solve_words *a, const char *scene) {
  const int judged = judge(solution, a, scene);
  if (!tp_solution_is_undecided(solution)) return judged;
  for (size_t k = 0; k < solution->case_count; k++) {
    print_open(solution->cases + k, solution, scene);
  }
  if (solution->open_number) {
    tp_cli_complain("%s: a number is not certain to %d digit%s at %ld bits, and is given with its "
                    "actual bound",
                    scene, solution->digits, solution->digits == 1 ? "" : "s", solution->bits);
  }
  return judged != 0 ? judged : tp_status_exit(TP_UNDECIDED);
}

int tp_cli_judge_cases(const tp_load_cases *cases, const tp_solve_words *a, const char *scene) {
  int ended = 0;
  for (size_t k = 0; k < cases->count; k++) {
    char name[TP_CLI_CASE_NAME];
    tp_cli_case_name(name, scene, cases->cases[k].name);
    ended = tp_cli_graver(ended, tp_cli_judge(cases->cases[k].solution, a, name));
  }
  return ended;
}

void tp_cli_case_name(char name[TP_CLI_CASE_NAME], const char *scene, const char *load_case) {
  snprintf(name, TP_CLI_CASE_NAME, "%s, case %s", scene, load_case);
}
