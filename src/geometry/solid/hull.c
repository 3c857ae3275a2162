/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proposals of a hull, the fast one first, until one is proven. */

#include "solid/hull.h"

static tp_status fail_memory(tp_message *message) {
  return tp_fail_memory(message, "the convex hull of a solid");
}

/* One proposal: `*fault` is TP_HULL_PROVEN where it is the hull, and stays where CGAL failed. */
static tp_geom_status attempt(tp_hull *hull, const tp_surface *surface, const int four[4],
                              tp_hull_search search, bool exact, tp_hull_fault *fault) {
  const tp_geom_points points = tp_surface_points(surface);
  tp_geom_hull found = {0};
  const tp_geom_status status = search(&found, &points, exact);
  if (status != TP_GEOM_OK) return status;
  *hull = (tp_hull){.count = (long)found.count, .corners = found.triangles};
  *fault = tp_hull_prove(hull, surface, four);
  if (*fault != TP_HULL_PROVEN) tp_hull_clear(hull);
  return *fault == TP_HULL_NO_MEMORY ? TP_GEOM_OUT_OF_MEMORY : TP_GEOM_OK;
}

tp_status tp_hull_find_by(tp_hull *hull, const tp_surface *surface, tp_hull_search search,
                          tp_message *message) {
  int four[4];
  *hull = (tp_hull){.count = 0};
  if (!tp_hull_span(four, surface)) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, tp_surface_place(surface, 0),
        "the surface is flat: all its points lie in one plane; a solid needs a volume");
  }
  tp_hull_fault fault = TP_HULL_NO_POINT;
  bool is_found = false;
  for (int exact = 0; exact < 2; exact++) {
    const tp_geom_status status = attempt(hull, surface, four, search, exact == 1, &fault);
    if (status == TP_GEOM_OUT_OF_MEMORY) return fail_memory(message);
    is_found = is_found || status == TP_GEOM_OK;
    if (status == TP_GEOM_OK && fault == TP_HULL_PROVEN) return TP_OK;
  }
  const tp_place place = {surface->mesh->file, 0, 0};
  if (!is_found) {
    return tp_fail(message, TP_DEPENDENCY_FAILED, place,
                   "CGAL failed to find the convex hull of the solid");
  }
  return tp_fail(message, TP_DEPENDENCY_FAILED, place,
                 "the convex hull of the solid, as CGAL found it, failed its check: %s; nothing is "
                 "computed from it; please report this together with the mesh",
                 tp_hull_fault_text(fault));
}

tp_status tp_hull_find(tp_hull *hull, const tp_surface *surface, tp_message *message) {
  return tp_hull_find_by(hull, surface, tp_geom_propose_hull, message);
}
