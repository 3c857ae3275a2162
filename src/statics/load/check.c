/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Geometry of loads in rationals: pressures and surcharges on edges of the outline, anchors at
 * points of the block. */

#include "load/check.h"

#include "load/bolt_way.h"

static bool is_point(const tp_line_load *load) {
  return fmpq_equal(load->x0.value, load->x1.value) && fmpq_equal(load->y0.value, load->y1.value);
}

/* Where a point of the load's line lies on it: 0 at `from`, 1 at `to`. */
static void place_on(fmpq_t place, const tp_line_load *load, const fmpq *x, const fmpq *y) {
  const fmpq *x0 = load->x0.value, *x1 = load->x1.value, *y0 = load->y0.value, *y1 = load->y1.value;
  const bool upright = fmpq_equal(x0, x1);
  fmpq_t whole;
  fmpq_init(whole);
  fmpq_sub(whole, upright ? y1 : x1, upright ? y0 : x0);
  fmpq_sub(place, upright ? y : x, upright ? y0 : x0);
  fmpq_div(place, place, whole);
  fmpq_clear(whole);
}

static bool lies_along(const tp_line_load *load, const fmpq *x, const fmpq *y) {
  return tp_points_turn(load->x0.value, load->y0.value, load->x1.value, load->y1.value, x, y) == 0;
}

/* Is the line covered by edges of the outline, where `forwards` by such as run the way it does? A
 * straight face may be given in several edges. */
static bool is_covered(const tp_polyline *ring, const tp_line_load *load, bool forwards) {
  if (is_point(load)) return false;
  fmpq_t reached, begin, end;
  fmpq_init(reached);
  fmpq_init(begin);
  fmpq_init(end);
  bool farther = true;
  while (farther && fmpq_cmp_si(reached, 1) < 0) {
    farther = false;
    for (long k = 0; k < ring->count; k++) {
      const long next = k + 1 == ring->count ? 0 : k + 1;
      if (!lies_along(load, ring->x + k, ring->y + k) ||
          !lies_along(load, ring->x + next, ring->y + next)) {
        continue;
      }
      place_on(begin, load, ring->x + k, ring->y + k);
      place_on(end, load, ring->x + next, ring->y + next);
      if (fmpq_cmp(begin, end) > 0) {
        if (forwards) continue;
        fmpq_swap(begin, end);
      }
      if (fmpq_cmp(begin, reached) > 0 || fmpq_cmp(end, reached) <= 0) continue;
      fmpq_set(reached, end);
      farther = true;
    }
  }
  const bool covered = fmpq_cmp_si(reached, 1) >= 0;
  fmpq_clear(reached);
  fmpq_clear(begin);
  fmpq_clear(end);
  return covered;
}

/* Does it act on the outline: a line on its edges, or a point of one? */
static bool acts_on(const tp_polyline *ring, const tp_line_load *load) {
  if (!is_point(load)) return is_covered(ring, load, false);
  for (long k = 0; k < ring->count; k++) {
    if (tp_loads_on_edge(ring, k, load->x0.value, load->y0.value)) return true;
  }
  return false;
}

static tp_status check_lines(const tp_line_load *loads, long count, const tp_polyline *ring,
                             const char *what, tp_message *message) {
  for (long k = 0; k < count; k++) {
    if (acts_on(ring, loads + k)) continue;
    return tp_refuse(
        message, TP_FAULT_RANGE, loads[k].place,
        "this %s does not act on an edge of the block: the straight line from 'from' to "
        "'to' must lie on its outline; on a face with corners give one for each edge",
        what);
  }
  return TP_OK;
}

/* A pressure pushes into the block if the line runs counter-clockwise. */
static tp_status check_sense(const tp_line_load *loads, long count, const tp_polyline *ring,
                             tp_message *message) {
  for (long k = 0; k < count; k++) {
    if (is_covered(ring, loads + k, true)) continue;
    return tp_refuse(message, TP_FAULT_GEOMETRY, loads[k].place,
                     "this pressure would pull: give 'from' and 'to' counter-clockwise round the "
                     "block, so that it lies on their left");
  }
  return TP_OK;
}

tp_status tp_load_lines_check(const tp_line_load *lines, long count, const tp_polyline *outline,
                              const char *what, bool push, tp_message *message) {
  const tp_status status = check_lines(lines, count, outline, what, message);
  return status == TP_OK && push ? check_sense(lines, count, outline, message) : status;
}

/* Does a point of the outline stand as high above the heel, normal to the mean plane? */
static bool reaches(const tp_polyline *ring, long k, const tp_scene *scene, const fmpq_t heel_x,
                    const fmpq_t heel_y) {
  const tp_base_description *base = &scene->base;
  fmpq_t x, height;
  fmpq_init(x);
  fmpq_init(height);
  fmpq_sub(height, ring->y + k, heel_y);
  if (base->beyond_cosine != NULL) {
    fmpq_sub(x, ring->x + k, heel_x);
    fmpq_mul(height, height, base->beyond_cosine);
    fmpq_submul(height, x, base->beyond_sine);
  }
  const bool own = fmpq_cmp(height, scene->loads.water.height.value) >= 0;
  fmpq_clear(x);
  fmpq_clear(height);
  return own;
}

tp_status tp_loads_check_water(const tp_scene *scene, const tp_section *section,
                               const fmpq_t heel_x, const fmpq_t heel_y, const char *towards,
                               tp_message *message) {
  const tp_water_description *water = &scene->loads.water;
  const tp_polyline *ring = section->rings;
  if (!water->given) return TP_OK;
  bool above = true;
  for (long k = 0; k < ring->count && above; k++) above = !reaches(ring, k, scene, heel_x, heel_y);
  const tp_quantity *tilt = &scene->tilt_angle_deg;
  const bool upright = fmpq_cmp_si(tilt->value, 90) == 0 || fmpq_cmp_si(tilt->value, -90) == 0;
  if (upright && water->stays_level && !water->lifts_alone && !fmpq_is_zero(water->height.value)) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, tilt->place,
        "at 90° the face behind the block lies level, and water that stays level never "
        "comes to its end; give a tilt below, or leave out 'stays_level'");
  }
  if (!above) return TP_OK;
  if (tp_scene_lies_in_place(scene)) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, water->height.place,
        "the water stands above the top of the block: its height counts from the up-dip "
        "end of the joint below it, normal to the mean plane; lower it");
  }
  return tp_refuse(
      message, TP_FAULT_GEOMETRY, water->height.place,
      "the water stands above the top of the block when it is tilted towards the %s: its "
      "height counts from the up-dip end of the joint below it; lower it, or tilt the other way",
      towards);
}

tp_status tp_loads_check(const tp_scene *scene, const tp_section *section, tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  const tp_polyline *ring = section->rings;
  tp_status status =
      tp_load_lines_check(loads->pressures, loads->pressure_count, ring, "pressure", true, message);
  if (status == TP_OK) {
    status = tp_load_lines_check(loads->surcharges, loads->surcharge_count, ring, "surcharge",
                                 false, message);
  }
  if (status == TP_OK) {
    status = tp_load_lines_check(loads->supports, loads->support_count, ring, "support pressure",
                                 true, message);
  }
  for (long k = 0; k < loads->anchor_count && status == TP_OK; k++) {
    status = tp_bolt_check(scene, loads->anchors + k, ring, message);
  }
  return status;
}
