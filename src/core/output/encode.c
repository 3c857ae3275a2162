/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Escapes for JSON, comments of C and LaTeX, Markdown, HTML, CSV and gnuplot, character by
 * character over plain text; base64 of bytes. */

#include "output/encode.h"

#include "common/outside.h"

#include <stdlib.h>
#include <string.h>

void tp_encode_plain(tp_text *t, const char *outside) {
  char next[TP_PLAIN_SIZE];
  while (*outside != '\0') tp_text_add(t, "%s", tp_plain_next(next, &outside));
}

void tp_encode_column(tp_text *t, const char *outside, int width) {
  char next[TP_PLAIN_SIZE];
  int characters = 0;
  while (*outside != '\0') {
    for (const char *c = tp_plain_next(next, &outside); *c != '\0'; c++) {
      characters += ((unsigned char)*c & 0xc0) != 0x80;
    }
    tp_text_add(t, "%s", next);
  }
  if (characters < width) tp_text_add(t, "%*s", width - characters, "");
}

/* How many bytes of ASCII stand at the beginning that a string of JSON holds as they are. */
static size_t json_span(const char *text) {
  size_t length = 0;
  while (text[length] >= ' ' && text[length] <= '~' && text[length] != '"' &&
         text[length] != '\\') {
    length++;
  }
  return length;
}

static void add_json_character(tp_text *t, const char *outside, uint32_t c, size_t length) {
  char plain[TP_PLAIN_SIZE];
  const char *after = outside;
  const bool seen = strncmp(tp_plain_next(plain, &after), outside, length) == 0;
  if (c == TP_NO_CHARACTER) {
    tp_text_add(t, "\\ufffd");
  } else if (c == '"' || c == '\\') {
    tp_text_add(t, "\\%c", (int)c);
  } else if (!seen && c > 0xffff) {
    const unsigned pair = (unsigned)c - 0x10000; /* in UTF-16, as JSON has it */
    tp_text_add(t, "\\u%04x\\u%04x", 0xd800 + (pair >> 10), 0xdc00 + (pair & 0x3ff));
  } else if (!seen) {
    tp_text_add(t, "\\u%04x", (unsigned)c);
  } else {
    tp_text_append(t, outside, length);
  }
}

void tp_encode_json(tp_text *t, const char *outside) {
  tp_text_append(t, "\"", 1);
  while (*outside != '\0') {
    const size_t span = json_span(outside);
    tp_text_append(t, outside, span);
    outside += span;
    if (*outside == '\0') break;
    uint32_t c = 0;
    const size_t length = tp_character_read(&c, outside);
    add_json_character(t, outside, c, length);
    outside += length;
  }
  tp_text_append(t, "\"", 1);
}

/* A blank between two characters that mean something together. */
void tp_encode_c_comment(tp_text *t, const char *outside) {
  char next[TP_PLAIN_SIZE], before = ' ';
  while (*outside != '\0') {
    tp_plain_next(next, &outside);
    const bool together = (before == '*' && *next == '/') || (before == '/' && *next == '*') ||
                          (before == '?' && *next == '?');
    tp_text_add(t, "%s%s", together ? " " : "", next);
    before = next[strlen(next) - 1];
  }
  /* nothing that follows joins with it, a line spliced by a backslash neither */
  if (strchr("*/\\", before) != NULL) tp_text_add(t, " ");
}

void tp_encode_latex_comment(tp_text *t, const char *outside) {
  tp_encode_plain(t, outside);
}

/* Of a character of Markdown that means something: itself with a stroke before it, or, as HTML
 * knows no strokes, its name. */
static void add_markdown(tp_text *t, const char *plain, bool first, bool code) {
  static const char *const names[] = {"<", "&lt;", ">", "&gt;", "&", "&amp;", "@", "&#64;"};
  for (size_t k = 0; k < sizeof names / sizeof names[0]; k += 2) {
    if (strcmp(plain, names[k]) != 0) continue;
    tp_text_add(t, "%s", names[k + 1]);
    return;
  }
  const bool always = strchr("\\`*_[]{}#|~$", *plain) != NULL;
  const bool begins = first && strchr("+-=:", *plain) != NULL;
  if (always && code) {
    tp_text_add(t, "&#%d;", *plain);
  } else {
    tp_text_add(t, "%s%s", always || begins ? "\\" : "", plain);
  }
}

