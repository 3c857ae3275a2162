/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lines that cut the section of a slope into cells: its own outline, the base, the traces of its
 * joints; all as segments between exact points.
 *
 * Here every face dips to the left: one that dips to the right is mirrored, and so are the blocks
 * that come of it. */

#ifndef TP_JOINTING_CUTS_H
#define TP_JOINTING_CUTS_H

#include "scene/scene.h"

#include "common/outside.h"

typedef enum tp_cut_kind {
  TP_CUT_SURFACE, /* of the ground */
  TP_CUT_END,     /* of the section, on the left and on the right */
  TP_CUT_BOTTOM,  /* of the section */
  TP_CUT_BASE,
  TP_CUT_TRACE
} tp_cut_kind;

/* What a segment is of; of a base or a trace the set that it belongs to, or TP_EDGE_OF_BASE. */
typedef struct tp_cut {
  tp_cut_kind kind;
  int set;
} tp_cut;

typedef struct tp_cut_point {
  fmpq_t x, y;
} tp_cut_point;

/* The line of a joint: through its foot, next to the toe, along a unit vector of fractions. */
typedef struct tp_joint_trace {
  long number; /* of its set, from that next to the toe on */
  bool left;   /* what lies behind it, as seen from the toe, is on the left of `along` */
  tp_cut_point foot, along;
} tp_joint_trace;

/* Those of a set that may meet the section, in the order of the distances of their feet. */
typedef struct tp_joint_traces {
  long count, room;
  tp_joint_trace *lines;
} tp_joint_traces;

/* Segments, `ends` four numbers of each, with the corners of the section clockwise, as
 * doubles too, and the traces of each set. */
typedef struct tp_cuts {
  const tp_jointed_slope *slope;
  long count, room, ends_room;
  fmpq *ends;
  tp_cut *of;
  tp_cut_point toe;
  long corner_count;
  tp_cut_point *corners;
  double *x, *y; /* of the corners, from the toe */
  tp_joint_traces *traces;
} tp_cuts;

/* Nothing cut yet. On failure `cuts` is cleared. */
TP_MUST_USE tp_status tp_cuts_init(tp_cuts *cuts, const tp_jointed_slope *slope,
                                   tp_message *message);
void tp_cuts_clear(tp_cuts *cuts);

void tp_cut_point_init(tp_cut_point *point);
void tp_cut_point_clear(tp_cut_point *point);
/* p + length * direction. */
void tp_cut_point_go(tp_cut_point *result, const tp_cut_point *p, const fmpq_t length,
                     const tp_cut_point *direction);
/* The unit vector of an angle to x, from -180 to 180 degrees, as fractions that are off by less
 * than 1e-8 degrees: with t a fraction near tan(angle / 2), ((1 - t^2) / (1 + t^2), 2 t / (1 +
 * t^2)). */
void tp_direction_of_degrees(tp_cut_point *direction, const fmpq_t angle_deg);

/* A segment, unless both ends are one point. False when memory is exhausted. */
TP_MUST_USE bool tp_cuts_add(tp_cuts *cuts, const tp_cut_point *from, const tp_cut_point *to,
                             tp_cut of);

/* Greatest and least of the corners along a unit vector, from the toe; and the greatest distance of
 * two of them, or a little more. */
void tp_cuts_reach(const tp_cuts *cuts, const tp_cut_point *direction, double *least, double *most);
double tp_cuts_size(const tp_cuts *cuts);

/* A set is named by what the scene calls it, else by its number. */
tp_quote tp_joint_set_name(const tp_jointed_slope *slope, long set);

#endif
