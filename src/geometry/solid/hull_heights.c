/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One plane for each facet: its height, and the arms about its sides. */

#include "solid/hull_heights.h"

#include "solid/tilting.h"

#include <stdlib.h>
#include <string.h>

void tp_hull_heights_corners(int corners[3], const tp_hull_heights *over, long facet) {
  const tp_hull_side *sides = over->facets->sides + over->facets->starts[facet];
  for (int k = 0; k < 3; k++) corners[k] = sides[k].from;
}

void tp_hull_heights_plane(tp_rest_plane *plane, const tp_hull_heights *over, long facet) {
  int corners[3];
  tp_hull_heights_corners(corners, over, facet);
  tp_rest_plane_below(plane, over->centre->surface, corners);
}

static void measure(tp_hull_heights *over, long facet) {
  const tp_hull_side *sides = over->facets->sides;
  const long first = over->facets->starts[facet], past = over->facets->starts[facet + 1];
  tp_rest_plane plane;
  tp_hull_heights_plane(&plane, over, facet);
  tp_near *height = over->heights + facet;
  *height = tp_near_div(tp_centre_height(over->centre, &plane, tp_solid_accuracy),
                        tp_near_norm(plane.near_up));
  if (!tp_near_tells(*height, 100 * tp_solid_accuracy)) over->is_open = true;
  for (long k = first; k < past; k++) { /* seen from above the sides of a facet run the other way */
    over->arms[k] = tp_centre_arm(over->centre, &plane, sides[k].to, sides[k].from, 0);
  }
  tp_rest_plane_clear(&plane);
}

tp_status tp_hull_heights_init(tp_hull_heights *over, const tp_centre *centre,
                               const tp_hull_facets *facets, tp_message *message) {
  const size_t count = (size_t)facets->count;
  *over = (tp_hull_heights){.centre = centre, .facets = facets};
  over->heights = malloc((count + 1) * sizeof *over->heights);
  over->arms = malloc(((size_t)facets->starts[count] + 1) * sizeof *over->arms);
  if (over->heights == NULL || over->arms == NULL) {
    return tp_fail_memory(message, "the poses of a solid");
  }
  for (size_t f = 0; f < count && !over->is_open; f++) measure(over, (long)f);
  return TP_OK;
}

void tp_hull_heights_clear(tp_hull_heights *over) {
  free(over->heights);
  free(over->arms);
  memset(over, 0, sizeof *over);
}

int tp_hull_heights_side(const tp_hull_heights *over, long facet) {
  const long *starts = over->facets->starts;
  return tp_arms_side(over->arms + starts[facet], starts[facet + 1] - starts[facet]);
}
