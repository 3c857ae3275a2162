/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The axis is across two normals that are not parallel. Of contacts that all face one way it is
 * across their normal and the load. */

#include "solid_contacts/solid_section.h"

#include "solid_contacts/solid_section_modes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void nearest(double near[3], const fmpq v[3]) {
  for (int k = 0; k < 3; k++) near[k] = fmpq_get_d(v + k);
}

static double length_of(const fmpq v[3]) {
  double near[3];
  nearest(near, v);
  return sqrt(near[0] * near[0] + near[1] * near[1] + near[2] * near[2]);
}

/* ---- the axis ----------------------------------------------------------------------------------
 */

/* Loads are rational to 2^-100 of the weight (hold_frame.h). */
static bool is_across(const fmpq axis[3], const fmpq load[3]) {
  fmpq_t along;
  fmpq_init(along);
  tp_rational3_dot(along, axis, load);
  const double part = fmpq_get_d(along);
  fmpq_clear(along);
  return fabs(part) <= ldexp(1, -90) * length_of(axis) * length_of(load);
}

static bool find_axis(tp_solid_section *s, const tp_friction_cones *cones, const fmpq load[3]) {
  const fmpq *first = cones->cones[0].normal;
  for (long n = 1; n < cones->count && tp_rational3_is_zero(s->axis); n++) {
    tp_rational3_cross(s->axis, first, cones->cones[n].normal);
  }
  if (tp_rational3_is_zero(s->axis)) tp_rational3_cross(s->axis, first, load);
  if (tp_rational3_is_zero(s->axis)) return false;
  for (long n = 1; n < cones->count; n++) {
    if (tp_rational3_sign(s->axis, cones->cones[n].normal) != 0) return false;
  }
  tp_rational3_set(s->along[0], first);
  tp_rational3_cross(s->along[1], s->axis, s->along[0]);
  return is_across(s->axis, load);
}

/* ---- inertia -----------------------------------------------------------------------------------
 */

/* S axis, of the second moments S. */
static void turn_second(double turned[3], const double second[6], const double axis[3]) {
  const double *s = second;
  turned[0] = s[0] * axis[0] + s[5] * axis[1] + s[4] * axis[2];
  turned[1] = s[5] * axis[0] + s[1] * axis[1] + s[3] * axis[2];
  turned[2] = s[4] * axis[0] + s[3] * axis[1] + s[2] * axis[2];
}

/* M, per mass; false where the axis is no principal one. */
static bool set_mass(tp_solid_section *s, const tp_solid_section_inertia *inertia) {
  static const double close = 1e-12;
  double axis[3], turned[3];
  const double *second = inertia->second, trace = second[0] + second[1] + second[2];
  nearest(axis, s->axis);
  turn_second(turned, second, axis);
  const double length = length_of(s->axis);
  const double along =
      (turned[0] * axis[0] + turned[1] * axis[1] + turned[2] * axis[2]) / (length * length);
  for (int k = 0; k < 3; k++) {
    if (!(fabs(turned[k] - along * axis[k]) <= close * trace * length)) return false;
  }
  for (int k = 0; k < 2; k++) tp_rational3_dot(s->mass + k, s->along[k], s->along[k]);
  const double turning = (trace - along) * length * length;
  if (!(turning > 0)) return false;
  tp_hold_double(s->mass + 2, turning);
  return true;
}

/* ---- contacts ----------------------------------------------------------------------------------
 */

static void set_wrench(fmpq wrench[3], const tp_solid_section *s, const fmpq at[3],
                       const fmpq force[3]) {
  fmpq moment[3];
  tp_rational3_init(moment);
  for (int k = 0; k < 2; k++) tp_rational3_dot(wrench + k, force, s->along[k]);
  tp_rational3_cross(moment, at, force);
  tp_rational3_dot(wrench + 2, moment, s->axis);
  tp_rational3_clear(moment);
}

static void contact_init(tp_solid_section_contact *c) {
  tp_rational3_init(c->normal);
  tp_rational3_init(c->slip);
  fmpq_init(c->at);
  fmpq_init(c->at + 1);
  fmpq_init(&c->friction);
  c->sides = 0;
}

static void contact_clear(tp_solid_section_contact *c) {
  tp_rational3_clear(c->normal);
  tp_rational3_clear(c->slip);
  fmpq_clear(c->at);
  fmpq_clear(c->at + 1);
  fmpq_clear(&c->friction);
}

