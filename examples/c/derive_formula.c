/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A formula derived, and evaluated where it was not derived. The scene is block E of Alejano et al.
 * towards its valley, with a, b and c as parameters; what comes out about its toe,
 *
 *     tan alpha = (27 a b + 13 a c) / (9 b^2 + 18 b c + 6 c^2),                (A1.8)
 *
 * holds for other values, too. TANGENT is the formula as the program derived it once: it derives it
 * anew, compares the texts, evaluates it for other blocks, and solves these in numbers. */

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <topple.h>

/* clang-format off */
#define TANGENT (27.0*a*b + 13.0*a*c)/(9.0*b*b + 18.0*b*c + 6.0*c*c)
/* clang-format on */
#define TEXT_OF(formula) #formula
#define TEXT(formula) TEXT_OF(formula)

static const char *const scene_text =
    "{topple: 1, length_unit: mm, parameters: {a: 30, b: 120, c: 5}, tilt: {towards: left},\n"
    " block: {teeth: {count: 3, width: a, height: b, depth: c, left_end: valley}}}\n";

static tp_status derive(bool *same, tp_message *message) {
  tp_scene *scene = NULL;
  tp_derivation *derivation = NULL;
  tp_derive_options options = tp_derive_options_default();
  options.notation = TP_NOTATION_C;
  tp_status status = tp_scene_read_text(&scene, scene_text, "block E", message);
  if (status == TP_OK) status = tp_derive(&derivation, scene, &options, message);
  for (size_t k = 0; status == TP_OK && k < derivation->pivot_count; k++) {
    if (!derivation->pivots[k].governs) continue;
    printf("tan alpha = %s\n", derivation->pivots[k].tan_critical_angle.formula);
    *same = strcmp(derivation->pivots[k].tan_critical_angle.formula, TEXT(TANGENT)) == 0;
  }
  tp_derivation_free(derivation);
  tp_scene_free(scene);
  return status;
}

static tp_status compare(bool *same, double a, double b, double c, tp_message *message) {
  const double outline[] = {0, 0, a, c, 2 * a, 0, 3 * a, c, 3 * a, b + c, 0, b + c};
  tp_solution *solution = NULL;
  const tp_status status = tp_solve_outline(&solution, outline, 6, "mm", 30, 0, message);
  if (status != TP_OK) return status;
  const tp_case *left = &solution->cases[0];
  const tp_bounded angle = left->pivots[left->toppling_pivot].critical_angle_deg;
  const double formula = atan(TANGENT) * 57.295779513082320877; /* a radian in degrees */
  const double bound = angle.error + 1e-14 * formula; /* and what doubles round the formula by */
  printf("%5g %5g %5g   %.8f   %.8f   %.1e\n", a, b, c, formula, angle.value, bound);
  *same = *same && fabs(angle.value - formula) <= bound;
  tp_solution_free(solution);
  return TP_OK;
}

int main(void) {
  static const double blocks[][3] = {{30, 120, 5}, {15, 94, 5}, {15, 144, 5}, {7.5, 20, 0.125}};
  tp_message message;
  bool same = false;
  tp_status status = derive(&same, &message);
  if (status == TP_OK) puts("    a     b     c    formula       solved        bound");
  for (size_t k = 0; k < 4 && status == TP_OK; k++) {
    status = compare(&same, blocks[k][0], blocks[k][1], blocks[k][2], &message);
  }
  if (status != TP_OK) fprintf(stderr, "%s\n", message.text);
  if (status == TP_OK) puts(same ? "The formula agrees." : "The formula does NOT agree.");
  return status == TP_OK ? !same : tp_status_exit(status);
}
