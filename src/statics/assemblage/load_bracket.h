/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The greatest load that some forces hold, between two proofs (the static and the kinematic theorem
 * of limit analysis, with contacts that dilate by their friction).
 *
 * Below: forces of an iterate hold each block up to a rounding. What each is off by is carried
 * along a tree of contacts to the ground, and added to what each contact of the tree exerts; where
 * all forces, enclosed, then stay in their cones, equilibrium at that load is proven. Above: where
 * an iterate's twists, taken as they are, open every contact, w0 . v over -w1 . v is proven to be
 * no less than any load that can be held. Both take a pass over the contacts, in doubles with their
 * bounds. */

#ifndef TP_ASSEMBLAGE_LOAD_BRACKET_H
#define TP_ASSEMBLAGE_LOAD_BRACKET_H

#include "assemblage/interior_point.h"

#define TP_MOST_LOAD 1e6

typedef struct tp_load_bracket {
  bool is_held, is_bounded; /* is there a proof below, above? */
  double held;              /* forces hold that load, or one the other way; not looked for
                               beyond TP_MOST_LOAD */
  double bound;    /* none hold more; below zero: none hold it without a load the other way */
  bool is_settled; /* the search came near the limit, or to what is enough; else a bound may
                      be far above it */
  double *forces, *twists; /* of these proofs, by column and by row, where there is one */
} tp_load_bracket;

/* How much is to be proven. Forces near the limit cost most of the search. */
typedef struct tp_bracket_aim {
  double share;     /* the width of the bracket, over the limit or a thousandth if that is more */
  bool bound_alone; /* forces that hold it are not asked for: they are those nearest to the bound */
  double enough;    /* forces that hold so much will do; an infinity: the greatest load */
  bool asks;        /* a twentieth of how far the limit is from `asked` will do too */
  double asked;
  tp_interior_from from;
} tp_bracket_aim;

/* Where the aim is not to be had, the nearest proofs. On failure cleared. */
TP_MUST_USE tp_status tp_load_bracket_find(tp_load_bracket *bracket,
                                           const tp_force_program *program,
                                           const tp_bracket_aim *aim, tp_message *message);
/* How near a share of a limit is to it. Nothing is known more closely than a share of a thousandth
 * of the weights: forces are not solved for to less. */
double tp_load_width(const tp_load_bracket *bracket, double share);
void tp_load_bracket_clear(tp_load_bracket *bracket);

#endif
