/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Look-up of a phrase by bisection, and decimal commas in a text. */

#include "output/language.h"

#include <string.h>

const char *tp_say(const tp_language *language, const char *english) {
  size_t from = 0, to = language != NULL ? language->count : 0;
  while (from < to) {
    const size_t middle = from + (to - from) / 2;
    const tp_phrase *own = language->phrases + middle;
    const int order = strcmp(english, own->english);
    if (order == 0) return own->own;
    if (order < 0) {
      to = middle;
    } else {
      from = middle + 1;
    }
  }
  return english;
}

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/* A letter, also one of another script, which a number does not follow within a word. */
static bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' || c == '/';
}

/* Behind what is a digit: does a number follow the comma, maybe with its sign? */
static bool parts_numbers(const char *at) {
  static const char minus[] = "−";
  if (at[0] != ',' || at[1] != ' ') return false;
  at += 2;
  if (*at == '-') at++;
  if (strncmp(at, minus, strlen(minus)) == 0) at += strlen(minus);
  return is_digit(*at);
}

void tp_language_set_commas(char *text) {
  char before = ' ';
  for (char *at = text; *at != '\0';) {
    if (!is_digit(*at)) {
      before = *at++;
      continue;
    }
    char *from = at;
    while (is_digit(*at)) at++;
    char *point = *at == '.' && is_digit(at[1]) ? at : NULL;
    if (point != NULL) at++;
    while (point != NULL && is_digit(*at)) at++;
    const bool number = !(is_word(before) && from > text) && !(*at == '.' && is_digit(at[1]));
    if (number && point != NULL) *point = ',';
    if (number && parts_numbers(at)) *at = ';';
    before = at[-1];
    if (!number) before = 'x';
  }
}
