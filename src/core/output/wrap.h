/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Paragraphs for a terminal: words on lines of 80 columns. */

#ifndef TP_OUTPUT_WRAP_H
#define TP_OUTPUT_WRAP_H

#include "output/text.h"

/* Characters of UTF-8 in so many bytes. */
size_t tp_text_width(const char *text, size_t length);

typedef struct tp_wrapping {
  size_t indent; /* of the lines after the first */
  size_t column; /* where the line stands */
  bool begun;    /* the next word has a space before it */
} tp_wrapping;

/* Adds words, which spaces part, on as many lines as they take; no line feed at the end. */
void tp_text_add_wrapped(tp_text *text, const char *words, tp_wrapping *wrapping);

#endif
