/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Phrases as patterns, matched from left to right: an argument takes as little as lets the rest
 * match. The steps of all matches of a text are counted, so that no text from outside makes it
 * long: beyond them, and of more than LONGEST bytes, the text stays English. */

#include "output/translate.h"

#include <string.h>

enum { ARGUMENTS = 8, DEEPEST = 8, LONGEST = 4096, MOST_STEPS = 2000000, LEAST_LITERAL = 2 };

typedef struct span {
  const char *at;
  size_t length;
} span;

typedef struct work {
  const tp_language *language;
  long steps;
} work;

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/* ---- conversions of a format -------------------------------------------------------------------
 */

/* Of "%s", "%2$s", "%zu": its length, which argument, counted from 0 (-1: the next one), and
 * whether it is a whole number. 0: none begins here. */
static size_t conversion(const char *at, int *argument, bool *whole) {
  if (at[0] != '%' || at[1] == '%') return 0;
  size_t length = 1;
  *argument = -1;
  if (is_digit(at[1]) && at[2] == '$') {
    *argument = at[1] - '1';
    length = 3;
  }
  while (at[length] == 'l' || at[length] == 'z') length++;
  *whole = at[length] != 's';
  return length + 1;
}

/* Does the text have the separator here, with something on both sides? */
static size_t separator_at(span text, size_t at, const char *separator) {
  const size_t length = strlen(separator);
  if (at == 0 || at + length >= text.length) return 0;
  if (memcmp(text.at + at, separator, length) != 0) return 0;
  if (*separator != '.') return length;
  const char next = text.at[at + length]; /* a sentence begins */
  return (next >= 'A' && next <= 'Z') || next == '(' ? length : 0;
}

/* No argument goes on behind the end of a sentence, or of a part of it. */
static bool ends_at(span text, size_t at) {
  return separator_at(text, at, ". ") > 0 || separator_at(text, at, ".) ") > 0 ||
         separator_at(text, at, "; ") > 0;
}

/* ---- matching ----------------------------------------------------------------------------------
 */

static bool match(work *w, const char *pattern, span text, span found[ARGUMENTS], int count);

/* An argument takes some bytes from the beginning, of one sentence, and the rest of the pattern
 * what follows. */
static bool match_argument(work *w, const char *rest, span text, span found[ARGUMENTS], int count,
                           bool whole) {
  if (count == ARGUMENTS) return false;
  for (size_t length = 1; length <= text.length; length++) {
    if (whole && !is_digit(text.at[length - 1])) return false;
    if (ends_at(text, length - 1)) return false;
    found[count] = (span){text.at, length};
    if (match(w, rest, (span){text.at + length, text.length - length}, found, count + 1)) {
      return true;
    }
    if (w->steps < 0) return false;
  }
  return false;
}

static bool match(work *w, const char *pattern, span text, span found[ARGUMENTS], int count) {
  for (;;) {
    if (w->steps-- < 0) return false;
    int argument = 0;
    bool whole = false;
    const size_t length = conversion(pattern, &argument, &whole);
    if (length > 0) return match_argument(w, pattern + length, text, found, count, whole);
    if (*pattern == '\0' || text.length == 0) return *pattern == '\0' && text.length == 0;
    if (*pattern != *text.at) return false;
    pattern += *pattern == '%' ? 2 : 1;
    text.at++;
    text.length--;
  }
}

/* Bytes of a pattern beside its arguments and blanks; 0 of one with two that nothing parts. */
static size_t literal_of(const char *pattern) {
  size_t literal = 0, before = 0;
  while (*pattern != '\0') {
    int argument = 0;
    bool whole = false;
    const size_t length = conversion(pattern, &argument, &whole);
    if (length > 0 && before > 0) return 0;
    before = length;
    literal += length == 0 && *pattern != ' ';
    pattern += length > 0 ? length : *pattern == '%' ? 2 : 1; /* "%%" is one */
  }
  return literal;
}

/* The phrase that fits with most of the text in it, and with more than `most`; NULL: none. */
static const tp_phrase *find(work *w, span text, span found[ARGUMENTS], size_t *most) {
  const tp_phrase *best = NULL;
  for (size_t k = 0; k < w->language->count && w->steps > 0; k++) {
    const tp_phrase *own = w->language->phrases + k;
    const bool plain = strchr(own->english, '%') == NULL;
    span own_found[ARGUMENTS];
    if (plain) {
      const size_t length = strlen(own->english);
      if (length != text.length || memcmp(own->english, text.at, length) != 0) continue;
      *most = length;
      return own;
    }
    if (*own->english != '%' && *own->english != *text.at) continue;
    const size_t literal = literal_of(own->english);
    if (literal <= *most || literal > text.length) continue;
    if (!match(w, own->english, text, own_found, 0)) continue;
    best = own;
    *most = literal;
    memcpy(found, own_found, sizeof own_found);
  }
  return best;
}

