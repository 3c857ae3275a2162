/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where salient corners of two blocks meet in one point without a shared edge. */

#ifndef TP_ASSEMBLAGE_CORNER_PAIRS_H
#define TP_ASSEMBLAGE_CORNER_PAIRS_H

#include "assemblage/edge_pairs.h"

/* The corners of two edges, of different blocks, lie in one point and do not overlap; the same two
 * come as often as an edge is tried against the other, and are taken where `edge` is of the block
 * that is listed first. Nothing is added where one of them is not salient, or both share an edge,
 * which then is a contact. */
TP_MUST_USE tp_status tp_corner_pairs_try(tp_assemblage *assemblage, const tp_edge_of_block *edge,
                                          const tp_edge_of_block *other, tp_message *message);

#endif
