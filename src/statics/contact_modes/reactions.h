/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reactions c of a node: columns with factors that are not negative, or of any sign. */

#ifndef TP_CONTACT_MODES_REACTIONS_H
#define TP_CONTACT_MODES_REACTIONS_H

#include "contact_modes/node.h"

typedef struct tp_bearing_reaction {
  const tp_force_column *column;
  double sign;  /* times which */
  bool is_free; /* its factor has any sign */
  long contact;
  int end; /* of a normal force; -1: a shear */
} tp_bearing_reaction;

typedef struct tp_bearing_reactions {
  long count;
  tp_bearing_reaction *all;
} tp_bearing_reactions;

/* Those of contacts that a block takes part in that is not at rest. False when memory is exhausted.
 */
TP_MUST_USE bool tp_reactions_init(tp_bearing_reactions *reactions, const tp_modes_node *node,
                                   const tp_resting *resting);
void tp_reactions_clear(tp_bearing_reactions *reactions);

/* Columns of a program in factors that are not negative: one a reaction, two of a free one. */
long tp_reactions_columns(const tp_bearing_reactions *reactions);

/* Factors by reaction from those. */
void tp_reactions_join(double *factors, const tp_bearing_reactions *reactions,
                       const double *columns);

#endif
