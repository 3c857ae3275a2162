/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A workbook as the zip of XML that it is. */

#ifndef TP_XLSX_BOOK_H
#define TP_XLSX_BOOK_H

#include "output/text.h"

#include <expat.h>
#include <zip.h>

/* Characters of a cell at most, as spreadsheets have them (ECMA-376: 32 767), and bytes of all
 * cells as CSV: a text that cells share counts in each of them. */
enum { TP_BOOK_CELL = 32767, TP_BOOK_BYTES = 256 << 20 };

typedef struct tp_book {
  const char *path;
  tp_message *message;
  zip_t *zip;          /* NULL: it is not packed, and each part is */
  const char *bytes;   /* these bytes, */
  size_t length;       /* so many */
  char sheet[256];     /* the part of the first worksheet */
  bool since_1904;     /* what its dates count from */
  size_t string_count; /* shared by cells, */
  long string_room;
  char **strings;
  size_t style_count; /* of cells: */
  long style_room;
  bool *is_date; /* does the style show a date? */
} tp_book;

/* Where the reading of a part is. Elements are named without the prefix of their namespace. */
typedef struct tp_parse tp_parse;
struct tp_parse {
  tp_book *book;
  XML_Parser parser;
  void *context;
  void (*start)(tp_parse *parse, const char *name, const char **attributes);
  void (*end)(tp_parse *parse, const char *name);
  tp_text text; /* of the element that `collects` */
  bool collects;
  const char *problem; /* what stopped it, or NULL */
  tp_status status;
};

/* Read the part by the two functions. One that there is not is TP_OK where it need not be. */
TP_MUST_USE tp_status tp_book_parse(tp_parse *parse, const char *part, bool needed);

/* The value of an attribute, or NULL; of `name` with any prefix. */
const char *tp_book_attribute(const char **attributes, const char *name);

/* End the parsing by a complaint, or for want of memory. */
void tp_parse_stop(tp_parse *parse, const char *problem);

/* Which worksheet is the first; texts that cells share; which styles are of dates. */
TP_MUST_USE tp_status tp_book_find_sheet(tp_book *book);
TP_MUST_USE tp_status tp_book_read_strings(tp_book *book);
TP_MUST_USE tp_status tp_book_read_styles(tp_book *book);

/* Free what it holds, and close it. */
void tp_book_clear(tp_book *book);

/* The worksheet as CSV. */
TP_MUST_USE tp_status tp_book_read_sheet(tp_book *book, tp_text *csv);

#endif
