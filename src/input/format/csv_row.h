/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A line of a CSV file as fields.
 *
 * The columns of a line are separated by ';' where it has one, else by tabs, else by ',', else by
 * blanks. A field may stand in double quotes, within which nothing separates. A comment runs from a
 * '#' outside quotes to the end; empty fields at the end are dropped. */

#ifndef TP_FORMAT_CSV_ROW_H
#define TP_FORMAT_CSV_ROW_H

#include <stdbool.h>
#include <stddef.h>

/* Without its quotes, and blanks around it. */
typedef struct tp_csv_field {
  size_t at, length; /* in the text of the row */
} tp_csv_field;

enum { TP_CSV_FIELDS = 64 };

typedef struct tp_csv_row {
  const char *text;
  size_t length; /* without the comment */
  char separator;
  int count;       /* of the fields; further ones are not kept */
  bool too_many;   /* there are */
  bool open_quote; /* the last field begins with a quote that is not closed, ... */
  size_t quote;    /* ... here */
  tp_csv_field fields[TP_CSV_FIELDS];
} tp_csv_row;

/* `named` is the separator of the header that names the columns, which goes before the others where
 * the line has it; '\0': there is none. */
void tp_csv_split(tp_csv_row *row, const char *text, size_t length, char named);

/* Does a field begin as a number does? */
bool tp_csv_is_numeric(const tp_csv_row *row, int field);

/* Where a number of the row has a comma in it, as in "1,5;2,5": its place in the text. */
bool tp_csv_has_decimal_comma(const tp_csv_row *row, size_t *at);

#endif
