/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the few bytes of a drawing may make work of, counted against its budgets (budget.h): points
 * that curves, and blocks inserted, become, and numbers of nested transforms. */

#ifndef TP_FORMAT_DRAWING_WORK_H
#define TP_FORMAT_DRAWING_WORK_H

#include "format/affine.h"

/* Points that a drawing may be made of, besides those that its file writes out: of so many bytes.
 */
double tp_drawing_points_allowed(size_t bytes);

/* An object that a curve or an insert has made: its points are counted. Bad input at its place
 * where all of them are too many. */
TP_MUST_USE tp_status tp_drawing_count(tp_drawing *drawing, const tp_drawing_object *object,
                                       tp_message *message);

/* Why a map of nested transforms is too dear to go on with, a static text; NULL: it is not. */
const char *tp_drawing_map_problem(const tp_affine_map *map);

#endif
