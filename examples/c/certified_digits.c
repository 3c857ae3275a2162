/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* As many digits as are asked for, all of them certain. A slab of width x and height y topples at
 *
 *     alpha = arctan(x / y)                                                    Eq. (3)
 *
 * and Euler found arctan(1/2) + arctan(1/3) = 45 degrees: so the decimals of two slabs, twice and
 * three times as high as wide, must add up to 45, but for the last ones, where each is rounded. */

#include <stdio.h>
#include <string.h>
#include <topple.h>

static tp_status solve_slab(tp_solution **solution, double height, int digits,
                            tp_message *message) {
  tp_solve_options options = tp_solve_options_default();
  tp_scene *scene = NULL;
  options.digits = digits;
  tp_status status = tp_scene_new(&scene, "m", message);
  if (status == TP_OK) {
    status = tp_scene_set_slab(scene, tp_exact_of(1), tp_exact_of(height), message);
  }
  if (status == TP_OK) status = tp_solve(solution, scene, &options, message);
  tp_scene_free(scene);
  return status;
}

/* The same two angles, and 45 less both in units of the last decimal: what is left goes from one
 * decimal to the next. */
static bool add_up(const tp_case *half, const tp_case *third) {
  const char *one = half->pivots[half->toppling_pivot].critical_angle_deg.digits;
  const char *other = third->pivots[third->toppling_pivot].critical_angle_deg.digits;
  long rest = strlen(one) == strlen(other) ? 0 : 1000;
  for (size_t k = 0; one[k] != '\0' && rest < 1000 && rest > -1000; k++) {
    const int of_45 = k == 0 ? 4 : k == 1 ? 5 : 0;
    if (one[k] != '.') rest = 10 * rest + of_45 - (one[k] - '0') - (other[k] - '0');
  }
  printf("  %.66s\n  %.66s\n  45 less both: %ld of the last decimal\n", one, other, rest);
  return rest >= -1 && rest <= 1;
}

int main(void) {
  tp_message message;
  tp_status status = TP_OK;
  bool all = true;
  for (int digits = 20; digits <= TP_DIGITS_MAX && status == TP_OK; digits = digits * 7 / 2) {
    tp_solution *half = NULL, *third = NULL;
    status = solve_slab(&half, 2, digits, &message);
    if (status == TP_OK) status = solve_slab(&third, 3, digits, &message);
    if (status == TP_OK) printf("%d digits, by numbers of %ld bits\n", digits, half->bits);
    if (status == TP_OK) all = add_up(&half->cases[0], &third->cases[0]) && all;
    tp_solution_free(half);
    tp_solution_free(third);
  }
  if (status != TP_OK) fprintf(stderr, "%s\n", message.text);
  if (status == TP_OK) puts(all ? "Euler's identity holds." : "Euler's identity does NOT hold.");
  return status == TP_OK ? !all : tp_status_exit(status);
}
