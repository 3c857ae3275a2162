/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A document as one HTML file: no script, nothing from elsewhere. Its Content-Security-Policy
 * allows the style that stands in it, by its hash, and pictures that stand in it: nothing else,
 * whatever text from outside may say. Pictures are SVG in data: addresses, in which a browser runs
 * nothing. */

#include "document/document.h"
#include "document/html_math.h"
#include "document/html_style.h"
#include "output/encode.h"
#include "output/sha256.h"

#include <stdlib.h>
#include <string.h>

static void add_letterhead(tp_text *t, const tp_document *d) {
  if (d->company == NULL && d->logo.kind == TP_LOGO_NONE) return;
  tp_text_add(t, "<header>\n");
  if (d->logo.kind != TP_LOGO_NONE) {
    tp_text_add(t, "<img alt=\"%s\" src=\"data:image/%s;base64,", tp_say(d->language, "Logo"),
                tp_logo_type(d->logo.kind));
    tp_encode_base64(t, d->logo.bytes, d->logo.length);
    tp_text_add(t, "\">\n");
  }
  if (d->company != NULL) {
    tp_text_add(t, "<p>");
    tp_encode_html(t, d->company);
    tp_text_add(t, "</p>\n");
  }
  tp_text_add(t, "</header>\n");
}

