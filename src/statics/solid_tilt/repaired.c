/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A note for each kind of repair that was needed. */

#include "solid_tilt/repaired.h"

#include "common/notes.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

tp_status tp_repair_tell(tp_solid *solid, const tp_solid_body *body, tp_message *message) {
  if (!body->is_mended) return TP_OK;
  const size_t count = body->repair.gap_count;
  tp_solid_gap *gaps = calloc(count + 1, sizeof *gaps);
  if (gaps == NULL) return tp_fail_memory(message, "the gaps of a mesh");
  const double square = solid->metres_per_unit * solid->metres_per_unit;
  for (size_t k = 0; k < count; k++) {
    gaps[k] = body->repair.gaps[k];
    const tp_bounded area = gaps[k].area_m2;
    gaps[k].area_m2.value = square * area.value;
    gaps[k].area_m2.error = square * (area.error + 8 * area.value * DBL_EPSILON);
  }
  solid->has_repair = true;
  solid->repair = body->repair;
  solid->repair.gaps = gaps;
  return TP_OK;
}

/* ---- notes -------------------------------------------------------------------------------------
 */

static tp_status note_points(tp_solid *solid, tp_place place, tp_message *message) {
  const tp_solid_repair *own = &solid->repair;
  return own->merged_points == 0
             ? TP_OK
             : tp_notes_add(&solid->notes, message, TP_CAUTION, place,
                            "repair: %zu points within %.6g of another are merged with it, the "
                            "farthest by %.3g; %zu triangles that lost a corner by it are dropped",
                            own->merged_points, own->merge_within, own->farthest_merged,
                            own->merged_triangles);
}

static tp_status note_duplicates(tp_solid *solid, tp_place place, tp_message *message) {
  const tp_solid_repair *own = &solid->repair;
  return own->duplicate_triangles == 0
             ? TP_OK
             : tp_notes_add(&solid->notes, message, TP_NOTE, place,
                            "repair: %zu triangles that were given before are dropped, the first "
                            "of them triangle %ld",
                            own->duplicate_triangles, own->first_duplicate);
}

static tp_status note_flat(tp_solid *solid, tp_place place, tp_message *message) {
  const tp_solid_repair *own = &solid->repair;
  return own->flat_triangles == 0
             ? TP_OK
             : tp_notes_add(&solid->notes, message, TP_NOTE, place,
                            "repair: %zu triangles without area are dropped, and their neighbours "
                            "parted at their corners, which moves nothing; the first of them is "
                            "triangle %ld",
                            own->flat_triangles, own->first_flat);
}

static tp_status note_turned(tp_solid *solid, tp_place place, tp_message *message) {
  const tp_solid_repair *own = &solid->repair;
  return own->turned_triangles == 0
             ? TP_OK
             : tp_notes_add(&solid->notes, message, TP_NOTE, place,
                            "repair: %zu triangles are turned, so that all run counter-clockwise "
                            "seen from outside; the first of them is triangle %ld",
                            own->turned_triangles, own->first_turned);
}

static tp_status note_pieces(tp_solid *solid, tp_place place, tp_message *message) {
  const tp_solid_repair *own = &solid->repair;
  return own->dropped_pieces == 0
             ? TP_OK
             : tp_notes_add(&solid->notes, message, TP_CAUTION, place,
                            "repair: %zu pieces of less than %.3g of the area, of %zu triangles "
                            "and %.2g of the area together, are dropped",
                            own->dropped_pieces, own->drop_below, own->dropped_triangles,
                            own->dropped_area_share);
}

/* The largest of those that have an area; NULL: there is none. */
static const tp_solid_gap *largest_gap(size_t *count, const tp_solid_repair *own) {
  const tp_solid_gap *most = NULL;
  *count = 0;
  for (size_t k = 0; k < own->gap_count; k++) {
    const tp_solid_gap *gap = own->gaps + k;
    if (gap->triangles == 0) continue;
    ++*count;
    if (most == NULL || gap->area_m2.value > most->area_m2.value) most = gap;
  }
  return most;
}

static tp_status note_gaps(tp_solid *solid, tp_place place, tp_message *message) {
  const tp_solid_repair *own = &solid->repair;
  size_t count = 0;
  const tp_solid_gap *most = largest_gap(&count, own);
  if (count < own->gap_count) {
    const tp_status status =
        tp_notes_add(&solid->notes, message, TP_NOTE, place,
                     "repair: along %zu lines triangles meet others whose corners lie within their "
                     "sides; they are parted there, which moves nothing",
                     own->gap_count - count);
    if (status != TP_OK) return status;
  }
  return most == NULL
             ? TP_OK
             : tp_notes_add(
                   &solid->notes, message, TP_CAUTION, place,
                   "repair: the surface was open. Gaps closed by triangles between their own "
                   "points, which is an assumption: %zu. Of the area %.3g %% was not measured, and "
                   "%.3g %% of the volume lies between the middle of the rock and there. In the "
                   "largest gap, %.3g m² of %zu points about (%.6g, %.6g, %.6g), rock may be left "
                   "out, or air be taken for rock",
                   count, 100 * own->closed_area_share.value, 100 * own->closed_volume_share.value,
                   most->area_m2.value, most->corners, most->middle[0], most->middle[1],
                   most->middle[2]);
}

tp_status tp_repair_notes(tp_solid *solid, tp_message *message) {
  static tp_status (*const notes[])(tp_solid *, tp_place, tp_message *) = {
      note_points, note_duplicates, note_flat, note_turned, note_pieces, note_gaps};
  const tp_place place = {solid->file, 0, 0};
  tp_status status = TP_OK;
  if (!solid->has_repair) return TP_OK;
  for (size_t k = 0; k < sizeof notes / sizeof notes[0] && status == TP_OK; k++) {
    status = notes[k](solid, place, message);
  }
  return status;
}
