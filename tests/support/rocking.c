/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "rocking.h"

#include <check.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdio.h>

static const double pi = 3.141592653589793;

void rocking_init(rocking *r, double width_m, double height_m) {
  char text[400];
  snprintf(
      text, sizeof text,
      "topple: 1\nlength_unit: m\nfriction_angle_deg: 85\nblock: {slab: {width: %.17g, height: "
      "%.17g}, unit_weight_kn_m3: 25}\nbase: {mated: true, beyond: {left: %.17g, right: "
      "%.17g}}\n",
      width_m, height_m, 2 * height_m, 2 * height_m);
  r->width_m = width_m;
  r->height_m = height_m;
  r->radius_m = hypot(width_m, height_m) / 2;
  r->alpha = atan2(width_m, height_m);
  r->p = sqrt(3 * TP_GRAVITY_M_S2 / (4 * r->radius_m));
  body_stage_init(&r->stage, text, TP_TOWARDS_LEFT);
}

void rocking_clear(rocking *r) {
  body_stage_clear(&r->stage);
}

tp_body_state rocking_turned(const rocking *r, double angle) {
  const double x = -r->width_m / 2, y = -r->height_m / 2;
  return (tp_body_state){
      .moved = {x - cos(angle) * x + sin(angle) * y, y - sin(angle) * x - cos(angle) * y},
      .turned = angle};
}

typedef struct quarter {
  double alpha, angle;
} quarter;

/* dt = dx / x', x'^2 = 2 p^2 (cos(alpha - angle) - cos(alpha - x)); with x = angle - s^2 the
 * integrand has no pole, and cos a - cos(a + b) = 2 sin(a + b / 2) sin(b / 2). */
static double integrand(double s, void *context) {
  const quarter *q = context;
  const double a = q->alpha - q->angle, b = s * s;
  const double part = b == 0 ? 0.5 : sin(b / 2) / b;
  return 2 / sqrt(4 * sin(a + b / 2) * part);
}

double rocking_quarter_s(const rocking *r, double angle) {
  quarter q = {r->alpha, angle};
  const gsl_function f = {integrand, &q};
  double value, error;
  gsl_integration_workspace *work = gsl_integration_workspace_alloc(100);
  ck_assert_int_eq(gsl_integration_qag(&f, 0, sqrt(angle), 0, 1e-13, 100, GSL_INTEG_GAUSS61, work,
                                       &value, &error),
                   0);
  gsl_integration_workspace_free(work);
  return value / r->p;
}

static void shake(double *horizontal, double *vertical, const tp_base_motion *motion, double t) {
  const half_sine *own = motion->data;
  const bool during = t > 0 && t * own->frequency_rad_s < pi;
  *horizontal = during ? own->peak_m_s2 * sin(own->frequency_rad_s * t) : 0;
  *vertical = 0;
}

static double next_kink(const tp_base_motion *motion, double t) {
  const half_sine *own = motion->data;
  const double end = pi / own->frequency_rad_s;
  return t < 0 ? 0 : t < end ? end : INFINITY;
}

void half_sine_init(half_sine *pulse, double peak_m_s2, double frequency_rad_s) {
  *pulse = (half_sine){.motion = {pulse, shake, next_kink},
                       .peak_m_s2 = peak_m_s2,
                       .frequency_rad_s = frequency_rad_s};
}

typedef struct equation {
  const rocking *r;
  const half_sine *pulse;
} equation;

/* Base motion to the right throws the block to the left, about its left toe: x'' = -p^2 (sin(alpha
 * - x) - a / g cos(alpha - x)). */
static int rate(double t, const double y[], double rates[], void *context) {
  const equation *e = context;
  double a, none;
  shake(&a, &none, &e->pulse->motion, t);
  const double off = e->r->alpha - y[0], p2 = e->r->p * e->r->p;
  rates[0] = y[1];
  rates[1] = -p2 * (sin(off) - a / TP_GRAVITY_M_S2 * cos(off));
  return 0;
}

bool rocking_overturns(const rocking *r, const half_sine *pulse) {
  equation e = {r, pulse};
  const double begins = asin(TP_GRAVITY_M_S2 * tan(r->alpha) / pulse->peak_m_s2);
  const double end = pi / pulse->frequency_rad_s;
  double t = begins / pulse->frequency_rad_s, y[2] = {0, 0};
  gsl_odeiv2_system system = {rate, NULL, 2, &e};
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-4 / r->p, 1e-13, 0);
  ck_assert_int_eq(gsl_odeiv2_driver_apply(driver, &t, end, y), 0);
  gsl_odeiv2_driver_reset(driver);
  /* Then x' and the energy say it: past the top, or turning towards it with enough. */
  while (y[0] > 0 && y[0] < r->alpha) {
    ck_assert_int_eq(gsl_odeiv2_driver_apply(driver, &t, t + 0.05 / r->p, y), 0);
  }
  gsl_odeiv2_driver_free(driver);
  return y[0] > 0;
}
