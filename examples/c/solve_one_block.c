/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One block in an array, solved. It is block E of Alejano et al., three teeth of width a = 30,
 * height b = 120 and depth c = 5 mm; its left end is a valley, its right end a peak. Moments of its
 * weight let it topple at the angle alpha, and at a lesser tilt give it a factor of safety:
 *
 *     towards the valley   tan alpha = (27 a b + 13 a c) / (9 b^2 + 18 b c + 6 c^2)    (A1.8)
 *     towards the peak     tan alpha = (27 a b + 14 a c) / (9 b^2 - 3 c^2)             (A1.4)
 *     both                 FoS = tan alpha / tan tilt                                  Eq. (2)
 *
 * What contact forces can hold up to, the limit, may be less: see docs/limit.md. */

#include <math.h>
#include <stdio.h>
#include <topple.h>

static const double radian = 57.295779513082320877; /* in degrees */

/* Is the truth where the formula, which doubles round by 1e-14 of it at most, says? */
static bool agrees(tp_bounded number, double formula) {
  return fabs(number.value - formula) <= number.error + 1e-14 * fabs(formula);
}

int main(void) {
  const double a = 30, b = 120, c = 5, friction = 30, tilt = 20;
  const double outline[] = {0, 0, a, c, 2 * a, 0, 3 * a, c, 3 * a, b + c, 0, b + c};
  const double tangents[] = {(27 * a * b + 13 * a * c) / (9 * b * b + 18 * b * c + 6 * c * c),
                             (27 * a * b + 14 * a * c) / (9 * b * b - 3 * c * c)};
  tp_solution *solution = NULL;
  tp_message message;
  tp_status status = tp_solve_outline(&solution, outline, 6, "mm", friction, tilt, &message);
  if (status != TP_OK) {
    fprintf(stderr, "%s\n", message.text);
    return tp_status_exit(status);
  }
  bool all = true;
  printf("towards   topples at   formula      bound    FoS      at 20 deg  by forces at\n");
  for (size_t k = 0; k < solution->case_count; k++) {
    const tp_case *one = tp_solution_case(solution, k);
    const tp_pivot *toe = &one->pivots[one->toppling_pivot];
    const tp_bounded angle = toe->critical_angle_deg, fos = toe->fos.value;
    const double formula = atan(tangents[k]) * radian;
    printf("%-8s  %.7f   %.7f   %.1e  %.5f  %-9s  %.7f\n", k == 0 ? "valley" : "peak", angle.value,
           formula, angle.error, fos.value, tp_mechanism_name(one->mechanism),
           one->limit.critical_angle_deg.value);
    all = all && agrees(angle, formula) && agrees(fos, tangents[k] / tan(tilt / radian));
  }
  puts(all ? "The formulas agree." : "The formulas do NOT agree.");
  tp_solution_free(solution);
  return all ? 0 : 1;
}
