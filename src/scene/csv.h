/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points from a CSV file: two columns x, y; separated by comma, semicolon, tab or blanks; an
 * optional header line; comments from '#' to the end of a line. Numbers are decimals or fractions
 * and are taken exactly. A last point equal to the first one, as GIS exports close their rings, is
 * dropped when `closed`. */

#ifndef TP_CSV_H
#define TP_CSV_H

#include "number/polyline.h"

/* `path` must outlive the line, whose places refer to it. `line` is left empty on failure. */
TP_MUST_USE tp_status tp_csv_read(tp_polyline *line, const char *path, bool closed,
                                  tp_message *message);
/* The same from text in memory; `name` is what places refer to, and must outlive the line. */
TP_MUST_USE tp_status tp_csv_read_text(tp_polyline *line, const char *text, const char *name,
                                       bool closed, tp_message *message);

#endif
