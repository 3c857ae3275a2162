/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* When a wedge slides as a horizontal force of t times its weight towards an azimuth comes on top
 * of all that pushes it otherwise: R = R_0 + t W u, u = (sin z, cos z, 0).
 *
 * With a, b the upward normals of the joints, l the unit vector up their line, k = a . b:
 *     N_a = (-R . a + k R . b) / (1 - k^2), likewise N_b, as it is held by both;
 *     both  N_a, N_b >= 0:            strength C_a + C_b + N_a tan(phi_a) + N_b tan(phi_b)
 *                                     over |R . l|;
 *     A     -R . a > 0, N_b < 0:      strength C_a - R . a tan(phi_a) over |R + (-R . a) a|, of
 *                                     which the parts along l and along a x l are linear in R;
 *     B     likewise;
 *     none  else: nothing holds it.
 * All these are lines over the plane of (t sin z, t cos z). Those on which N_a, N_b, R . a or R . b
 * vanish meet in one point V, where R is along l: they part the plane into four convex cones, of
 * the four ways. In each, strength less what drives it is concave, so that on a part of a disc that
 * does not reach V it is least on the circle; and beside V is a cone where nothing holds it. So a
 * wedge stands for all horizontal forces up to t just if it does for all that are t. */

#ifndef TP_SOLID_TILT_WEDGE_LAW_H
#define TP_SOLID_TILT_WEDGE_LAW_H

#include "solid_tilt/wedge_forces.h"

/* Bits that lines are evaluated in: the shape has twice as many. */
enum { TP_WEDGE_LAW_BITS = 128 };

typedef enum tp_wedge_way {
  TP_WEDGE_ON_BOTH,
  TP_WEDGE_ON_A,
  TP_WEDGE_ON_B,
  TP_WEDGE_ON_NONE,
  TP_WEDGE_WAYS,
  TP_WEDGE_UNKNOWN = TP_WEDGE_WAYS /* too close to tell */
} tp_wedge_way;

/* In words: a and b, a, b, neither. */
const char *tp_wedge_way_name(tp_wedge_way way);

enum {
  TP_WEDGE_NORMAL_A,
  TP_WEDGE_NORMAL_B, /* N_a, N_b */
  TP_WEDGE_PRESS_A,
  TP_WEDGE_PRESS_B, /* -R . a, -R . b */
  TP_WEDGE_ALONG,   /* R . l */
  TP_WEDGE_ACROSS_A,
  TP_WEDGE_ACROSS_B, /* R . (a x l), R . (b x l) */
  TP_WEDGE_LINES
};

typedef struct tp_wedge_law {
  arb_struct lines[TP_WEDGE_LINES][3]; /* without the force, and for t = 1 to the east, north */
  arb_struct cohesion[2];              /* C_a, C_b */
  arb_struct friction[2];              /* tan(phi) */
} tp_wedge_law;

void tp_wedge_law_init(tp_wedge_law *law, const tp_wedge_forces *forces,
                       const tp_wedge_shape *shape, const tp_scene *scene);
void tp_wedge_law_clear(tp_wedge_law *law);

/* What drives it and what holds it at a force to the east and to the north, in kN; false: it is not
 * certain which way it goes. Nothing drives or holds it where it is on none. */
bool tp_wedge_law_at(tp_wedge_way *way, arb_t driving, arb_t strength, const tp_wedge_law *law,
                     const arb_t east, const arb_t north);

/* The values of all lines at a force, or how they change with it: the same without what is there
 * without it. To be cleared. */
void tp_wedge_values_init(arb_struct values[TP_WEDGE_LINES]);
void tp_wedge_values_clear(arb_struct values[TP_WEDGE_LINES]);
void tp_wedge_values(arb_struct values[TP_WEDGE_LINES], const tp_wedge_law *law, const arb_t east,
                     const arb_t north, bool slopes);

/* By them: which way it goes, and on one, what holds it and what drives it; of slopes, how what
 * holds it changes. */
tp_wedge_way tp_wedge_way_of(const arb_struct values[TP_WEDGE_LINES]);
void tp_wedge_strength(arb_t strength, const tp_wedge_law *law, tp_wedge_way way,
                       const arb_struct values[TP_WEDGE_LINES], bool slopes);
void tp_wedge_driving(arb_t driving, tp_wedge_way way, const arb_struct values[TP_WEDGE_LINES]);

/* The azimuth of so many half turns: (sin, cos), of a double exactly. */
void tp_wedge_direction(arb_t east, arb_t north, double half_turns);

#endif
