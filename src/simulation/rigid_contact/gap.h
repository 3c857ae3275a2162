/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The gap between a part of the block and a part of the base, and how the block's motion changes
 * it.
 *
 * With u = (v_x, v_y, turning) of the block about its centroid, n the normal at the contact into
 * the block and t = (n_y, -n_x) along it (up-dip on level rock), the gap g changes by n . u and the
 * block's point at the contact slips by t . u, where `across` and `along` are these rows; their
 * rates are across . du/dt + across_rate and along . du/dt + along_rate. With C a centre of the
 * block and d = C - G, u_C the velocity of C:
 *
 *   corner of the block on a straight face:  g = (C - p) . n - r, rates -w^2 d . n, -w^2 d . t
 *   corner of the base on a straight face of the block, d from G to the corner's centre:
 *     g' = n . (v + w z x d), rates 2 w (n x v) + w^2 d . n and 2 w (t x v) + w^2 d . t
 *   two arcs, s = 1, or -1 where one of them is hollow, e from the base's centre to C at a distance
 *     l: g = s (l - rho), n = s e, rates s (|u_C|^2 - (e . u_C)^2) / l - w^2 d . n and
 *     (e x u_C / l) (n . u_C) - w^2 d . t
 *
 * where w z x d is the velocity by turning. Everything is over the extent, its square root over
 * gravity, and the mass. */

#ifndef TP_RIGID_CONTACT_GAP_H
#define TP_RIGID_CONTACT_GAP_H

#include "rigid_contact/shape.h"

/* Position and motion of the block: centroid and turn, in these units. */
typedef struct tp_motion_state {
  double place[3], speed[3];
} tp_motion_state;

/* The same as its gaps are worked out from it. */
typedef struct tp_turned_block {
  double sine, cosine, angle;
  tp_xy centroid, velocity;
  double turning;
} tp_turned_block;

tp_turned_block tp_turned_block_at(const tp_motion_state *state);

typedef enum tp_pair_kind {
  TP_CORNER_ON_FACE,
  TP_FACE_ON_CORNER,
  TP_CORNER_ON_CORNER
} tp_pair_kind;

/* What may touch: a part of the block on a part of the base. */
typedef struct tp_gap_pair {
  tp_pair_kind kind;
  long block, base; /* of their corners or faces */
  bool touching;    /* closed when last judged: it counts as closing anew only below a tolerance */
} tp_gap_pair;

bool tp_pair_is(const tp_gap_pair *a, const tp_gap_pair *b);

typedef struct tp_gap {
  double width;  /* below 0: the parts lie in each other, where they do face each other */
  double margin; /* by how much the contact lies within both parts; below 0: they do not face each
                    other */
  double arc_margin;  /* the same of the normals of rounded corners, radians; INFINITY: none */
  double cone_margin; /* by how much the normal lies between those of a sharp corner's edges,
                         radians; INFINITY: no sharp corner. Below 0 at the end of a face the two
                         pass each other. */
  tp_xy normal, tangent, at; /* `at` from the base's origin */
  double across[3], along[3];
  double across_rate, along_rate;
  long base_edges[2]; /* at the contact: before and behind it along the base; equal on a face */
} tp_gap;

typedef struct tp_contact_shapes {
  tp_contact_shape block, base;
} tp_contact_shapes;

tp_gap tp_gap_at(const tp_contact_shapes *shapes, const tp_gap_pair *pair,
                 const tp_motion_state *state);

/* The same at a third of the cost, without the margins of normals, which are INFINITY. */
tp_gap tp_gap_moving(const tp_contact_shapes *shapes, const tp_gap_pair *pair,
                     const tp_turned_block *block);

/* Can the pair close before a point of the block has moved by more than the reach? False only where
 * it cannot: of a straight face, where the corner lies farther from it. */
bool tp_gap_in_reach(const tp_contact_shapes *shapes, const tp_gap_pair *pair,
                     const tp_turned_block *block, double reach);

/* How far beyond the end of a face, or of an arc, a contact may lie: more than what a closed gap in
 * a flat notch moves it (over the extent; radians). */
#define TP_FACE_SLACK 1e-9

/* Do the parts face each other where the gap is zero? */
bool tp_gap_faces(const tp_gap *gap);

/* How fast the gap changes, and how fast the block's point slips. */
double tp_gap_speed(const double row[3], const double speed[3]);

#endif