static void set_contact(tp_solid_section_contact *c, const tp_solid_section *s,
                        const tp_friction_cone *cone) {
  fmpq slip[3];
  fmpq_t side;
  tp_rational3_init(slip);
  fmpq_init(side);
  set_wrench(c->normal, s, cone->at, cone->normal);
  tp_rational3_cross(slip, s->axis, cone->normal);
  set_wrench(c->slip, s, cone->at, slip);
  for (int k = 0; k < 2; k++) tp_rational3_dot(c->at + k, cone->at, s->along[k]);
  tp_hold_double(&c->friction, cone->friction.value / length_of(s->axis));
  tp_rational3_dot(side, cone->at, s->axis);
  const int sign = fmpq_sgn(side);
  c->sides = sign < 0 ? 1 : sign > 0 ? 2 : 3;
  tp_rational3_clear(slip);
  fmpq_clear(side);
}

/* The same line along the axis, normal and friction: normals may differ in length. */
static bool is_partner(const tp_solid_section_contact *a, const tp_solid_section_contact *b) {
  fmpq across[3];
  if (!fmpq_equal(a->at, b->at) || !fmpq_equal(a->at + 1, b->at + 1) ||
      !fmpq_equal(&a->friction, &b->friction)) {
    return false;
  }
  tp_rational3_init(across);
  tp_rational3_cross(across, a->normal, b->normal);
  const bool same = tp_rational3_is_zero(across) && tp_rational3_sign(a->normal, b->normal) > 0;
  tp_rational3_clear(across);
  return same;
}

/* Do normal forces at two points differ as wrenches? Else the solid is on one line. */
static bool has_width(const tp_solid_section *s) {
  fmpq across[3];
  bool found = false;
  tp_rational3_init(across);
  for (int k = 1; k < s->count && !found; k++) {
    tp_rational3_cross(across, s->contacts[0].normal, s->contacts[k].normal);
    found = !tp_rational3_is_zero(across);
  }
  tp_rational3_clear(across);
  return found;
}

/* False: there are too many, or a contact has no partner on the other side. */
static bool set_contacts(tp_solid_section *s, const tp_friction_cones *cones) {
  for (long n = 0; n < cones->count; n++) {
    if (s->count == TP_SOLID_SECTION_CONTACTS) return false;
    tp_solid_section_contact *entry = s->contacts + s->count;
    contact_init(entry);
    set_contact(entry, s, cones->cones + n);
    int k = 0;
    while (k < s->count && !is_partner(s->contacts + k, entry)) k++;
    s->contacts[k].sides |= entry->sides;
    if (k == s->count) {
      s->count++;
    } else {
      contact_clear(entry);
    }
  }
  for (int k = 0; k < s->count; k++) {
    if (s->contacts[k].sides != 3) return false;
  }
  return has_width(s);
}

/* ---- all ---------------------------------------------------------------------------------------
 */

bool tp_solid_section_init(bool *has_section, tp_solid_section *section,
                           const tp_friction_cones *cones, const tp_solid_section_inertia *inertia,
                           const fmpq load[3]) {
  memset(section, 0, sizeof *section);
  tp_rational3_init(section->axis);
  for (int k = 0; k < 2; k++) tp_rational3_init(section->along[k]);
  tp_rational3_init(section->mass);
  *has_section = cones->count > 1 && find_axis(section, cones, load) &&
                 set_mass(section, inertia) && set_contacts(section, cones);
  return !*has_section || tp_solid_section_find_modes(section);
}

void tp_solid_section_clear(tp_solid_section *section) {
  tp_rational3_clear(section->axis);
  for (int k = 0; k < 2; k++) tp_rational3_clear(section->along[k]);
  tp_rational3_clear(section->mass);
  for (int k = 0; k < section->count; k++) contact_clear(section->contacts + k);
  for (long k = 0; k < section->ray_count; k++) {
    tp_rational3_clear(section->rays[k].twist);
    tp_rational3_clear(section->rays[k].wrench);
  }
  free(section->rays);
  free(section->modes);
  memset(section, 0, sizeof *section);
}

bool tp_solid_section_has_load(const tp_solid_section *section, const tp_hold_load *load) {
  return is_across(section->axis, load->exact);
}
