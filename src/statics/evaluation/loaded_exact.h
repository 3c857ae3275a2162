/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The exact question about a load whose moment is a ball about zero. */

#ifndef TP_EVALUATION_LOADED_EXACT_H
#define TP_EVALUATION_LOADED_EXACT_H

#include "evaluation/loaded.h"
#include "load/vanish.h"

/* Does the moment of a load, or of that part of a weight, about the k-th contact point vanish at
 * the scene's tilt? False also where that is not told: the axis is on a rounded corner, or the
 * centroid is a ball. */
bool tp_loaded_vanishes(const tp_load *load, tp_load_part part, const tp_loaded *loaded,
                        const tp_evaluation *evaluation, long k);

/* Does a load have no moment about the centroid at any tilt? False also where that is not known. */
bool tp_loaded_is_central(const tp_load *load, const tp_loaded *loaded,
                          const tp_evaluation *evaluation);

#endif
