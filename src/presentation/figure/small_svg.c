/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cairo writes each letter's outline into a drawing, each line's style in full, and coordinates in
 * six decimals: 150 kB of a block. Here texts are kept while it draws and added as <text> of the
 * width that was measured, so that another font keeps the layout; coordinates have two decimals,
 * 1/100 of a point; and a style that recurs is a class. What of Cairo's file is not known stays as
 * it is. */

#define _GNU_SOURCE
#include "figure/small_svg.h"

#include "common/message.h"
#include "figure/kept_texts.h"
#include "figure/sink.h"

#include <cairo-svg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- what Cairo wrote, made shorter ------------------------------------------------------------
 */

enum { CLASSES = 256 };

typedef struct classes {
  const char *styles[CLASSES]; /* in the text that is read */
  size_t lengths[CLASSES];
  int count;
} classes;

/* Which one it is; CLASSES: there are too many. */
static int class_of(classes *c, const char *style, size_t length) {
  for (int k = 0; k < c->count; k++) {
    if (c->lengths[k] == length && memcmp(c->styles[k], style, length) == 0) return k;
  }
  if (c->count == CLASSES) return CLASSES;
  c->styles[c->count] = style;
  c->lengths[c->count] = length;
  return c->count++;
}

/* A number of a path with two decimals at most. */
static const char *add_number(tp_text *t, const char *at) {
  char *end = NULL, number[40];
  const double value = strtod(at, &end);
  int length = snprintf(number, sizeof number, "%.2f", value);
  while (length > 0 && number[length - 1] == '0') length--;
  if (length > 0 && number[length - 1] == '.') length--;
  number[length] = '\0';
  tp_text_add(t, "%s", strcmp(number, "-0") == 0 ? "0" : number);
  return end;
}

/* The path in quotes. A path that is closed begins again where it began, as Cairo writes it: that
 * draws nothing where it is the end. */
static void add_path(tp_text *t, const char *path, size_t length) {
  const char *end = path + length;
  for (const char *at = path; at < end;) {
    if (strchr("+-.0123456789", *at) != NULL) {
      at = add_number(t, at);
    } else if (at[0] == 'Z' && memchr(at, 'L', (size_t)(end - at)) == NULL &&
               memchr(at, 'C', (size_t)(end - at)) == NULL) {
      tp_text_add(t, "Z");
      return;
    } else if (at[0] != ' ' || (at + 1 < end && strchr("+-.0123456789", at[1]) != NULL &&
                                at > path && strchr(".0123456789", at[-1]) != NULL)) {
      tp_text_append(t, at++, 1);
    } else {
      at++;
    }
  }
}

/* Cairo counts the drawings of a process, and names each by its number: nothing refers to it. */
static bool is_surface_number(const char *name, size_t size, const char *value) {
  return size == 2 && memcmp(name, "id", 2) == 0 && strncmp(value, "surface", 7) == 0;
}

/* An attribute in double quotes, after its name and =. */
static const char *add_attribute(tp_text *t, classes *c, const char *name, size_t size,
                                 const char *value) {
  const char *end = strchr(value, '"');
  if (end == NULL) return value;
  if (is_surface_number(name, size, value)) return end + 1;
  const size_t length = (size_t)(end - value);
  const int own = size == 5 && memcmp(name, "style", 5) == 0 ? class_of(c, value, length) : CLASSES;
  if (own < CLASSES) {
    tp_text_add(t, "class=\"s%d\"", own);
    return end + 1;
  }
  tp_text_append(t, name, size);
  tp_text_add(t, "=\"");
  if (size == 1 && *name == 'd') {
    add_path(t, value, length);
  } else {
    tp_text_append(t, value, length);
  }
  tp_text_add(t, "\"");
  return end + 1;
}

/* The elements of a file of XML, whose text nodes are copied. */
static void shorten(tp_text *t, classes *c, const char *at) {
  bool within = false;
  while (*at != '\0') {
    const size_t size =
        within ? strspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ:-") : 0;
    if (size > 0 && at[size] == '=' && at[size + 1] == '"') {
      at = add_attribute(t, c, at, size, at + size + 2);
      continue;
    }
    if (*at == '<') within = true;
    if (*at == '>') within = false;
    tp_text_append(t, at, size > 0 ? size : 1);
    at += size > 0 ? size : 1;
  }
}

