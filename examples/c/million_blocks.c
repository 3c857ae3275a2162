/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A million blocks in one array. Each has the form of block E of Alejano et al. with a width a, a
 * height b and a depth c of its teeth of its own; towards its valley it topples at
 *
 *     tan alpha = (27 a b + 13 a c) / (9 b^2 + 18 b c + 6 c^2)                 (A1.8)
 *
 * One call finds all angles, on every processor, each with its bound; the formula checks every one.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <topple.h>

enum { COUNT = 1000000, VERTICES = 6 };
static double xy[COUNT][VERTICES][2], formula_deg[COUNT], angle_deg[COUNT], error_deg[COUNT];

/* Number k of a sequence that fills a range evenly: the fractions of the multiples of a root. */
static double spread(size_t k, double root, double from, double to) {
  return from + (to - from) * fmod((double)k * sqrt(root), 1);
}

static void put_block(size_t k) {
  const double a = spread(k, 2, 10, 40), b = spread(k, 3, 80, 250), c = spread(k, 5, 1, 8);
  const double outline[][2] = {{0, 0}, {a, c}, {2 * a, 0}, {3 * a, c}, {3 * a, b + c}, {0, b + c}};
  memcpy(xy[k], outline, sizeof outline);
  formula_deg[k] =
      atan((27 * a * b + 13 * a * c) / (9 * b * b + 18 * b * c + 6 * c * c)) * 45 / atan(1);
}

static bool show(void) {
  size_t agree = 0, below[7] = {0};
  double widest = 0;
  for (size_t k = 0; k < COUNT; k++) {
    const double bound = error_deg[k] + 1e-14 * formula_deg[k]; /* and of doubles in the rest */
    agree += fabs(angle_deg[k] - formula_deg[k]) <= bound;
    widest = fmax(widest, bound);
    for (int tens = 1; tens < 7; tens++) below[tens] += angle_deg[k] + error_deg[k] < 10 * tens;
  }
  for (int tens = 1; tens < 7; tens++)
    printf("%7zu topple below %d degrees\n", below[tens], 10 * tens);
  printf("%7zu agree with the formula, within %.1e degrees\n", agree, widest);
  return agree == COUNT;
}

int main(void) {
  for (size_t k = 0; k < COUNT; k++) put_block(k);
  const tp_outlines outlines = tp_outlines_of(&xy[0][0][0], COUNT, VERTICES);
  const tp_blocks_options options = tp_blocks_options_default();
  const tp_critical_columns columns = {.angle_deg = angle_deg, .error_deg = error_deg};
  tp_blocks_summary summary;
  tp_message message;
  const tp_status status =
      tp_blocks_critical_angles(&columns, &summary, &outlines, &options, &message);
  if (status != TP_OK) {
    fprintf(stderr, "%s\n", message.text);
    return tp_status_exit(status);
  }
  printf("%7zu blocks, %zu of them by more than doubles\n", summary.done, summary.climbed);
  return show() ? 0 : 1;
}
