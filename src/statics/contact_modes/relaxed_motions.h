/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Why a node could not be refuted: forces that its sets allow, and accelerations from them that its
 * sets allow too, of which no contact has both in one mode. Such a motion of relaxed laws keeps
 * every node from being refuted by forces that allows it, and no linear program is needed there. */

#ifndef TP_CONTACT_MODES_RELAXED_MOTIONS_H
#define TP_CONTACT_MODES_RELAXED_MOTIONS_H

#include "contact_modes/resisting_edges.h"

#include <stdint.h>

/* By contact what it does, in bits (relaxed_motions.c); by number of a free block whether the node
 * had it at rest, and whether it has no acceleration. */
typedef struct tp_relaxed_motion {
  uint16_t *does;
  bool *still, *idle;
  bool has_forces; /* so that no forces refute a node that allows it */
  bool drives;     /* loads do work, so that no reactions do */
} tp_relaxed_motion;

/* The last ones. */
enum { TP_MOST_RELAXED = 512 };
typedef struct tp_relaxed_motions {
  const tp_modes_question *question;
  long count;
  tp_relaxed_motion all[TP_MOST_RELAXED]; /* the one that was met last is the first */
  double *rows, *accelerations, *sum;     /* room, by row */
} tp_relaxed_motions;

TP_MUST_USE bool tp_relaxed_motions_init(tp_relaxed_motions *motions,
                                         const tp_modes_question *question);
void tp_relaxed_motions_clear(tp_relaxed_motions *motions);

/* Of a node, by multipliers of each edge and of each load of the question. With loads that vary y
 * may depend on them; then edges have as many multipliers as there are loads, one load's after the
 * other's: copies. */
void tp_relaxed_motions_add(tp_relaxed_motions *motions, const tp_modes_node *node,
                            const tp_resisting_edges *edges, const double *of_edges,
                            const double *of_loads, int copies);

/* Accelerations alone, at which loads do work. */
void tp_relaxed_motions_add_driven(tp_relaxed_motions *motions, const tp_modes_node *node,
                                   const double *accelerations);

/* Is there one that the node allows? `work` grows by what it took. */
typedef enum tp_relaxed_kind { TP_RELAXED_BY_FORCES, TP_RELAXED_DRIVEN } tp_relaxed_kind;
bool tp_relaxed_motions_have(tp_relaxed_motions *motions, tp_relaxed_kind kind, long *work,
                             const tp_modes_node *node);

#endif
