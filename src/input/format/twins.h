/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pieces of a drawing that are drawn twice: the same curve, whichever end it begins at. */

#ifndef TP_FORMAT_TWINS_H
#define TP_FORMAT_TWINS_H

#include "format/drawing.h"

/* Of pieces with two points or more, in the order of their file, the first of each curve is kept,
 * in that order. How many are; `place` is set to that of one that is left out, where there is one.
 * Costs n log n comparisons. */
long tp_drawing_drop_twins(const tp_drawing_object **pieces, long count, tp_place *place);

#endif
