/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What of a boundary can touch: straight pieces, discs and hollows.
 *
 * Every convex corner is rounded by a small radius: it is a disc that both its edges are tangents
 * of, and the edges end where they touch it. An arc outwards is a disc too, as far as it reaches;
 * an arc inwards is a hollow. Concave corners touch nothing; the
 * edges in one go on into the rock there, so that a disc which presses into both does not leave one
 * of them with a leap. A disc meets a straight piece where
 * its centre stands above that, and another disc where each lies within the reach of the other, so
 * that a contact that runs along a boundary goes from feature to feature without a leap. */

#ifndef TP_CONTACT_SPRINGS_FEATURES_H
#define TP_CONTACT_SPRINGS_FEATURES_H

#include "rigid_body/body.h"

typedef enum tp_feature_kind {
  TP_FEATURE_STRAIGHT,
  TP_FEATURE_DISC,
  TP_FEATURE_HOLLOW
} tp_feature_kind;

typedef struct tp_feature {
  tp_feature_kind kind;
  tp_xy from, tangent, normal;   /* of a straight piece; the normal points out of the rock */
  double length, before, behind; /* it reaches farther by these in concave corners */
  tp_xy centre;
  double radius;
  tp_xy first, last; /* directions from the centre between which it reaches, counter-clockwise */
  double slack_first, slack_last; /* sines by which it reaches farther beside a straight piece */
  double friction;                /* tan(phi); of a disc the lesser one of its edges */
  long facet;                     /* of the base, from 1; of a disc that of an edge beside it */
} tp_feature;

typedef struct tp_features {
  long count; /* in the order of the boundary, which is closed */
  tp_feature *items;
} tp_features;

/* `friction` by edge of the boundary; NULL: none. A corner's radius is less than `radius_m` where
 * its edges are too short for that. False when memory is exhausted. */
TP_MUST_USE bool tp_features_init(tp_features *features, const tp_boundary *boundary,
                                  double radius_m, const double *friction);
void tp_features_clear(tp_features *features);

/* Does a disc, or a hollow, reach into the direction of a unit vector; by `slack` more than it
 * does? */
bool tp_feature_reaches(const tp_feature *feature, tp_xy direction, double slack);

/* The same, with its own slack beside straight pieces. */
bool tp_feature_reaches_beside(const tp_feature *feature, tp_xy direction);

#endif
