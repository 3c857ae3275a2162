/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which columns of a CSV file of points are x and y, by what its header calls them
 * (format/column_words_table.h), and in which unit: an elevation is y wherever it stands. */

#ifndef TP_FORMAT_COLUMNS_H
#define TP_FORMAT_COLUMNS_H

#include "common/message.h"
#include "common/notes.h"
#include "format/csv_row.h"

#include <flint/fmpq.h>

typedef struct tp_columns {
  int count;            /* of columns that the header has; 0: no header names any */
  int at[2];            /* of x and y, from 0 */
  const char *words[2]; /* what the header calls them, as the table has it */
  bool of_plan;         /* x is an easting or a northing */
  int level;            /* of a height beside x and y, which must stay the same; -1 */
  const char *unit;     /* of both, of Topple's own; NULL: the header does not say */
} tp_columns;

typedef enum tp_header {
  TP_HEADER_TITLE, /* no field of it is a word of the table, or a unit */
  TP_HEADER_UNITS, /* units alone */
  TP_HEADER_NAMES
} tp_header;

/* Look at a line above the points. Of one that names columns, or their units, `columns` becomes
 * what it says; a failure says what would be right. */
TP_MUST_USE tp_status tp_columns_read(tp_columns *columns, tp_header *header, const tp_csv_row *row,
                                      tp_place line, tp_message *message);

/* Say which columns are read, where that is not the first two as x and y by these names. */
TP_MUST_USE tp_status tp_columns_note(const tp_columns *columns, tp_place line, tp_notes *notes,
                                      tp_message *message);

/* The height beside x and y that the points of a file have had so far. */
typedef struct tp_column_level {
  bool given;
  fmpq_t value;
} tp_column_level;

void tp_column_level_init(tp_column_level *level);
void tp_column_level_clear(tp_column_level *level);

/* Is it the same in this line, or not a number in it? */
bool tp_column_level_stays(tp_column_level *level, const tp_columns *columns,
                           const tp_csv_row *row);

/* Of one that changes. */
extern const char tp_columns_plan[];

#endif
