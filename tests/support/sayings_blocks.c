/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls on many blocks say, number by number in their bits. */

#include "sayings.h"

#include <math.h>
#include <string.h>

enum { BLOCKS = 5, COLUMNS = 6 };

/* A slab, one that is worn, one that leans out and climbs, a line, and one without a number. */
static const double blocks[] = {0,   0, 1, 0, 1, 2,   0, 2,  0.1, 0, 3.3, 0.01, 3.1, 5.7,
                                0.2, 5, 0, 0, 5, 0,   4, -1, 9,   9, 0,   0,    1,   1,
                                2,   2, 3, 3, 0, NAN, 4, 0,  4,   4, 0,   4};
static const size_t begin_at[BLOCKS + 1] = {0, 4, 8, 12, 16, 20};

static void say_columns(sayings *s, double columns[COLUMNS][BLOCKS], const tp_blocks_summary *sum) {
  for (int k = 0; k < COLUMNS; k++) {
    for (int block = 0; block < BLOCKS; block++) {
      long bits = 0;
      memcpy(&bits, columns[k] + block, sizeof bits);
      note_number(s, bits);
    }
  }
  note_number(s, (long)sum->done);
  note_number(s, (long)sum->climbed);
  note_number(s, (long)sum->bad);
  note_status(s, TP_BAD_INPUT, &sum->complaint);
}

static void say_moments(sayings *s, const tp_outlines *outlines, const tp_blocks_options *options) {
  double c[COLUMNS][BLOCKS] = {0};
  tp_blocks_summary sum = {0};
  tp_message message = {.text = ""};
  tp_area_moments moments;
  const tp_moment_columns columns = {.area = c[0],
                                     .area_error = c[1],
                                     .centroid_x = c[2],
                                     .centroid_y_error = c[3],
                                     .second_moment_xy = c[4],
                                     .second_moment_xy_error = c[5]};
  note_status(s, tp_outlines_moments(&columns, &sum, outlines, options, &message), &message);
  say_columns(s, c, &sum);
  note_status(s, tp_outline_moments(&moments, blocks + 8, 4, &message), &message);
}

static void say_angles(sayings *s, const tp_outlines *outlines, const tp_blocks_options *options) {
  double c[COLUMNS][BLOCKS] = {0};
  tp_blocks_summary sum = {0};
  tp_message message = {.text = ""};
  const tp_critical_columns columns = {.angle_deg = c[0], .error_deg = c[1]};
  note_status(s, tp_blocks_critical_angles(&columns, &sum, outlines, options, &message), &message);
  say_columns(s, c, &sum);
}

static void say_solutions(sayings *s, const tp_outlines *outlines,
                          const tp_blocks_options *options) {
  static const double tilts[BLOCKS] = {10, 20.5, 5, 1, 1};
  double c[COLUMNS][BLOCKS] = {0};
  tp_blocks_summary sum = {0};
  tp_message message = {.text = ""};
  const tp_verdict_columns columns = {.first_angle_deg = c[0],
                                      .first_error_deg = c[1],
                                      .limit_angle_deg = c[2],
                                      .onset_angle_deg = c[3],
                                      .fos = c[4],
                                      .fos_error = c[5]};
  note_status(s,
              tp_blocks_solve(&columns, &sum, outlines, tp_numbers_of(30.5), tp_numbers_each(tilts),
                              options, &message),
              &message);
  say_columns(s, c, &sum);
}

void say_blocks(sayings *s) {
  tp_blocks_options options = tp_blocks_options_default();
  const tp_outlines all = tp_outlines_of(blocks, BLOCKS, 4);
  const tp_outlines ragged = tp_outlines_ragged(blocks, BLOCKS, begin_at);
  options.threads = 2;
  say_moments(s, &all, &options);
  say_angles(s, &ragged, &options);
  say_solutions(s, &ragged, &options);
}
