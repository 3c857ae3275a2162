/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is a surface that of one solid? Every edge belongs to two triangles that pass it in opposite
 * directions (closed, oriented); from each triangle all others are reached over edges (one piece);
 * each has an area; no two triangles meet but in the edge or the corner that they share. All of it
 * is decided exactly. That triangles run counter-clockwise seen from outside is then the sign of
 * the volume (solid/solid_sums.h). The first fault is refused by the numbers of its triangles in
 * the file. */

#ifndef TP_SOLID_GATE_H
#define TP_SOLID_GATE_H

#include "solid/surface.h"

/* Each triangle has an area. */
TP_MUST_USE tp_status tp_gate_areas(const tp_surface *surface, tp_message *message);

/* Closed, oriented, of one piece. */
TP_MUST_USE tp_status tp_gate_edges(const tp_surface *surface, tp_message *message);

/* A ground: its triangles have areas, and neighbours do not run against each other; it may end, be
 * of several pieces, and meet itself. */
TP_MUST_USE tp_status tp_gate_ground(const tp_surface *surface, tp_message *message);

/* No two triangles meet elsewhere. */
TP_MUST_USE tp_status tp_gate_clashes(const tp_surface *surface, tp_message *message);

#endif
