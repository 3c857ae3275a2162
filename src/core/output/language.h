/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The language of a text: phrases that stand for English ones, and the sign before decimals. A
 * phrase is a format of printf; what stands for it has the same arguments, in another order where
 * it numbers them (%2$s). terms/phrases.csv has the table of them. */

#ifndef TP_OUTPUT_LANGUAGE_H
#define TP_OUTPUT_LANGUAGE_H

#include <stdbool.h>
#include <stddef.h>

typedef struct tp_phrase {
  const char *english, *own;
} tp_phrase;

typedef struct tp_language {
  const char *code;         /* as HTML has it: en, es, de */
  bool comma;               /* before decimals, else a point */
  size_t count;             /* none: English */
  const tp_phrase *phrases; /* in the order of their English bytes */
} tp_language;

/* What stands for the English phrase, which itself where the language has none, or is NULL. */
const char *tp_say(const tp_language *language, const char *english) __attribute__((format_arg(2)));

/* In a text of our own: a comma before the decimals of each number, and a semicolon between
 * numbers that a comma and a blank part. What begins with a letter, as A1.3, is no number, nor is
 * what has two points, as a version. */
void tp_language_set_commas(char *text);

#endif
