/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Text from outside on its way into an output: one encoder for each language that reports are
 * written in. What a field marked TP_OUTSIDE in the public headers holds goes through one of them,
 * never through tp_text_add. All but JSON, which carries any text, write the plain form (outside.h)
 * and escape what the language would take for its own. */

#ifndef TP_OUTPUT_ENCODE_H
#define TP_OUTPUT_ENCODE_H

#include "output/text.h"

/* For a terminal: on one line. The second form fills up with blanks to a width in characters. */
void tp_encode_plain(tp_text *text, const char *outside);
void tp_encode_column(tp_text *text, const char *outside, int width);

/* A string of JSON in its quotes. What is not seen is escaped, a byte that
 * belongs to no character of UTF-8 becomes U+FFFD. */
void tp_encode_json(tp_text *text, const char *outside);

/* Within a comment of C: it neither ends nor begins one, and is free of trigraphs. */
void tp_encode_c_comment(tp_text *text, const char *outside);

/* Within a comment of LaTeX, which ends with its line. */
void tp_encode_latex_comment(tp_text *text, const char *outside);

/* Within a paragraph, a heading or a cell of Markdown: neither markup nor HTML, no link. */
void tp_encode_markdown(tp_text *text, const char *outside);
/* As code in Markdown, also in a cell of a table. */
void tp_encode_markdown_code(tp_text *text, const char *outside);

/* Within an element of HTML, or an attribute in double quotes. */
void tp_encode_html(tp_text *text, const char *outside);

/* Any bytes in base 64 (RFC 4648), as a data: address has them. */
void tp_encode_base64(tp_text *text, const void *bytes, size_t length);

/* A field of CSV, in quotes where it must. What a spreadsheet would take for a formula gets an
 * apostrophe before it; a number stays one. */
void tp_encode_csv(tp_text *text, const char *outside);

/* A string of gnuplot in single quotes, in which it executes nothing. Markup is off where the
 * command that it is given to says noenhanced; what it draws into SVG stays well-formed. */
void tp_encode_gnuplot(tp_text *text, const char *outside);

#endif
