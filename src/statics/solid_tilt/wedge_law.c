/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lines over the plane of horizontal forces, and their values. */

#include "solid_tilt/wedge_law.h"

#include "number/ball.h"

enum { BITS = TP_WEDGE_LAW_BITS };

const char *tp_wedge_way_name(tp_wedge_way way) {
  static const char *const names[] = {"a and b", "a", "b", "neither", "neither"};
  return names[way];
}

/* ---- lines -------------------------------------------------------------------------------------
 */

/* The line of R . v. */
static void set_line(arb_struct line[3], const tp_wedge_forces *forces, const arb_struct v[3]) {
  tp_wedge_dot(line, forces->push, v);
  for (int k = 0; k < 2; k++) arb_mul(line + 1 + k, &forces->weight, v + k, TP_WEDGE_BITS);
}

/* N of a joint = (press of it - k press of the other) / (1 - k^2), from -R . a and -R . b. */
static void set_normal_lines(tp_wedge_law *law, const tp_wedge_shape *shape) {
  arb_t k, rest, part;
  arb_init(k);
  arb_init(rest);
  arb_init(part);
  tp_wedge_dot(k, shape->normals[TP_WEDGE_A], shape->normals[TP_WEDGE_B]);
  arb_mul(rest, k, k, TP_WEDGE_BITS);
  arb_sub_ui(rest, rest, 1, TP_WEDGE_BITS);
  arb_neg(rest, rest);
  for (int joint = 0; joint < 2; joint++) {
    for (int i = 0; i < 3; i++) {
      arb_mul(part, law->lines[TP_WEDGE_PRESS_A + 1 - joint] + i, k, TP_WEDGE_BITS);
      arb_sub(part, law->lines[TP_WEDGE_PRESS_A + joint] + i, part, TP_WEDGE_BITS);
      arb_div(law->lines[TP_WEDGE_NORMAL_A + joint] + i, part, rest, TP_WEDGE_BITS);
    }
  }
  arb_clear(k);
  arb_clear(rest);
  arb_clear(part);
}

static void each(tp_wedge_law *law, void (*what)(arb_t number)) {
  for (int k = 0; k < TP_WEDGE_LINES; k++) {
    for (int i = 0; i < 3; i++) what(law->lines[k] + i);
  }
  for (int joint = 0; joint < 2; joint++) {
    what(law->cohesion + joint);
    what(law->friction + joint);
  }
}

static void set_strength(tp_wedge_law *law, const tp_wedge_forces *forces,
                         const tp_wedge_description *own) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  for (int joint = 0; joint < 2; joint++) {
    tp_ball_sin_cos_degrees(sine, cosine, own->friction_deg[joint].value, TP_WEDGE_BITS);
    arb_div(law->friction + joint, sine, cosine, TP_WEDGE_BITS);
    if (!own->cohesion_kpa[joint].given) continue;
    arb_set_fmpq(sine, own->cohesion_kpa[joint].value, TP_WEDGE_BITS);
    arb_mul(law->cohesion + joint, sine, forces->areas + joint, TP_WEDGE_BITS);
  }
  arb_clear(sine);
  arb_clear(cosine);
}

void tp_wedge_law_init(tp_wedge_law *law, const tp_wedge_forces *forces,
                       const tp_wedge_shape *shape, const tp_scene *scene) {
  arb_struct across[3];
  each(law, arb_init);
  for (int k = 0; k < 3; k++) arb_init(across + k);
  set_line(law->lines[TP_WEDGE_ALONG], forces, shape->line);
  for (int joint = 0; joint < 2; joint++) {
    const arb_struct *normal = shape->normals[TP_WEDGE_A + joint];
    set_line(law->lines[TP_WEDGE_PRESS_A + joint], forces, normal);
    for (int i = 0; i < 3; i++) {
      arb_struct *own = law->lines[TP_WEDGE_PRESS_A + joint] + i;
      arb_neg(own, own);
    }
    tp_wedge_cross(across, normal, shape->line);
    set_line(law->lines[TP_WEDGE_ACROSS_A + joint], forces, across);
  }
  set_normal_lines(law, shape);
  set_strength(law, forces, &scene->solid.wedge);
  for (int k = 0; k < 3; k++) arb_clear(across + k);
}

