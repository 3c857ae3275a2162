/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With which share of its strength can a mode begin at one tilt (share_mode.h)? The determinants
 * are polynomials of the share, of the third degree at most, and between their zeros nothing
 * changes.
 *
 * The zeros are searched in doubles; that a mode can begin with a share, or cannot, is proven in
 * doubles with bounds, or left open. A coefficient that doubles do not tell from zero is asked of
 * balls, where the mode has them. */

#ifndef TP_MOTION_MODE_SHARES_H
#define TP_MOTION_MODE_SHARES_H

#include "motion/share_mode.h"

/* Adds the shares at which the mode can begin, as doubles have it; false when memory is exhausted.
 */
TP_MUST_USE bool tp_share_spans_add(tp_share_spans *spans, const tp_share_mode *mode);
/* The same, those left out of which no share lies from 1 / ratio to the ratio: cheaper. */
TP_MUST_USE bool tp_share_spans_add_near(tp_share_spans *spans, const tp_share_mode *mode,
                                         double ratio);

#endif
