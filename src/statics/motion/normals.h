/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact points of cones, put together by the lines of their normals.
 *
 * A twist a = (v_x, v_y, theta) about the origin gives the point q the velocity
 * (v_x - theta q_y, v_y + theta q_x). With the facet's direction t in whole numbers without common
 * divisor and n = (-t_y, t_x) its components are
 *
 *     along n: h . a,  h = (-t_y, t_x, t . q);      along t: g . a,  g = (t_x, t_y, t_y q_x - t_x
 * q_y).
 *
 * Points with the same h lie on one normal line. Those with one t are a family, sorted by t . q:
 * its first and its last line alone decide what a twist may do. Families with t and with -t have
 * the same axis. Coordinates are whole numbers, but for the tangent points of rounded corners. */

#ifndef TP_MOTION_NORMALS_H
#define TP_MOTION_NORMALS_H

#include "linear_program/cones.h"
#include "number/judge.h"
#include "number/near.h"
#include "plane/vector.h"
#include "topple.h"

typedef struct tp_normal {
  int32_t first, count; /* in `order` */
  int32_t family;
  double near[3]; /* h in doubles (tp_normals_near) */
} tp_normal;

typedef struct tp_contact_family {
  int32_t first, count; /* of the normals */
  int32_t axis;
  int sense;   /* of t along the axis: 1 or -1 */
  fmpz tx, ty; /* t, without common divisor */
} tp_contact_family;

typedef struct tp_normals {
  const tp_cones *cones;
  tp_judge judge;                 /* its precision is that of the coordinates */
  int32_t *order;                 /* all points, line after line */
  int32_t *normal_of, *family_of; /* by point */
  int32_t *same;                  /* by point: the first with its site and friction on its line */
  long count;
  tp_normal *items;
  long family_count;
  tp_contact_family *families;
} tp_normals;

typedef enum tp_motion_outcome {
  TP_MOTION_PROVEN,
  TP_MOTION_OPEN, /* more bits are needed */
  TP_MOTION_TOO_DEAR,
  TP_MOTION_OUT_OF_MEMORY
} tp_motion_outcome;

/* The cones are borrowed. On failure `normals` is cleared. */
TP_MUST_USE tp_motion_outcome tp_normals_init(tp_normals *normals, const tp_cones *cones,
                                              const tp_judge *judge);
void tp_normals_clear(tp_normals *normals);

/* t of a point, without common divisor. */
const fmpz *tp_normals_tx(const tp_normals *normals, long point);
const fmpz *tp_normals_ty(const tp_normals *normals, long point);

/* A point's place in doubles. */
void tp_normals_place_near(tp_near *x, tp_near *y, const tp_normals *normals, long point);

/* h of a line. */
void tp_normals_set_h(tp_vector *h, const tp_normals *normals, long normal);

/* Sign of h . a, by doubles where they tell, or TP_OPEN_SIGN: `near` is a in doubles. A twist about
 * a site, or -1, lies on the lines through it. */
int tp_normal_sign(const tp_normals *normals, const tp_normal *normal, const tp_vector *twist,
                   const double near[3], long site);

/* g . a of a point; its sign, by doubles where they tell, or TP_OPEN_SIGN. */
void tp_normals_slip_ball(arb_t along, const tp_normals *normals, long point,
                          const tp_vector *twist);
int tp_normals_slip(const tp_normals *normals, long point, const tp_vector *twist,
                    const double near[3]);

/* n + t tan(phi), or n - t tan(phi) `against` t, at the judge's bits; the moment is left alone. */
void tp_normals_edge(tp_vector *force, const tp_normals *normals, long point, bool against);

/* Does a point on the line lie in the site? */
bool tp_normal_has_site(const tp_normals *normals, const tp_normal *normal, long site);

/* A family's points: in `order` from one index to before the other. */
void tp_normals_of_family(long ends[2], const tp_normals *normals, long family);

/* Do two points, with their facets, lie on one straight line, with the same side of it free? 1, 0,
 * or TP_OPEN_SIGN. */
int tp_normals_share_line(const tp_normals *normals, long point, long other);

/* A number over 2^exponent by its highest limb: none above another comes below it. Zero where it is
 * none, or its exponent is too large for a word. */
double tp_normals_top(const arf_struct *number, slong exponent);

/* A vector in doubles, times a power of two, each to 2^-50 of itself or so; zeros where one is too
 * small beside the largest. */
void tp_normals_near(double near[3], const tp_vector *vector);

/* That with its bounds; false where it does not tell. */
bool tp_normals_set_near(tp_near own[3], const double near[3]);

#endif