void tp_wedge_law_clear(tp_wedge_law *law) {
  each(law, arb_clear);
}

/* ---- at a force --------------------------------------------------------------------------------
 */

void tp_wedge_values_init(arb_struct values[TP_WEDGE_LINES]) {
  for (int k = 0; k < TP_WEDGE_LINES; k++) arb_init(values + k);
}

void tp_wedge_values_clear(arb_struct values[TP_WEDGE_LINES]) {
  for (int k = 0; k < TP_WEDGE_LINES; k++) arb_clear(values + k);
}

void tp_wedge_values(arb_struct values[TP_WEDGE_LINES], const tp_wedge_law *law, const arb_t east,
                     const arb_t north, bool slopes) {
  for (int k = 0; k < TP_WEDGE_LINES; k++) {
    arb_mul(values + k, law->lines[k] + 1, east, BITS);
    arb_addmul(values + k, law->lines[k] + 2, north, BITS);
    if (!slopes) arb_add(values + k, values + k, law->lines[k], BITS);
  }
}

tp_wedge_way tp_wedge_way_of(const arb_struct values[TP_WEDGE_LINES]) {
  const arb_struct *normals = values + TP_WEDGE_NORMAL_A, *press = values + TP_WEDGE_PRESS_A;
  if (arb_is_nonnegative(normals) && arb_is_nonnegative(normals + 1)) return TP_WEDGE_ON_BOTH;
  if (arb_is_positive(press) && arb_is_negative(normals + 1)) return TP_WEDGE_ON_A;
  if (arb_is_positive(press + 1) && arb_is_negative(normals)) return TP_WEDGE_ON_B;
  const bool off_b = arb_is_negative(normals + 1) && arb_is_nonpositive(press);
  const bool off_a = arb_is_negative(normals) && arb_is_nonpositive(press + 1);
  const bool none = (off_b && arb_is_nonnegative(normals)) ||
                    (off_a && arb_is_nonnegative(normals + 1)) || (off_a && off_b);
  return none ? TP_WEDGE_ON_NONE : TP_WEDGE_UNKNOWN;
}

void tp_wedge_strength(arb_t strength, const tp_wedge_law *law, tp_wedge_way way,
                       const arb_struct values[TP_WEDGE_LINES], bool slopes) {
  arb_zero(strength);
  for (int joint = 0; joint < 2; joint++) {
    const int other = joint == 0 ? TP_WEDGE_ON_B : TP_WEDGE_ON_A;
    if (way == TP_WEDGE_ON_NONE || (int)way == other) continue;
    const int on = (way == TP_WEDGE_ON_BOTH ? TP_WEDGE_NORMAL_A : TP_WEDGE_PRESS_A) + joint;
    arb_addmul(strength, law->friction + joint, values + on, BITS);
    if (!slopes) arb_add(strength, strength, law->cohesion + joint, BITS);
  }
}

void tp_wedge_driving(arb_t driving, tp_wedge_way way, const arb_struct values[TP_WEDGE_LINES]) {
  arb_zero(driving);
  if (way == TP_WEDGE_ON_BOTH) arb_abs(driving, values + TP_WEDGE_ALONG);
  if (way == TP_WEDGE_ON_A || way == TP_WEDGE_ON_B) {
    const int across = way == TP_WEDGE_ON_A ? TP_WEDGE_ACROSS_A : TP_WEDGE_ACROSS_B;
    arb_hypot(driving, values + TP_WEDGE_ALONG, values + across, BITS);
  }
}

bool tp_wedge_law_at(tp_wedge_way *way, arb_t driving, arb_t strength, const tp_wedge_law *law,
                     const arb_t east, const arb_t north) {
  arb_struct values[TP_WEDGE_LINES];
  tp_wedge_values_init(values);
  tp_wedge_values(values, law, east, north, false);
  *way = tp_wedge_way_of(values);
  if (*way != TP_WEDGE_UNKNOWN) {
    tp_wedge_strength(strength, law, *way, values, false);
    tp_wedge_driving(driving, *way, values);
  }
  tp_wedge_values_clear(values);
  return *way != TP_WEDGE_UNKNOWN;
}

void tp_wedge_direction(arb_t east, arb_t north, double half_turns) {
  arb_set_d(north, half_turns);
  arb_sin_cos_pi(east, north, north, BITS);
}
