/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A drawing scaled by an object of known length: the distance between its ends, or of a closed
 * object the greater side of its box. The factor is exact where that distance is rational, as of a
 * bar along x or y, and else a decimal within 1e-18 of it. The object is then no object of the
 * drawing any more.
 */

#ifndef TP_FORMAT_REFERENCE_H
#define TP_FORMAT_REFERENCE_H

#include "format/drawing.h"

/* Does nothing where the options name no reference. */
TP_MUST_USE tp_status tp_drawing_scale(tp_drawing *drawing, const tp_drawing_options *options,
                                       tp_message *message);

#endif
