/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Page ends with number and foot, page breaks, and lines broken at blanks by the measured width of
 * the font. */

#include "figure/paper.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void tp_paper_end_page(const tp_paper *p) {
  char number[64];
  cairo_t *cr = p->cr;
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_font(cr, TP_BODY_SIZE, false);
  if (p->document->foot != NULL) {
    tp_figure_text(cr, TP_PAPER_LEFT, TP_PAPER_BOTTOM + 24, p->document->foot);
  }
  snprintf(number, sizeof number, tp_document_say(p->document, "Page %d of %d"), p->page, p->pages);
  tp_figure_text(cr, TP_PAPER_WIDTH - TP_PAPER_LEFT - tp_figure_text_width(cr, number),
                 TP_PAPER_BOTTOM + 24, number);
  cairo_show_page(cr);
}

void tp_paper_need(tp_paper *p, double height) {
  if (p->y + height <= TP_PAPER_BOTTOM || p->y <= TP_PAPER_TOP) return;
  tp_paper_end_page(p);
  p->page++;
  p->y = TP_PAPER_TOP;
}

void tp_paper_begin_page(tp_paper *p) {
  const double slack = 30; /* a heading asks for more room than the little below it takes */
  if (p->page == 1 && !p->measured) {
    p->left = TP_PAPER_BOTTOM - p->y - slack;
    p->measured = true;
  }
  tp_paper_need(p, TP_PAPER_HEIGHT);
}

size_t tp_paper_fitting(cairo_t *cr, const char *word, size_t length, double width) {
  char piece[TP_PAPER_LINE];
  size_t fits = 0;
  for (size_t next = 1; next <= length && next < sizeof piece; next++) {
    if (next < length && ((unsigned char)word[next] & 0xC0) == 0x80) continue;
    snprintf(piece, sizeof piece, "%.*s", (int)next, word);
    if (fits > 0 && tp_figure_text_width(cr, piece) > width) break;
    fits = next;
  }
  return fits;
}

bool tp_paper_line(cairo_t *cr, char line[TP_PAPER_LINE], const char **text, double width) {
  char longer[2 * TP_PAPER_LINE];
  line[0] = '\0';
  for (;;) {
    const char *word = *text + strspn(*text, " ");
    const size_t length = strcspn(word, " ");
    if (length == 0) {
      *text = word;
      return line[0] != '\0';
    }
    snprintf(longer, sizeof longer, "%s%s%.*s", line, line[0] != '\0' ? " " : "",
             (int)fmin((double)length, TP_PAPER_LINE), word);
    const bool fits = strlen(longer) < TP_PAPER_LINE && tp_figure_text_width(cr, longer) <= width;
    if (!fits && line[0] != '\0') return true;
    if (!fits) { /* a word that alone is too long */
      const size_t part = tp_paper_fitting(cr, word, length, width);
      snprintf(line, TP_PAPER_LINE, "%.*s", (int)part, word);
      *text = word + part;
      return true;
    }
    snprintf(line, TP_PAPER_LINE, "%.*s", TP_PAPER_LINE - 1, longer);
    *text = word + length;
  }
}
