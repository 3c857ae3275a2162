/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The difference of two volumes, and a caution where a band is less than what points moved. */

#include "solid_tilt/thinned.h"

#include "common/notes.h"

#include <float.h>
#include <math.h>

static tp_bounded difference(tp_bounded one, tp_bounded other) {
  const double value = one.value - other.value;
  return (tp_bounded){.value = value,
                      .error = (one.error + other.error + fabs(value) * DBL_EPSILON) *
                               (1 + 4 * DBL_EPSILON)};
}

/* Is there a band above 0 that is less than the length? */
static bool has_narrow(const tp_solid_given *given, double length) {
  for (size_t k = 0; k < given->band_count; k++) {
    const double band = tp_surface_nearest(given->bands + k);
    if (band > 0 && band < length) return true;
  }
  return false;
}

tp_status tp_thinning_tell(tp_solid *solid, const tp_solid_body *body, const tp_solid_given *given,
                           tp_message *message) {
  tp_solid_thinning *own = &solid->thinning;
  const tp_place place = {solid->file, 0, 0};
  if (!body->is_thinned) return TP_OK;
  solid->has_thinning = true;
  *own = body->thinning;
  own->volume_difference_m3 =
      difference(tp_solid_moments_volume(&body->of_thinned, given->metres_per_unit),
                 tp_solid_moments_volume(&body->moments, given->metres_per_unit));
  tp_status status =
      tp_notes_add(&solid->notes, message, TP_NOTE, place,
                   "thinned: of %zu triangles %zu are left, nowhere farther than %.6g from the "
                   "mesh, and it nowhere farther from them; its convex hull, volume and centroid, "
                   "and with them the poses, are kept as they were; where it meets itself within "
                   "that length is not looked for",
                   own->scan_triangles, solid->triangles, own->farthest);
  if (status == TP_OK && own->left_points > 0) {
    status = tp_notes_add(&solid->notes, message, TP_NOTE, place,
                          "thinned: %zu points are left where they are, for the surface would have "
                          "met itself there",
                          own->left_points);
  }
  if (status == TP_OK && has_narrow(given, own->length)) {
    status =
        tp_notes_add(&solid->notes, message, TP_CAUTION, place,
                     "thinned: in bands of less than %.6g, by which the mesh is thinned, little "
                     "of what touches may be left, so that the rock stands less firmly than by "
                     "all of the mesh",
                     own->length);
  }
  return status;
}
