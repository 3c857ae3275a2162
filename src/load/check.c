/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "load/check.h"

static bool between(const fmpq *value, const fmpq *a, const fmpq *b) {
  return (fmpq_cmp(a, value) <= 0 && fmpq_cmp(value, b) <= 0) ||
         (fmpq_cmp(b, value) <= 0 && fmpq_cmp(value, a) <= 0);
}

bool tp_loads_on_edge(const tp_polyline *ring, long k, const fmpq *x, const fmpq *y) {
  const long next = k + 1 == ring->count ? 0 : k + 1;
  const fmpq *x0 = ring->x + k, *y0 = ring->y + k, *x1 = ring->x + next, *y1 = ring->y + next;
  return tp_points_turn(x0, y0, x1, y1, x, y) == 0 && between(x, x0, x1) && between(y, y0, y1);
}

/* By crossings of a ray to the right. */
bool tp_loads_in_outline(const tp_polyline *ring, const fmpq *x, const fmpq *y) {
  bool inside = false;
  for (long k = 0; k < ring->count; k++) {
    const long next = k + 1 == ring->count ? 0 : k + 1;
    if (tp_loads_on_edge(ring, k, x, y)) return true;
    const bool above = fmpq_cmp(ring->y + k, y) > 0, next_above = fmpq_cmp(ring->y + next, y) > 0;
    if (above == next_above) continue;
    const int side = tp_points_turn(ring->x + k, ring->y + k, ring->x + next, ring->y + next, x, y);
    if ((side > 0) == next_above) inside = !inside;
  }
  return inside;
}

/* One edge of the outline that both ends lie on. */
static bool on_one_edge(const tp_polyline *ring, const tp_line_load *load) {
  for (long k = 0; k < ring->count; k++) {
    if (tp_loads_on_edge(ring, k, load->x0.value, load->y0.value) &&
        tp_loads_on_edge(ring, k, load->x1.value, load->y1.value)) {
      return true;
    }
  }
  return false;
}

static tp_status check_lines(const tp_line_load *loads, long count, const tp_polyline *ring,
                             const char *what, tp_message *message) {
  for (long k = 0; k < count; k++) {
    if (on_one_edge(ring, loads + k)) continue;
    return tp_fail(message, TP_BAD_INPUT, loads[k].place,
                   "this %s does not act on an edge of the block: 'from' and 'to' must lie on one",
                   what);
  }
  return TP_OK;
}

/* A pressure pushes into the block if the line runs counter-clockwise. */
static tp_status check_sense(const tp_line_load *loads, long count, const tp_polyline *ring,
                             tp_message *message) {
  for (long k = 0; k < count; k++) {
    const tp_line_load *load = loads + k;
    for (long j = 0; j < ring->count; j++) {
      if (!tp_loads_on_edge(ring, j, load->x0.value, load->y0.value) ||
          !tp_loads_on_edge(ring, j, load->x1.value, load->y1.value)) {
        continue;
      }
      const long next = j + 1 == ring->count ? 0 : j + 1;
      fmpq_t dot, part, other;
      fmpq_init(dot);
      fmpq_init(part);
      fmpq_init(other);
      fmpq_sub(part, ring->x + next, ring->x + j);
      fmpq_sub(other, load->x1.value, load->x0.value);
      fmpq_mul(dot, part, other);
      fmpq_sub(part, ring->y + next, ring->y + j);
      fmpq_sub(other, load->y1.value, load->y0.value);
      fmpq_addmul(dot, part, other);
      const bool backwards = fmpq_sgn(dot) <= 0;
      fmpq_clear(dot);
      fmpq_clear(part);
      fmpq_clear(other);
      if (!backwards) break;
      return tp_fail(message, TP_BAD_INPUT, load->place,
                     "this pressure would pull: give 'from' and 'to' counter-clockwise round the "
                     "block, so that it lies on their left");
    }
  }
  return TP_OK;
}

tp_status tp_loads_check_water(const tp_scene *scene, const tp_section *section,
                               const fmpq_t heel_y, const char *towards, tp_message *message) {
  const tp_water_description *water = &scene->loads.water;
  const tp_polyline *ring = section->rings;
  if (!water->given) return TP_OK;
  fmpq_t top;
  fmpq_init(top);
  fmpq_set(top, ring->y);
  for (long k = 1; k < ring->count; k++) {
    if (fmpq_cmp(ring->y + k, top) > 0) fmpq_set(top, ring->y + k);
  }
  fmpq_sub(top, top, heel_y);
  const bool above = fmpq_cmp(water->height.value, top) > 0;
  fmpq_clear(top);
  const tp_quantity *tilt = &scene->tilt_angle_deg;
  const bool upright = fmpq_cmp_si(tilt->value, 90) == 0 || fmpq_cmp_si(tilt->value, -90) == 0;
  if (upright && water->stays_level && !fmpq_is_zero(water->height.value)) {
    return tp_fail(message, TP_BAD_INPUT, tilt->place,
                   "at 90° the face behind the block lies level, and water that stays level never "
                   "comes to its end; give a tilt below, or leave out 'stays_level'");
  }
  if (!above) return TP_OK;
  return tp_fail(
      message, TP_BAD_INPUT, water->height.place,
      "the water stands above the top of the block when it is tilted towards the %s: its "
      "height counts from the up-dip end of the contact; lower it, or tilt the other way",
      towards);
}

tp_status tp_loads_check(const tp_scene *scene, const tp_section *section, tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  const tp_polyline *ring = section->rings;
  tp_status status =
      check_lines(loads->pressures, loads->pressure_count, ring, "pressure", message);
  if (status == TP_OK) status = check_sense(loads->pressures, loads->pressure_count, ring, message);
  if (status == TP_OK) {
    status = check_lines(loads->surcharges, loads->surcharge_count, ring, "surcharge", message);
  }
  for (long k = 0; k < loads->anchor_count && status == TP_OK; k++) {
    const tp_anchor_description *a = loads->anchors + k;
    if (tp_loads_in_outline(ring, a->x.value, a->y.value)) continue;
    status = tp_fail(message, TP_BAD_INPUT, a->place,
                     "this anchor does not hold the block: 'at' "
                     "lies outside its outline");
  }
  return status;
}