static void add_head(tp_text *t, const tp_document *d) {
  uint8_t hash[TP_SHA256_SIZE];
  const char *code = d->language != NULL ? d->language->code : "en";
  tp_sha256(hash, tp_html_style, strlen(tp_html_style));
  tp_text_add(t, "<!DOCTYPE html>\n<html lang=\"%s\">\n", code);
  tp_text_add(t, "<head>\n<meta charset=\"utf-8\">\n"
                 "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                 "img-src data:; style-src 'sha256-");
  tp_encode_base64(t, hash, sizeof hash);
  tp_text_add(t, "'; base-uri 'none'; form-action 'none'\">\n"
                 "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                 "<meta name=\"color-scheme\" content=\"light dark\">\n"
                 "<meta name=\"generator\" content=\"Topple " TP_VERSION "\">\n<title>");
  tp_encode_html(t, d->title);
  tp_text_add(t, "</title>\n<style>%s</style>\n</head>\n<body>\n<main>\n", tp_html_style);
  add_letterhead(t, d);
  tp_text_add(t, "<h1>");
  tp_encode_html(t, d->title);
  tp_text_add(t, "</h1>\n");
}

static void add_element(tp_text *t, const char *open, const char *text, const char *close) {
  tp_text_add(t, "%s", open);
  tp_encode_html(t, text);
  tp_text_add(t, "%s\n", close);
}

static void add_row(tp_text *t, const tp_table *table, size_t row) {
  const bool facts = table->kind == TP_TABLE_OF_FACTS;
  const bool marked = table->has_mark && table->mark == row;
  tp_text_add(t, marked ? "<tr class=\"governs\">" : "<tr>");
  for (size_t k = 0; k < table->columns; k++) {
    const bool head = k == 0;
    tp_text_add(t, head ? "<th scope=\"row\"" : "<td");
    tp_text_add(t, (table->numeric >> k & 1) != 0 ? " class=\"number\">" : ">");
    if (marked && head && !facts) tp_text_add(t, "<span class=\"mark\">▶ </span>");
    tp_encode_html(t, tp_table_cell(table, row, k));
    tp_text_add(t, head ? "</th>" : "</td>");
  }
  tp_text_add(t, "</tr>\n");
}

/* A table of so few rows stays on one page of paper. */
enum { SHORT = 14 };

static void add_table(tp_text *t, const tp_passage *passage) {
  const tp_table *table = &passage->table;
  tp_text_add(t, "<div class=\"%s\" role=\"region\" tabindex=\"0\" aria-label=\"",
              tp_table_rows(table) <= SHORT ? "wide short" : "wide");
  tp_encode_html(t, passage->text);
  tp_text_add(t, "\">\n<table%s>\n", table->kind == TP_TABLE_OF_FACTS ? " class=\"facts\"" : "");
  add_element(t, "<caption>", passage->text, "</caption>");
  if (table->kind == TP_TABLE_OF_COLUMNS) {
    tp_text_add(t, "<thead><tr>");
    for (size_t k = 0; k < table->columns; k++) {
      tp_text_add(t, "<th scope=\"col\"%s>",
                  (table->numeric >> k & 1) != 0 ? " class=\"number\"" : "");
      tp_encode_html(t, tp_table_head(table, k));
      tp_text_add(t, "</th>");
    }
    tp_text_add(t, "</tr></thead>\n");
  }
  tp_text_add(t, "<tbody>\n");
  for (size_t row = 0; row < tp_table_rows(table); row++) add_row(t, table, row);
  tp_text_add(t, "</tbody>\n</table>\n</div>\n");
}

static void add_figure(tp_text *t, const tp_passage *passage) {
  if (passage->picture.svg == NULL) return;
  tp_text_add(t, passage->fills ? "<figure class=\"sketch\">\n" : "<figure>\n");
  tp_text_add(t, "<img alt=\"");
  tp_encode_html(t, passage->beside);
  tp_text_add(t, "\" src=\"data:image/svg+xml;base64,");
  tp_encode_base64(t, passage->picture.svg, passage->picture.svg_length);
  tp_text_add(t, "\">\n");
  add_element(t, "<figcaption>", passage->text, "</figcaption>");
  tp_text_add(t, "</figure>\n");
}

/* Many lines of a word or a number each, as a DXF has them: they stand in columns. */
static bool is_narrow(const char *text) {
  enum { FEW_LINES = 24, NARROW = 24 };
  long lines = 0;
  for (; *text != '\0'; lines++) {
    const size_t length = strcspn(text, "\n");
    if (length > NARROW) return false;
    text += length + (text[length] == '\n');
  }
  return lines > FEW_LINES;
}

/* Line by line: what a line is stays one. */
static void add_listing(tp_text *t, const tp_passage *passage) {
  const char *at = passage->text;
  tp_text_add(t, "<pre tabindex=\"0\"%s><code>", is_narrow(at) ? " class=\"narrow\"" : "");
  while (*at != '\0') {
    const size_t length = strcspn(at, "\n");
    char *line = strndup(at, length);
    t->failed = t->failed || line == NULL;
    if (line != NULL) tp_encode_html(t, line);
    free(line);
    tp_text_add(t, "\n");
    at += length + (at[length] == '\n');
  }
  tp_text_add(t, "</code></pre>\n");
}

static void add_passage(tp_text *t, const tp_passage *passage) {
  switch (passage->kind) {
  case TP_PASSAGE_HEADING:
    add_element(t, passage->level == 2 ? "<h2>" : "<h3>", passage->text,
                passage->level == 2 ? "</h2>" : "</h3>");
    return;
  case TP_PASSAGE_PARAGRAPH:
    add_element(t, "<p>", passage->text, "</p>");
    return;
  case TP_PASSAGE_ANSWER:
    add_element(t, "<p class=\"answer\">", passage->text, "</p>");
    return;
  case TP_PASSAGE_CAUTION:
    add_element(t, "<p class=\"caution\">", passage->text, "</p>");
    return;
  case TP_PASSAGE_EQUATION:
    tp_text_add(t, "<div class=\"equation\" role=\"group\" tabindex=\"0\">\n");
    tp_math_to_html(t, passage->text);
    tp_text_add(t, "</div>\n");
    return;
  case TP_PASSAGE_TABLE:
    add_table(t, passage);
    return;
  case TP_PASSAGE_FIGURE:
    add_figure(t, passage);
    return;
  case TP_PASSAGE_LISTING:
    add_listing(t, passage);
    return;
  case TP_PASSAGE_PAGE:
    tp_text_add(t, "<hr class=\"page\">\n");
    return;
  }
}

tp_status tp_document_html(char **text, const tp_document *d) {
  if (d->failed) return TP_OUT_OF_MEMORY;
  tp_text t = {0};
  add_head(&t, d);
  for (size_t k = 0; k < d->count; k++) add_passage(&t, d->passages + k);
  tp_text_add(&t, "</main>\n<footer>\n");
  add_element(&t, "<p>", d->foot, "</p>");
  tp_text_add(&t, "</footer>\n</body>\n</html>\n");
  return tp_text_finish(&t, text);
}
