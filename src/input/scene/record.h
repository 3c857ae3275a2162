/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An accelerogram from a file, as points of seconds from its first sample and shares of standard
 * gravity (9.80665 m/s2), exact as the file has them.
 *
 * A file that ends in .at2 is one of PEER's: lines of text that say ACCELERATION and UNITS OF G, a
 * line with NPTS and DT in either of the orders in use, and NPTS numbers. Any other is CSV: a line
 * that names the columns with their units ("time_s, acceleration_m_s2"), the time first, and a
 * sample a line, at even steps. */

#ifndef TP_SCENE_RECORD_H
#define TP_SCENE_RECORD_H

#include "plane/polyline.h"

/* `path` must outlive the record; `column` is of the accelerations in a CSV file, counted from 1,
 * above 1; 0: the second, and the only choice of an .at2. `record` is left empty on failure. */
TP_MUST_USE tp_status tp_record_read(tp_polyline *record, const char *path, long column,
                                     tp_message *message);

/* Do samples follow each other at even steps, and is there more than one? `place` is of what has
 * them. */
TP_MUST_USE tp_status tp_record_check(const tp_polyline *record, tp_place place,
                                      tp_message *message);

/* Time counts from the first sample; the points are of this record alone. */
void tp_record_begin_at_zero(tp_polyline *record);

#endif
