/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Gaps of a mesh that were closed, and how it was thinned; the notes have what else was done. */

#include "report/results.h"
#include "report/solid_page.h"

#include <math.h>

enum { GAPS = 12 };

static void add_gap(tp_text *t, const tp_solid_gap *gap, size_t number) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  %5zu %9zu %10zu  %12s m²  (%.6g, %.6g, %.6g)\n", number, gap->corners,
              gap->triangles, tp_text_significant(n, gap->area_m2, 6), gap->middle[0],
              gap->middle[1], gap->middle[2]);
}

void tp_text_solid_repair(tp_text *t, const tp_solid *s) {
  const tp_solid_repair *own = &s->repair;
  char n[2][TP_NUMBER_SIZE];
  if (!s->has_repair) return;
  if (own->gap_count == 0) {
    tp_text_add(t, "\nRepaired; no gap had to be closed\n");
    return;
  }
  tp_text_add(t,
              "\nRepaired; %zu gap%s closed by triangles that nobody measured: %s of the area, %s "
              "of the volume below them\n  %5s %9s %10s  %15s  about\n",
              own->gap_count, own->gap_count == 1 ? " is" : "s are",
              tp_text_significant(n[0], own->closed_area_share, 4),
              tp_text_significant(n[1], own->closed_volume_share, 4), "gap", "points", "triangles",
              "area");
  for (size_t k = 0; k < own->gap_count && k < GAPS; k++) add_gap(t, own->gaps + k, k + 1);
  if (own->gap_count > GAPS) {
    tp_text_add(t, "  and %zu more, which --json has\n", own->gap_count - GAPS);
  }
}

void tp_text_solid_thinning(tp_text *t, const tp_solid *s) {
  const tp_solid_thinning *own = &s->thinning;
  char n[TP_NUMBER_SIZE];
  if (!s->has_thinning) return;
  tp_text_add(t,
              "\nThinned by %.6g: %zu of %zu triangles and %zu of %zu points are left\n"
              "  no point of either surface is farther than %.6g from the other\n"
              "  it encloses %s m³ %s, %.2g of the volume; volume and all that follows from it are "
              "those of the mesh\n"
              "  of its points %zu stay as corners of the convex hull",
              own->length, s->triangles, own->scan_triangles, s->vertices, own->scan_vertices,
              own->farthest,
              tp_text_significant(n,
                                  (tp_bounded){.value = fabs(own->volume_difference_m3.value),
                                               .error = own->volume_difference_m3.error},
                                  4),
              own->volume_difference_m3.value < 0 ? "less" : "more",
              fabs(own->volume_difference_m3.value) / s->volume_m3.value, own->hull_corners);
  if (own->left_points > 0) {
    tp_text_add(t, ", %zu for the surface would have met itself", own->left_points);
  }
  tp_text_add(t, "\n");
}
