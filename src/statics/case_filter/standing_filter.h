/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The state of a block at its tilt, and the factor against one way to move, in doubles with bounds.
 */

#ifndef TP_CASE_FILTER_STANDING_FILTER_H
#define TP_CASE_FILTER_STANDING_FILTER_H

#include "case_filter/case_filter.h"

/* What is told of the block at its tilt. */
typedef struct tp_filter_state {
  tp_near tangent;     /* of the tilt */
  bool moves;          /* some motion can begin: */
  unsigned beginnings; /* the bit 1 << mechanism of each that can, */
  tp_mechanism mover;  /* and which is named */
} tp_filter_state;

/* A factor against one way to move. */
typedef struct tp_filter_way {
  tp_fos_told fos;
  tp_fos_definition definition;
  tp_mechanism mechanism;
} tp_filter_way;

typedef enum tp_filter_standing {
  TP_FILTER_COUNTS,
  TP_FILTER_EXCLUDED,
  TP_FILTER_OPEN /* doubles do not tell */
} tp_filter_standing;

/* Does the interval hold the tangent for certain? */
bool tp_filter_holds(const tp_near_interval *interval, tp_near tangent);

/* Can motions begin at all tilts from a critical one up to the block's? */
tp_filter_standing tp_filter_begins_from(const tp_onset_filter *onset, tp_near critical,
                                         tp_near tangent);

#endif
