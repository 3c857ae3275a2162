/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The methods of drawing, a correlation of three variables, and plans that are begun. */

#ifndef TP_TEST_DRAWS_STAGE_H
#define TP_TEST_DRAWS_STAGE_H

#include "sampling/draws.h"

enum { METHODS = 3 };
extern const tp_draw_method methods[METHODS];
extern const double correlation[9];

/* The walk over a plan that can be drawn, from this sample on. */
tp_draws_walk *begun(const tp_draws *draws, uint64_t first);

#endif
