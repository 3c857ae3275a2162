/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points from a CSV file: two columns, separated by comma, semicolon, tab or blanks, in quotes or
 * not; comments from '#' to the end of a line. Up to two lines above the points may hold a title,
 * names and units; columns that one names are read by their names (format/columns.h), whatever
 * others there are. Numbers are decimals with a point, and are taken exactly; quotients are read
 * below the comment TP_CSV_FRACTIONS alone, which tp_scene_profile_csv writes. A point that repeats
 * the one before it is left out, with a note. A last point equal to the first one, as GIS exports
 * close their rings, is dropped when `closed`. */

#ifndef TP_SCENE_READING_CSV_H
#define TP_SCENE_READING_CSV_H

#include "common/notes.h"
#include "plane/polyline.h"

/* The first line of a file whose coordinates may be quotients. */
#define TP_CSV_FRACTIONS "# coordinates are exact fractions"

/* `path` must outlive the line, whose places refer to it. `line` is left empty on failure. `*unit`
 * becomes that of the header, NULL: it says none. */
TP_MUST_USE tp_status tp_csv_read(tp_polyline *line, const char **unit, const char *path,
                                  bool closed, tp_notes *notes, tp_message *message);
/* The same from text in memory; `name` is what places refer to, and must outlive the line. */
TP_MUST_USE tp_status tp_csv_read_text(tp_polyline *line, const char **unit, const char *text,
                                       const char *name, bool closed, tp_notes *notes,
                                       tp_message *message);

/* Refuse a unit that the header says and another that is given, either NULL where there is none;
 * `meant` is what the other is: "'length_unit'". */
TP_MUST_USE tp_status tp_csv_check_unit(const char *said, const char *unit, const char *path,
                                        const char *meant, tp_message *message);

#endif
