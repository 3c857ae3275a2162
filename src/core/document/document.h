/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A document as data: headings, paragraphs, tables, equations, figures and listings, in their
 * order. What it says is the business of report/; writers turn it into HTML, Markdown and PDF, all
 * of them into the same words and numbers.
 *
 * Every text in it is plain (outside.h), and is text alone: each writer escapes what its language
 * would take for its own. Equations are the exception (math.h): only our own signs and numbers
 * stand in them. */

#ifndef TP_DOCUMENT_DOCUMENT_H
#define TP_DOCUMENT_DOCUMENT_H

#include "document/logo.h"
#include "output/language.h"
#include "output/text.h"

typedef enum tp_passage_kind {
  TP_PASSAGE_HEADING,
  TP_PASSAGE_PARAGRAPH,
  TP_PASSAGE_ANSWER,   /* what a reader looks for first: set off from the rest */
  TP_PASSAGE_CAUTION,  /* likewise */
  TP_PASSAGE_EQUATION, /* by the notation of math.h */
  TP_PASSAGE_TABLE,
  TP_PASSAGE_FIGURE,
  TP_PASSAGE_LISTING, /* lines of a file as they stand there */
  TP_PASSAGE_PAGE     /* what follows begins a new page of paper */
} tp_passage_kind;

/* How a table is read. */
typedef enum tp_table_kind {
  TP_TABLE_OF_COLUMNS, /* a head above each column */
  TP_TABLE_OF_FACTS    /* two columns, the first of which names what the second has */
} tp_table_kind;

enum { TP_TABLE_COLUMNS = 10 };

typedef struct tp_table {
  tp_table_kind kind;
  size_t columns;
  unsigned numeric; /* bit k: column k is of numbers, set to the right */
  size_t cell_count, room;
  char **cells; /* row by row, the heads first where there are any */
  bool has_mark;
  size_t mark; /* this row, counted without heads, is set off: it governs */
} tp_table;

/* What a figure is made of; the writers of HTML and Markdown take the SVG, that of PDF the PNG, or
 * draws it itself where there is none. */
typedef struct tp_picture {
  char *svg, *png; /* owned, NULL: none */
  size_t svg_length, png_length;
} tp_picture;

typedef struct tp_passage {
  tp_passage_kind kind;
  int level;    /* of a heading: 2 or 3; the title is 1 */
  char *text;   /* caption of a table or a figure; else what it says */
  char *beside; /* of a figure what it shows, for those who do not see it */
  tp_table table;
  tp_picture picture;
  bool fills; /* a figure that has the room which the rest of its page of paper leaves */
} tp_passage;

typedef struct tp_document {
  const tp_language *language; /* of its own text; NULL: English */
  bool comma;                  /* before the decimals of its own text */
  char *company;               /* above the title, with the logo; NULL: none */
  tp_logo logo;
  char *title;
  char *foot; /* below each page on paper: what it is of */
  size_t count, room;
  tp_passage *passages;
  bool failed; /* memory was exhausted; the rest is dropped */
} tp_document;

void tp_document_clear(tp_document *document);

/* Its text, from a text that is taken over. */
void tp_document_set_title(tp_document *document, tp_text *title);
void tp_document_set_foot(tp_document *document, tp_text *foot);

/* Who it is of, from outside, and a logo, which is taken over. */
void tp_document_set_letterhead(tp_document *document, const char *company, tp_logo logo);

/* What follows begins a new page of paper. */
void tp_document_page(tp_document *document);

/* A phrase, such as the name of a mechanism, in the language of the document. */
const char *tp_document_say(const tp_document *document, const char *english)
    __attribute__((format_arg(2)));

/* The numbers of a text of our own get the document's sign before decimals. */
void tp_document_set_decimals(const tp_document *document, tp_text *text);

/* A part of one text, which is taken over; the level is of headings alone. */
void tp_document_take(tp_document *document, tp_passage_kind kind, int level, tp_text *text);

/* The same of a text of our own: here and below a phrase, said in the language of the document. */
void tp_document_add(tp_document *document, tp_passage_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void tp_document_heading(tp_document *document, int level, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* A table; the calls after it fill its cells, row by row, the heads first. `numeric` as above. */
void tp_document_table(tp_document *document, tp_table_kind kind, size_t columns, unsigned numeric,
                       const char *caption);
void tp_document_cell(tp_document *document, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void tp_document_outside_cell(tp_document *document, const char *outside);
/* An English text that was composed elsewhere, of words of our own and maybe from outside: in the
 * language of the document as far as its phrases go (output/translate.h). */
void tp_document_told_cell(tp_document *document, const char *english);
/* The same as a passage, from a text that is taken over. */
void tp_document_tell(tp_document *document, tp_passage_kind kind, int level, tp_text *english);
/* A phrase without arguments. */
void tp_document_word(tp_document *document, const char *english);
/* A text of our own, which is taken over. */
void tp_document_take_cell(tp_document *document, tp_text *text);
/* The row that begins with the next cell is set off. */
void tp_document_mark_row(tp_document *document);

/* A figure; the picture is taken over. */
void tp_document_figure(tp_document *document, tp_picture picture, const char *caption,
                        const char *alternative);

/* The same, as high as the rest of its page leaves room for. */
void tp_document_sketch(tp_document *document, tp_picture picture, const char *caption,
                        const char *alternative);

/* Rows below the heads. */
size_t tp_table_rows(const tp_table *table);
const char *tp_table_cell(const tp_table *table, size_t row, size_t column);
const char *tp_table_head(const tp_table *table, size_t column);

/* As one HTML file that needs no other, and as Markdown. */
TP_MUST_USE tp_status tp_document_html(char **text, const tp_document *document);
TP_MUST_USE tp_status tp_document_markdown(char **text, const tp_document *document);

#endif
