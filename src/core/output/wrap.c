/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Breaks lines before the word that would pass the last column. */

#include "output/wrap.h"

#include <string.h>

enum { COLUMNS = 80 };

size_t tp_text_width(const char *text, size_t length) {
  size_t width = 0;
  for (size_t k = 0; k < length; k++) width += ((unsigned char)text[k] & 0xc0) != 0x80;
  return width;
}

void tp_text_add_wrapped(tp_text *t, const char *words, tp_wrapping *w) {
  words += strspn(words, " ");
  while (*words != '\0') {
    const size_t length = strcspn(words, " "), width = tp_text_width(words, length);
    if (w->begun && w->column + 1 + width > COLUMNS) {
      tp_text_add(t, "\n%*s", (int)w->indent, "");
      w->column = w->indent;
    } else if (w->begun) {
      tp_text_add(t, " ");
      w->column++;
    }
    tp_text_append(t, words, length);
    w->column += width;
    w->begun = true;
    words += length + strspn(words + length, " ");
  }
}
