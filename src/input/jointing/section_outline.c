/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The section of a slope: its surface from left to right, by points or by the numbers of a face,
 * upright ends, and a level bottom below all of it and the base. */

#include "jointing/section_outline.h"

#include "number/divide.h"

#include <stdlib.h>

/* The surface as points from left to right, and two corners of the bottom. */
static tp_status make_room(tp_cuts *cuts, long count, tp_message *message) {
  cuts->corners = calloc((size_t)count + 2, sizeof *cuts->corners);
  cuts->x = calloc((size_t)count + 2, sizeof *cuts->x);
  cuts->y = calloc((size_t)count + 2, sizeof *cuts->y);
  if (cuts->corners == NULL || cuts->x == NULL || cuts->y == NULL) {
    return tp_fail_memory(message, "the slope");
  }
  for (; cuts->corner_count < count + 2; cuts->corner_count++) {
    tp_cut_point_init(cuts->corners + cuts->corner_count);
  }
  return TP_OK;
}

/* height * cosine / sine of the dip of the face. */
static tp_status run_of_face(fmpq_t run, const tp_jointed_slope *slope, tp_message *message) {
  tp_cut_point u;
  tp_cut_point_init(&u);
  tp_direction_of_degrees(&u, slope->face_dip_deg.value);
  fmpq_mul(run, slope->height.value, u.x);
  const tp_status status = tp_divide_above_zero(
      run, run, u.y, slope->face_dip_deg.place,
      "the face is level to within 1e-8°, to which directions are rounded, and never comes to its "
      "height; give a steeper one",
      message);
  tp_cut_point_clear(&u);
  return status;
}

/* length * sine / cosine of the dip of the ground behind the crest. */
static tp_status rise_behind(fmpq_t rise, const fmpq_t length, const tp_jointed_slope *slope,
                             tp_message *message) {
  tp_cut_point u;
  tp_cut_point_init(&u);
  tp_direction_of_degrees(&u, slope->upper_dip_deg.value);
  fmpq_mul(rise, length, u.y);
  const tp_status status = tp_divide_above_zero(
      rise, rise, u.x, slope->upper_dip_deg.place,
      "the ground behind the crest is upright to within 1e-8°, to which directions are rounded; "
      "give a flatter one",
      message);
  tp_cut_point_clear(&u);
  return status;
}

/* Level ground, the toe, the crest, and the end of the upper ground. */
static tp_status set_face(tp_cuts *cuts, tp_message *message) {
  enum { LEFT, TOE, CREST, RIGHT, POINTS };
  const tp_jointed_slope *slope = cuts->slope;
  const bool has_front = !fmpq_is_zero(slope->front.value);
  const long skipped = has_front ? 0 : 1;
  tp_status status = make_room(cuts, POINTS - skipped, message);
  if (status != TP_OK) return status;
  tp_cut_point *at = cuts->corners - skipped;
  fmpq_t length;
  fmpq_init(length);
  if (has_front) {
    fmpq_sub(at[LEFT].x, cuts->toe.x, slope->front.value);
    fmpq_set(at[LEFT].y, cuts->toe.y);
  }
  fmpq_set(at[TOE].x, cuts->toe.x);
  fmpq_set(at[TOE].y, cuts->toe.y);
  status = run_of_face(length, slope, message);
  fmpq_add(at[CREST].x, cuts->toe.x, length);
  fmpq_add(at[CREST].y, cuts->toe.y, slope->height.value);
  if (slope->behind.given) {
    fmpq_set(length, slope->behind.value);
  } else {
    fmpq_mul_si(length, slope->height.value, 2);
  }
  fmpq_add(at[RIGHT].x, at[CREST].x, length);
  if (status == TP_OK) status = rise_behind(length, length, slope, message);
  fmpq_add(at[RIGHT].y, at[CREST].y, length);
  fmpq_clear(length);
  return status;
}

static tp_status set_surface(tp_cuts *cuts, tp_message *message) {
  const tp_polyline *surface = &cuts->slope->surface;
  const tp_status status = make_room(cuts, surface->count, message);
  if (status != TP_OK) return status;
  for (long k = 0; k < surface->count; k++) {
    const long from = cuts->slope->right ? surface->count - 1 - k : k;
    fmpq_set(cuts->corners[k].x, surface->x + from);
    fmpq_set(cuts->corners[k].y, surface->y + from);
    if (cuts->slope->right) fmpq_neg(cuts->corners[k].x, cuts->corners[k].x);
  }
  return TP_OK;
}

static void lower(fmpq_t low, const fmpq *value) {
  if (fmpq_cmp(value, low) < 0) fmpq_set(low, value);
}

/* Below all by a quarter of the height and a sixteenth of the width. */
static void set_bottom(tp_cuts *cuts) {
  const tp_jointed_slope *slope = cuts->slope;
  const long count = cuts->corner_count - 2;
  tp_cut_point *at = cuts->corners;
  fmpq_t low, high, part;
  fmpq_init(low);
  fmpq_init(high);
  fmpq_init(part);
  fmpq_set(low, at[0].y);
  fmpq_set(high, at[0].y);
  for (long k = 1; k < count; k++) {
    lower(low, at[k].y);
    if (fmpq_cmp(at[k].y, high) > 0) fmpq_set(high, at[k].y);
  }
  lower(low, slope->base_y.given ? slope->base_y.value : cuts->toe.y);
  for (long k = 0; k < slope->base_line.count; k++) lower(low, slope->base_line.y + k);
  fmpq_sub(part, high, low);
  fmpq_div_2exp(part, part, 2);
  fmpq_sub(low, low, part);
  fmpq_sub(part, at[count - 1].x, at[0].x);
  fmpq_div_2exp(part, part, 4);
  fmpq_sub(low, low, part);
  fmpq_set(at[count].x, at[count - 1].x);
  fmpq_set(at[count].y, low);
  fmpq_set(at[count + 1].x, at[0].x);
  fmpq_set(at[count + 1].y, low);
  fmpq_clear(low);
  fmpq_clear(high);
  fmpq_clear(part);
}

static void set_doubles(tp_cuts *cuts) {
  fmpq_t difference;
  fmpq_init(difference);
  for (long k = 0; k < cuts->corner_count; k++) {
    fmpq_sub(difference, cuts->corners[k].x, cuts->toe.x);
    cuts->x[k] = fmpq_get_d(difference);
    fmpq_sub(difference, cuts->corners[k].y, cuts->toe.y);
    cuts->y[k] = fmpq_get_d(difference);
  }
  fmpq_clear(difference);
}

/* The outline runs clockwise here, as the surface from left to right does. */
static bool add_segments(tp_cuts *cuts) {
  const long count = cuts->corner_count;
  bool done = true;
  for (long k = 0; k < count && done; k++) {
    const tp_cut_kind kind = k < count - 3    ? TP_CUT_SURFACE
                             : k == count - 2 ? TP_CUT_BOTTOM
                                              : TP_CUT_END;
    done = tp_cuts_add(cuts, cuts->corners + k, cuts->corners + (k + 1) % count,
                       (tp_cut){kind, TP_EDGE_OF_NONE});
  }
  return done;
}

tp_status tp_cuts_outline(tp_cuts *cuts, tp_message *message) {
  const tp_status status =
      cuts->slope->surface.count > 0 ? set_surface(cuts, message) : set_face(cuts, message);
  if (status != TP_OK) return status;
  set_bottom(cuts);
  set_doubles(cuts);
  return add_segments(cuts) ? TP_OK : tp_fail_memory(message, "the slope");
}
