/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of the mechanisms that can begin, their names joined, and the style of a region of one
 * mechanism or of several. */

#include "chart/motion_names.h"
#include "chart/mechanism_style.h"

#include <stdio.h>

static const struct mover {
  tp_mechanism mechanism;
  const char *name;
} movers[] = {{TP_SLIDES, "slides"},
              {TP_TOPPLES, "topples"},
              {TP_SLIDES_AND_TOPPLES, "slides and topples"},
              {TP_LEAVES_BASE, "leaves its base"}};

void tp_motions_name(char text[TP_MOTIONS_NAME_SIZE], unsigned motions) {
  size_t length = 0;
  snprintf(text, TP_MOTIONS_NAME_SIZE, "stands");
  for (size_t k = 0; k < sizeof movers / sizeof movers[0]; k++) {
    if ((motions & 1U << movers[k].mechanism) == 0) continue;
    length += (size_t)snprintf(text + length, TP_MOTIONS_NAME_SIZE - length, "%s%s",
                               length > 0 ? ", or " : "", movers[k].name);
  }
}

void tp_motions_border_name(char text[TP_MOTIONS_BORDER_SIZE], unsigned one, unsigned other) {
  char first[TP_MOTIONS_NAME_SIZE], second[TP_MOTIONS_NAME_SIZE];
  tp_motions_name(first, one);
  tp_motions_name(second, other);
  snprintf(text, TP_MOTIONS_BORDER_SIZE, "%s | %s", first, second);
}

tp_chart_style tp_motions_region(unsigned motions) {
  switch (motions) {
  case 1U << TP_SLIDES:
    return tp_region_slides;
  case 1U << TP_TOPPLES:
    return tp_region_topples;
  case 1U << TP_SLIDES_AND_TOPPLES:
    return tp_region_both;
  default:
    return tp_region_other;
  }
}