void tp_encode_markdown(tp_text *t, const char *outside) {
  char next[TP_PLAIN_SIZE];
  const char *const begin = outside;
  bool first = true, digits = true; /* but digits nothing so far, as before an item of a list */
  while (*outside != '\0') {
    const char *at = outside;
    tp_plain_next(next, &outside);
    if (first && *next == ' ') continue; /* or a paragraph becomes code */
    const bool item = *outside == '\0' || strchr(" \t\n", *outside) != NULL;
    const bool ends_digits = digits && item && !first && strchr(".)", *next) != NULL;
    const bool ends_www = *next == '.' && at - begin >= 3 && strncmp(at - 3, "www", 3) == 0;
    if (*next == ':' && *outside == '/') {
      tp_text_add(t, "&#58;"); /* or an address becomes a link */
    } else if (ends_digits || ends_www) {
      tp_text_add(t, "\\%s", next);
    } else {
      add_markdown(t, next, first, false);
    }
    digits = digits && *next >= '0' && *next <= '9';
    first = false;
  }
}

void tp_encode_markdown_code(tp_text *t, const char *outside) {
  char next[TP_PLAIN_SIZE];
  const bool simple = strpbrk(outside, "`|\\") == NULL && *outside != '\0' && *outside != ' ' &&
                      outside[strlen(outside) - 1] != ' ';
  tp_text_add(t, simple ? "`" : "<code>");
  while (*outside != '\0') {
    tp_plain_next(next, &outside);
    if (simple) {
      tp_text_add(t, "%s", next);
    } else {
      add_markdown(t, next, false, true);
    }
  }
  tp_text_add(t, simple ? "`" : "</code>");
}

void tp_encode_html(tp_text *t, const char *outside) {
  static const char signs[] = "<>&\"'";
  static const char *const names[] = {"&lt;", "&gt;", "&amp;", "&quot;", "&#39;"};
  char next[TP_PLAIN_SIZE];
  while (*outside != '\0') {
    tp_plain_next(next, &outside);
    const char *sign = strchr(signs, *next);
    tp_text_add(t, "%s", sign != NULL ? names[sign - signs] : next);
  }
}

void tp_encode_base64(tp_text *t, const void *bytes, size_t length) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const unsigned char *at = bytes;
  for (size_t k = 0; k < length; k += 3) {
    const size_t left = length - k;
    const unsigned long three = (unsigned long)at[k] << 16 |
                                (left > 1 ? (unsigned long)at[k + 1] << 8 : 0) |
                                (left > 2 ? at[k + 2] : 0);
    char four[] = "====";
    four[0] = digits[three >> 18];
    four[1] = digits[three >> 12 & 63];
    if (left > 1) four[2] = digits[three >> 6 & 63];
    if (left > 2) four[3] = digits[three & 63];
    tp_text_append(t, four, 4);
  }
}

static bool is_number(const char *text) {
  char *end = NULL;
  (void)strtod(text, &end);
  return end != text && *end == '\0';
}

void tp_encode_csv(tp_text *t, const char *outside) {
  char next[TP_PLAIN_SIZE];
  const char *first = outside + strspn(outside, " \t\r\n");
  const bool formula = *first != '\0' && strchr("=+-@", *first) != NULL && !is_number(outside);
  const bool quoted = strpbrk(outside, ",;\"'\t\r\n") != NULL || formula || *outside == ' ';
  tp_text_add(t, "%s%s", quoted ? "\"" : "", formula ? "'" : "");
  while (*outside != '\0') {
    tp_plain_next(next, &outside);
    tp_text_add(t, "%s", *next == '"' ? "\"\"" : next);
  }
  tp_text_add(t, quoted ? "\"" : "");
}

/* Read by gnuplot 5.4: two quotes at the beginning are an empty string to it, and in SVG it writes
 * a > as it is, though XML allows none behind two brackets. A blank keeps them apart. */
void tp_encode_gnuplot(tp_text *t, const char *outside) {
  char next[TP_PLAIN_SIZE];
  int brackets = 0;
  tp_text_add(t, "'%s", *outside == '\'' ? " " : "");
  while (*outside != '\0') {
    tp_plain_next(next, &outside);
    if (*next == '>' && brackets >= 2) tp_text_add(t, " ");
    tp_text_add(t, "%s", *next == '\'' ? "''" : next);
    brackets = *next == ']' ? brackets + 1 : 0;
  }
  tp_text_add(t, "'");
}
