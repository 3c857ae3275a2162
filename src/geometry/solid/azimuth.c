/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* East and north by the least turn that brings up to z, and azimuths by arctangents with bounds. */

#include "solid/azimuth.h"

#include "number/near_angle.h"

static const tp_near one = {1, 0};

static tp_near dot(const tp_near a[3], const tp_near b[3]) {
  return tp_near_plus(tp_near_plus(tp_near_times(a[0], b[0]), tp_near_times(a[1], b[1])),
                      tp_near_times(a[2], b[2]));
}

void tp_map_frame_init(tp_map_frame *frame, const tp_near up[3]) {
  const tp_near zero = {0, 0};
  const bool upright = tp_near_is_zero(up[0]) && tp_near_is_zero(up[1]);
  if (upright) {
    const tp_near north = {up[2].value < 0 ? -1 : 1, 0};
    *frame = (tp_map_frame){.east = {one, zero, zero}, .north = {zero, north, zero}};
    return;
  }
  const tp_near length = tp_near_sqrt(dot(up, up));
  const tp_near a = tp_near_is_zero(up[0]) ? zero : tp_near_div(up[0], length);
  const tp_near b = tp_near_is_zero(up[1]) ? zero : tp_near_div(up[1], length);
  const tp_near c = tp_near_is_zero(up[2]) ? zero : tp_near_div(up[2], length);
  /* 1 + c = (a a + b b) / (1 - c), where c is near -1 */
  const tp_near level = tp_near_plus(tp_near_times(a, a), tp_near_times(b, b));
  const tp_near sum =
      c.value >= 0 ? tp_near_plus(one, c) : tp_near_div(level, tp_near_minus(one, c));
  const tp_near both = tp_near_neg(tp_near_times(a, b));
  const tp_near cross = tp_near_is_zero(both) ? zero : tp_near_div(both, sum);
  const tp_near aa = tp_near_times(a, a), bb = tp_near_times(b, b);
  frame->east[0] = tp_near_is_zero(aa) ? one : tp_near_minus(one, tp_near_div(aa, sum));
  frame->east[1] = cross;
  frame->east[2] = tp_near_neg(a);
  frame->north[0] = cross;
  frame->north[1] = tp_near_is_zero(bb) ? one : tp_near_minus(one, tp_near_div(bb, sum));
  frame->north[2] = tp_near_neg(b);
}

void tp_map_frame_down(tp_map_frame *frame, const tp_near up[3], const tp_near normal[3]) {
  tp_map_frame level, own;
  tp_map_frame_init(&own, normal);
  *frame = own;
  if (tp_near_is_zero(up[0]) && tp_near_is_zero(up[1]) && up[2].value > 0) return;
  tp_map_frame_init(&level, up);
  const tp_near length = tp_near_sqrt(dot(up, up));
  for (int k = 0; k < 3; k++) {
    const tp_near rise = tp_near_is_zero(up[k]) ? up[k] : tp_near_div(up[k], length);
    const tp_near axis[3] = {level.east[k], level.north[k], rise};
    frame->east[k] = dot(own.east, axis);
    frame->north[k] = dot(own.north, axis);
  }
}

void tp_map_components(tp_near *east, tp_near *north, const tp_map_frame *frame,
                       const tp_near vector[3]) {
  *east = dot(frame->east, vector);
  *north = dot(frame->north, vector);
}

tp_bounded tp_azimuth_of(tp_near east, tp_near north) {
  static const tp_near right = {90, 0}, straight = {180, 0}, left = {270, 0}, round = {360, 0};
  tp_near angle;
  if (fabs(east.value) <= fabs(north.value)) {
    angle = tp_near_is_zero(east) ? east : tp_near_arctangent(tp_near_div(east, north));
    if (north.value < 0) angle = tp_near_plus(straight, angle);
  } else {
    angle = tp_near_is_zero(north) ? north : tp_near_arctangent(tp_near_div(north, east));
    angle = tp_near_minus(east.value > 0 ? right : left, angle);
  }
  if (angle.value < 0 && -angle.value <= angle.error) {
    angle = (tp_near){0, angle.error - angle.value};
  }
  if (angle.value < 0) angle = tp_near_plus(round, angle);
  return (tp_bounded){.value = angle.value, .error = angle.error};
}

void tp_azimuth_direction(tp_near *east, tp_near *north, double azimuth_deg) {
  const int quarter = (int)floor(azimuth_deg / 90);
  const tp_near rest = tp_near_minus((tp_near){azimuth_deg, 0}, (tp_near){90.0 * quarter, 0});
  tp_near sine, cosine;
  tp_near_sin_cos(&sine, &cosine, rest);
  if (tp_near_is_zero(rest)) {
    sine = (tp_near){0, 0};
    cosine = one;
  }
  *east = quarter == 0   ? sine
          : quarter == 1 ? cosine
          : quarter == 2 ? tp_near_neg(sine)
                         : tp_near_neg(cosine);
  *north = quarter == 0   ? cosine
           : quarter == 1 ? tp_near_neg(sine)
           : quarter == 2 ? tp_near_neg(cosine)
                          : sine;
}
