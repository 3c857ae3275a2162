/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block that rocks on its two toes (Housner, Bull. Seismol. Soc. Am. 53 (1963) 403-417), by one
 * degree of freedom alone: b wide and h high, R = sqrt(b^2 + h^2) / 2, tan(alpha) = b / h,
 * p^2 = 3 g / (4 R); turned by x about a toe, x'' = -p^2 sin(alpha - x) while nothing shakes. */

#ifndef TP_TEST_ROCKING_H
#define TP_TEST_ROCKING_H

#include "body_stage.h"
#include "rigid_contact/rigid_contact.h"

typedef struct rocking {
  double width_m, height_m;
  double radius_m, alpha, p; /* rad, rad/s */
  body_stage stage;
} rocking;

/* On a level base that goes on for twice its size, friction 85 degrees. */
void rocking_init(rocking *r, double width_m, double height_m);
void rocking_clear(rocking *r);

/* Turned about its left toe, at rest. */
tp_body_state rocking_turned(const rocking *r, double angle);

/* A quarter of a period from rest at an angle, by quadrature. */
double rocking_quarter_s(const rocking *r, double angle);

/* Half a sine of base motion, peak over g, from time 0 on. */
typedef struct half_sine {
  tp_base_motion motion;
  double peak_m_s2, frequency_rad_s;
} half_sine;

void half_sine_init(half_sine *pulse, double peak_m_s2, double frequency_rad_s);

/* Does the block overturn under the pulse, before it meets the other toe? By GSL's Runge-Kutta
 * Prince-Dormand method on the one equation. */
bool rocking_overturns(const rocking *r, const half_sine *pulse);

#endif