/* ---- translating -------------------------------------------------------------------------------
 */

static void translate(tp_text *t, work *w, span text, int depth);

static void fill(tp_text *t, work *w, const char *own, const span found[ARGUMENTS], int depth) {
  int next = 0;
  while (*own != '\0') {
    int argument = 0;
    bool whole = false;
    const size_t length = conversion(own, &argument, &whole);
    if (length > 0) {
      translate(t, w, found[argument >= 0 ? argument : next], depth + 1);
      next++;
      own += length;
    } else {
      tp_text_append(t, own, 1);
      own += *own == '%' ? 2 : 1;
    }
  }
}

/* The first place of a separator that stands in no brackets and quotes, but where it closes them;
 * 0: none. */
static size_t split(span text, const char *separator, size_t *length) {
  const int inside = separator[1] == ')' ? 1 : 0;
  int brackets = 0;
  bool quoted = false;
  for (size_t at = 0; at < text.length; at++) {
    const char c = text.at[at];
    if (c == '\'' && (quoted || at == 0 || text.at[at - 1] == ' ')) quoted = !quoted;
    brackets += !quoted && c == '(' ? 1 : !quoted && c == ')' ? -1 : 0;
    *length = quoted || brackets != inside ? 0 : separator_at(text, at, separator);
    if (*length > 0) return at;
  }
  return 0;
}

/* In brackets as a whole: what they hold. */
static bool is_bracketed(span text) {
  if (text.length < 3 || text.at[0] != '(' || text.at[text.length - 1] != ')') return false;
  return memchr(text.at + 1, ')', text.length - 2) == NULL;
}

static void translate_parts(tp_text *t, work *w, span text, int depth) {
  static const char *const separators[] = {". ", ".) ", "; ", ": ", ", "};
  for (size_t k = 0; k < sizeof separators / sizeof separators[0]; k++) {
    size_t length = 0;
    const size_t at = split(text, separators[k], &length);
    if (at == 0) continue;
    const size_t own = *separators[k] == '.' ? length - 1 : 0; /* a sentence with its full stop */
    translate(t, w, (span){text.at, at + own}, depth + 1);
    tp_text_append(t, text.at + at + own, length - own);
    translate(t, w, (span){text.at + at + length, text.length - at - length}, depth);
    return;
  }
  tp_text_append(t, text.at, text.length);
}

/* Is it one sentence with its full stop? */
static bool ends_sentence(span text) {
  size_t length = 0;
  return text.length > 1 && text.at[text.length - 1] == '.' && split(text, ". ", &length) == 0 &&
         split(text, ".) ", &length) == 0;
}

static void translate(tp_text *t, work *w, span text, int depth) {
  while (text.length > 0 && *text.at == ' ') {
    tp_text_append(t, " ", 1);
    text = (span){text.at + 1, text.length - 1};
  }
  span found[ARGUMENTS];
  if (depth > DEEPEST || w->steps < 0) {
    tp_text_append(t, text.at, text.length);
    return;
  }
  size_t most = LEAST_LITERAL - 1;
  const bool stops = ends_sentence(text); /* a phrase without the full stop first */
  const tp_phrase *own = stops ? find(w, (span){text.at, text.length - 1}, found, &most) : NULL;
  const tp_phrase *whole = find(w, text, found, &most);
  const bool dot = own != NULL && whole == NULL;
  if (whole != NULL) own = whole;
  if (own != NULL) {
    fill(t, w, own->own, found, depth);
    if (dot) tp_text_append(t, ".", 1);
  } else if (stops) {
    translate_parts(t, w, (span){text.at, text.length - 1}, depth);
    tp_text_append(t, ".", 1);
  } else if (is_bracketed(text)) {
    tp_text_append(t, "(", 1);
    translate(t, w, (span){text.at + 1, text.length - 2}, depth + 1);
    tp_text_append(t, ")", 1);
  } else {
    translate_parts(t, w, text, depth);
  }
}

/* Words with one blank between them. */
static void add_words(tp_text *t, const char *text) {
  for (; *text != '\0'; text++) {
    if (*text != ' ' || text[1] != ' ') tp_text_append(t, text, 1);
  }
}

void tp_translate(tp_text *t, const tp_language *language, bool comma, const char *english) {
  tp_text words = {0};
  add_words(&words, english);
  const span all = {words.data, words.length};
  work w = {.language = language, .steps = MOST_STEPS};
  const size_t before = t->length;
  t->failed = t->failed || words.failed;
  if (all.length == 0 || t->failed) {
    tp_text_drop(&words);
    return;
  }
  if (language == NULL || language->count == 0 || all.length > LONGEST) {
    tp_text_append(t, all.at, all.length);
  } else {
    translate(t, &w, all, 0);
  }
  if (comma && !t->failed) tp_language_set_commas(t->data + before);
  tp_text_drop(&words);
}
