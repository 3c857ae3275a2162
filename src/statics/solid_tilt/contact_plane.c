/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Whether points are a plane is exact; that the foot is within them is proven as a load across the
 * plane is, without friction. */

#include "solid_tilt/contact_plane.h"

#include "solid_contacts/solid_section_parts.h"

#include <math.h>
#include <stdlib.h>

static bool is_in_plane(const tp_friction_cones *cones) {
  fmpq way[3];
  bool within = true;
  tp_rational3_init(way);
  for (long n = 1; n < cones->count && within; n++) {
    for (int k = 0; k < 3; k++) fmpq_sub(way + k, cones->cones[n].at + k, cones->cones[0].at + k);
    within = tp_rational3_sign(way, cones->cones[0].normal) == 0 &&
             cones->cones[n].friction.value == cones->cones[0].friction.value;
    tp_rational3_cross(way, cones->cones[n].normal, cones->cones[0].normal);
    within = within && tp_rational3_is_zero(way) &&
             tp_rational3_sign(cones->cones[n].normal, cones->cones[0].normal) > 0;
  }
  tp_rational3_clear(way);
  return within;
}

static bool find_foot(bool *within, const tp_friction_cones *cones) {
  tp_friction_cones smooth = {.count = cones->count,
                              .cones = calloc((size_t)cones->count + 1, sizeof *smooth.cones)};
  tp_hold hold;
  tp_hold_load load;
  tp_hold_side side = TP_HOLD_OPEN;
  double twist[TP_WRENCH];
  if (smooth.cones == NULL) return false;
  for (long n = 0; n < cones->count; n++) {
    smooth.cones[n] = cones->cones[n];
    smooth.cones[n].friction = (tp_near){0, 0};
  }
  tp_hold_load_init(&load);
  for (int k = 0; k < 3; k++) tp_hold_double(load.exact + k, -cones->cones[0].near_normal[k].value);
  if (cones->count > 0) {
    /* along the normal exactly: of about its size */
    fmpq_t share;
    fmpq_init(share);
    for (int k = 0; k < 3 && fmpq_is_zero(share); k++) {
      if (!fmpq_is_zero(cones->cones[0].normal + k)) {
        fmpq_div(share, load.exact + k, cones->cones[0].normal + k);
      }
    }
    for (int k = 0; k < 3; k++) fmpq_mul(load.exact + k, cones->cones[0].normal + k, share);
    fmpq_clear(share);
  }
  tp_hold_load_settle(&load);
  const bool done =
      tp_hold_init(&hold, &smooth, 1) && tp_hold_load_side(&side, twist, &hold, &load);
  *within = side == TP_HOLD_HOLDS;
  tp_hold_clear(&hold);
  tp_hold_load_clear(&load);
  free(smooth.cones);
  return done;
}

/* ---- inertia -----------------------------------------------------------------------------------
 */

/* About G, over the mass. */
static void set_inertia(double inertia[3][3], const tp_contact_work *w) {
  const tp_solid_section_inertia own = tp_contacts_inertia(w);
  const double *s = own.second, trace = s[0] + s[1] + s[2];
  const double products[3][3] = {{s[0], s[5], s[4]}, {s[5], s[1], s[3]}, {s[4], s[3], s[2]}};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) inertia[i][k] = (i == k ? trace : 0) - products[i][k];
  }
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double form(const double m[3][3], const double a[3], const double b[3]) {
  double sum = 0;
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) sum += a[i] * m[i][k] * b[k];
  }
  return sum;
}

/* n . I^-1 n, by the cofactors. */
static double turning(const double m[3][3], const double n[3]) {
  double cofactors[3][3], determinant = 0;
  for (int i = 0; i < 3; i++) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int k = 0; k < 3; k++) {
      const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      cofactors[i][k] = m[i1][k1] * m[i2][k2] - m[i1][k2] * m[i2][k1];
    }
  }
  for (int k = 0; k < 3; k++) determinant += m[0][k] * cofactors[0][k];
  return form(cofactors, n, n) / determinant;
}

/* h^2 + R^2, R the farthest point from the line along e through the foot. */
static double farthest(const tp_friction_cones *cones, const double n[3], const double e[3]) {
  double height = 0, radius = 0;
  for (long i = 0; i < cones->count; i++) {
    double at[3], side = 0;
    for (int k = 0; k < 3; k++) at[k] = cones->cones[i].near_at[k].value;
    for (int k = 0; k < 3; k++) {
      const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      side += at[k] * (n[k1] * e[k2] - n[k2] * e[k1]);
    }
    height = fmax(height, dot(at, n) * dot(at, n));
    radius = fmax(radius, side * side);
  }
  return height + radius;
}

bool tp_contact_plane_find(bool *is_proven_plane, const tp_contact_work *w) {
  const tp_friction_cones *cones = &w->points.cones;
  *is_proven_plane = false;
  return cones->count == 0 || !is_in_plane(cones) || find_foot(is_proven_plane, cones);
}

bool tp_contact_plane_stays(const tp_contact_work *w, const tp_hold_load *load) {
  static const double noise = 1e-9;
  const tp_friction_cones *cones = &w->points.cones;
  const double *n = cones->cones[0].unit;
  const double across = -dot(load->nearest, n);
  double inertia[3][3], along[3];
  if (!(across > 0)) return false;
  for (int k = 0; k < 3; k++) along[k] = load->nearest[k] + across * n[k];
  const double size = sqrt(dot(along, along));
  if (!(size > noise * across)) return true; /* it is held without friction */
  for (int k = 0; k < 3; k++) along[k] /= size;
  set_inertia(inertia, w);
  const double moment = form(inertia, along, along) + farthest(cones, n, along);
  return size / across * sqrt(moment * turning(inertia, n)) < 2 * (1 - noise);
}
