/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Font, width, alignment, shortening and wrapped paragraphs of text drawn by Cairo. */

#include "figure/figure.h"
#include "figure/kept_texts.h"

#include "output/translate.h"

#include <stdio.h>
#include <string.h>

void tp_figure_tell_in(tp_text *text, const tp_language *language, bool comma) {
  if ((language == NULL && !comma) || text->data == NULL) return;
  tp_text own = {.failed = text->failed};
  tp_translate(&own, language, comma, text->data);
  tp_text_drop(text);
  *text = own;
}

void tp_figure_tell(const tp_figure *figure, tp_text *text) {
  tp_figure_tell_in(text, figure->language, figure->comma);
}

void tp_figure_set_decimals(const tp_figure *figure, char *text) {
  if (figure->comma) tp_language_set_commas(text);
}

const char *tp_figure_word(const tp_figure *figure, const char *english) {
  return tp_say(figure->language, english);
}

void tp_figure_font(cairo_t *cr, double size, bool bold) {
  cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, size);
}

double tp_figure_text_width(cairo_t *cr, const char *text) {
  cairo_text_extents_t extents;
  cairo_text_extents(cr, text, &extents);
  return extents.x_advance;
}

void tp_figure_text(cairo_t *cr, double x, double y, const char *text) {
  if (tp_kept_texts_add(cr, x, y, text)) return;
  cairo_move_to(cr, x, y);
  cairo_show_text(cr, text);
  cairo_new_path(cr);
}

void tp_figure_text_in(cairo_t *cr, tp_box box, const char *text) {
  cairo_text_extents_t extents;
  cairo_text_extents(cr, text, &extents);
  tp_figure_text(cr, (box.x0 + box.x1 - extents.width) / 2 - extents.x_bearing,
                 (box.y0 + box.y1 - extents.height) / 2 - extents.y_bearing, text);
}

void tp_figure_shorten(cairo_t *cr, char line[TP_LINE_SIZE], double width) {
  size_t length = strlen(line);
  while (length > 0 && tp_figure_text_width(cr, line) > width) {
    length--;
    while (length > 0 && ((unsigned char)line[length] & 0xC0) == 0x80) length--;
    snprintf(line + length, TP_LINE_SIZE - length, "…");
  }
}

/* Append a word, control characters as spaces; a word that does not fit in memory is cut. */
static void append(char line[TP_LINE_SIZE], const char *word, size_t length) {
  const size_t own = strlen(line), room = TP_LINE_SIZE - 8 - own;
  if (length > room) {
    length = room;
    while (length > 0 && ((unsigned char)word[length] & 0xC0) == 0x80) length--;
  }
  memcpy(line + own, word, length);
  line[own + length] = '\0';
}

double tp_figure_paragraph(cairo_t *cr, double x, double y, double width, double size, bool bold,
                           const char *text) {
  char line[TP_LINE_SIZE] = "", longer[TP_LINE_SIZE];
  tp_figure_font(cr, size, bold);
  const char *word = text;
  for (;;) {
    while (*word != '\0' && (unsigned char)*word <= ' ') word++;
    size_t length = 0;
    while ((unsigned char)word[length] > ' ') length++;
    snprintf(longer, sizeof longer, "%s", line);
    if (longer[0] != '\0') append(longer, " ", 1);
    append(longer, word, length);
    if (length > 0 && (line[0] == '\0' || tp_figure_text_width(cr, longer) <= width)) {
      memcpy(line, longer, sizeof line);
    } else if (line[0] != '\0') {
      tp_figure_shorten(cr, line, width); /* a word that alone is wider than the page */
      tp_figure_text(cr, x, y + size, line);
      y += TP_LINE_HEIGHT * size;
      line[0] = '\0';
      append(line, word, length);
    }
    if (length == 0 && line[0] == '\0') return y;
    word += length;
  }
}
