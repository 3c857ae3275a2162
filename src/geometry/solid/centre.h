/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The centroid of a solid over a plane that it rests on, and about the edges of its support: what
 * poses and tilts are made of, in doubles with bounds where these do, else in whole numbers.
 *
 * A plane is given by a vector `up` across it, of whole numbers and any length, and by a vertex
 * that lies on it. With G = M / (4 V6), the centroid of the sums V6 and M = (X24, Y24, Z24), height
 * H = up . (G - p) / |up|, arm      about an edge from q to r  a = ((r - q) x (G - q)) . up / |(r -
 * q) x up|: how far the foot of the centroid lies inside of the edge, where the support lies to its
 * left seen from above. The block tilts about it at tan alpha = a / H. */

#ifndef TP_SOLID_CENTRE_H
#define TP_SOLID_CENTRE_H

#include "solid/solid_sums.h"
#include "topple.h"

typedef struct tp_centre {
  const tp_surface *surface;
  const tp_surface *summed; /* within which all is of one weight; NULL: there is none */
  tp_level level;           /* the level of the sums: double or exact */
  tp_near near[3];          /* G, as the surface's `near` */
  tp_near volume6;          /* V6, as the surface has it */
  fmpz_t weight4;           /* 4 V6 and M, at the level exact */
  fmpz moment[3];
} tp_centre;

/* Of the sums of doubles; of exact sums, times `multiple`. */
void tp_centre_of_near(tp_centre *centre, const tp_surface *surface, const tp_near *sums);
void tp_centre_of_exact(tp_centre *centre, const tp_surface *surface, const fmpz *sums,
                        const fmpz_t multiple);
void tp_centre_clear(tp_centre *centre);

typedef struct tp_rest_plane {
  fmpz up[3];
  tp_near near_up[3]; /* times a power of two */
  long vertex;        /* on it */
} tp_rest_plane;

/* Across the plane of three vertices, seen counter-clockwise from below; up is at least one
 * whole number that is not zero. To be cleared. */
void tp_rest_plane_below(tp_rest_plane *plane, const tp_surface *surface, const int corners[3]);
void tp_rest_plane_across(tp_rest_plane *plane, const fmpz up[3], long vertex);
void tp_rest_plane_clear(tp_rest_plane *plane);

/* A number to be told to `accuracy` of itself where that is above 0, else its sign alone: an error
 * of more says that the level does not tell. Both times |up|, the arm times |(r - q) x up|. */
tp_near tp_centre_height(const tp_centre *centre, const tp_rest_plane *plane, double accuracy);
tp_near tp_centre_arm(const tp_centre *centre, const tp_rest_plane *plane, long from, long to,
                      double accuracy);

/* At the level exact where the sums are those of one surface whose points have no weights: false,
 * and empty, where they are not. To be cleared. */
bool tp_centre_exactly(tp_centre *exact, const tp_centre *centre);

/* At the level exact: the sign of the height over one plane less that over another, both above 0.
 */
int tp_centre_compare_heights(const tp_centre *centre, const tp_rest_plane *one,
                              const tp_rest_plane *other);

/* At the level exact: the sign of how far the foot lies beyond one edge, from[0] to to[0], less how
 * far beyond another one. */
int tp_centre_compare_beyond(const tp_centre *centre, const tp_rest_plane *plane,
                             const long from[2], const long to[2]);

/* (to - from) x up, in the plane across the edge and out of the support. */
void tp_rest_plane_outward(tp_near outward[3], const tp_surface *surface,
                           const tp_rest_plane *plane, long from, long to);

/* |v| */
tp_near tp_near_norm(const tp_near v[3]);

/* Does a number tell what was asked for? */
static inline bool tp_near_tells(tp_near number, double accuracy) {
  if (accuracy > 0) return number.error <= accuracy * fabs(number.value);
  return tp_near_sign(number) != 0 || tp_near_is_zero(number);
}

#endif