/* Properties that are as SVG has them where nothing is said; a limit of mitres where there are
 * none.
 */
static bool is_default(const char *property, size_t length) {
  static const char *const defaults[] = {"fill-opacity:1", "stroke-opacity:1", "stroke:none",
                                         "stroke-linecap:butt", "fill-rule:nonzero"};
  for (size_t k = 0; k < sizeof defaults / sizeof defaults[0]; k++) {
    if (strlen(defaults[k]) == length && memcmp(property, defaults[k], length) == 0) return true;
  }
  return false;
}

static void add_style(tp_text *t, const char *style, size_t length) {
  static const char mitre[] = "stroke-miterlimit:", round[] = "stroke-linejoin:round";
  const bool rounded = memmem(style, length, round, strlen(round)) != NULL;
  const char *end = style + length;
  for (const char *at = style; at < end;) {
    at += strspn(at, " ;");
    if (at >= end) break;
    size_t size = strcspn(at, ";");
    if (at + size > end) size = (size_t)(end - at);
    const bool unused = rounded && strncmp(at, mitre, strlen(mitre)) == 0;
    if (!unused && !is_default(at, size)) tp_text_add(t, "%.*s;", (int)size, at);
    at += size;
  }
}

/* All of it: the element svg, its styles, what it draws, its texts. */
static void join(tp_text *t, const char *drawn, const char *texts) {
  classes *c = calloc(1, sizeof *c);
  tp_text body = {0};
  const char *begin = strstr(drawn, "<svg");
  const char *inner = begin != NULL ? strchr(begin, '>') : NULL;
  const char *end = inner != NULL ? strstr(inner, "</svg>") : NULL;
  char *all = end != NULL ? strndup(inner + 1, (size_t)(end - inner - 1)) : NULL;
  if (c == NULL || all == NULL) {
    t->failed = true;
  } else {
    shorten(&body, c, all);
    shorten(&body, c, texts);
    tp_text_append(t, begin, (size_t)(inner + 1 - begin));
    tp_text_add(t, "<style>text{font-family:DejaVu Sans,Verdana,sans-serif;white-space:pre}\n");
    for (int k = 0; k < c->count; k++) {
      tp_text_add(t, ".s%d{", k);
      add_style(t, c->styles[k], c->lengths[k]);
      tp_text_add(t, "}\n");
    }
    tp_text_add(t, "</style>");
    tp_text_append(t, body.data, body.length);
    tp_text_add(t, "</svg>\n");
  }
  t->failed = t->failed || body.failed;
  tp_text_drop(&body);
  free(all);
  free(c);
}

/* ---- the figure --------------------------------------------------------------------------------
 */

static cairo_status_t draw(tp_sink *s, tp_text *texts, const tp_figure *figure) {
  double height = 0;
  cairo_status_t status = tp_figure_measure(&height, figure);
  if (status != CAIRO_STATUS_SUCCESS) return status;
  cairo_surface_t *surface =
      cairo_svg_surface_create_for_stream(tp_sink_write, s, tp_figure_width(figure), ceil(height));
  status = tp_kept_texts_begin(surface, texts);
  if (status == CAIRO_STATUS_SUCCESS) status = tp_figure_draw(&height, surface, figure, 1);
  cairo_surface_finish(surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface);
  cairo_surface_destroy(surface);
  return status;
}

tp_status tp_figure_small_svg(char **bytes, size_t *length, const tp_figure *figure,
                              tp_message *message) {
  tp_sink s = {0};
  tp_text texts = {0};
  tp_text svg = {0};
  const cairo_status_t drawn = draw(&s, &texts, figure);
  (void)tp_sink_write(&s, (const unsigned char *)"", 1);
  const bool memory = !s.failed && !texts.failed && drawn != CAIRO_STATUS_NO_MEMORY;
  if (memory && drawn == CAIRO_STATUS_SUCCESS) {
    join(&svg, s.bytes, texts.data != NULL ? texts.data : "");
  }
  free(s.bytes);
  tp_text_drop(&texts);
  *length = svg.length;
  if (memory && drawn != CAIRO_STATUS_SUCCESS) {
    return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){0}, "the figure cannot be drawn: %s",
                   cairo_status_to_string(drawn));
  }
  if (memory && tp_text_finish(&svg, bytes) == TP_OK) return TP_OK;
  return tp_fail_memory(message, "the figure");
}
