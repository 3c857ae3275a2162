/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Closes gaps and overlaps that are no wider than the noise of a survey: corners of blocks that lie
 * that near each other become one, others are moved onto the edges that they lie near, and edges
 * take in the corners that lie on them, so that blocks touch exactly. */

#ifndef TP_ASSEMBLAGE_CLOSE_GAPS_H
#define TP_ASSEMBLAGE_CLOSE_GAPS_H

#include "assemblage/given_block.h"

typedef struct tp_closing {
  long moved, taken_in; /* corners that were moved, and that edges took in */
  long block;           /* that has the corner which was moved the most, */
  double most;          /* by so many scene lengths */
} tp_closing;

/* `sections` are those of `given`. Corners of ground stay, unless ground meets ground. No corner is
 * moved by more than twice `within`. Bad input: an edge that is shorter than that, or a chain of
 * corners that would go farther. */
TP_MUST_USE tp_status tp_close_gaps(tp_closing *closing, tp_section *sections,
                                    const tp_given_block *given, long count, const fmpq_t within,
                                    tp_message *message);

#endif
