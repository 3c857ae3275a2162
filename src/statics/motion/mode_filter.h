/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which planes of a mode's cone of loads (motion/bounds.h) end the tilts at which it can begin, and
 * whether there are such tilts at all, by doubles with bounds (number/near.h). Most modes are ruled
 * out so, and most planes of the others; balls are for the few that are left.
 *
 * For loads that turn with the tilt, F_c cos + F_s sin, without cohesion and bonds: a plane h
 * leaves A + B tan >= 0 with A = h . F_c and B = h . F_s, the mode what all of its planes leave.
 * All that is said here is proven; what doubles do not tell is left open. */

#ifndef TP_MOTION_MODE_FILTER_H
#define TP_MOTION_MODE_FILTER_H

#include "motion/generators.h"
#include "number/near.h"

/* What all modes of a question share. */
typedef struct tp_mode_filter {
  bool applies;
  tp_near scale, x, y, gyration, friction;
  tp_near down[3], across[3]; /* F_c and F_s */
} tp_mode_filter;

void tp_mode_filter_init(tp_mode_filter *filter, const tp_motion_question *question);

typedef enum tp_mode_tilts {
  TP_TILTS_OPEN,   /* doubles do not tell */
  TP_TILTS_NONE,   /* the mode can begin nowhere */
  TP_TILTS_BETWEEN /* or beyond, or before: the planes chosen alone say where */
} tp_mode_tilts;

/* Planes in the order of motion/bounds.h: pairs of generators, or faces of the interior. Those at
 * one end have one source. */
enum { TP_MOST_CHOSEN = 16 };
typedef struct tp_chosen_planes {
  int count;
  long first[TP_MOST_CHOSEN], second[TP_MOST_CHOSEN];
  bool lower[TP_MOST_CHOSEN];  /* at the lower end of the tilts */
  bool below[TP_MOST_CHOSEN];  /* the others lie below the cross product of the pair, */
  long beside[TP_MOST_CHOSEN]; /* as this one does for certain */
} tp_chosen_planes;

/* Of a mode with rays; the generators need no balls for it. */
tp_mode_tilts tp_mode_filter_pairs(tp_chosen_planes *chosen, const tp_mode_filter *filter,
                                   const tp_generators *generators, const tp_twists *twists);

/* Of the interior. */
tp_mode_tilts tp_mode_filter_interior(tp_chosen_planes *chosen, const tp_mode_filter *filter,
                                      const tp_motion_question *question, const tp_normals *normals,
                                      const tp_twists *twists);

#endif
