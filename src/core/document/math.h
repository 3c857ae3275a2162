/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The notation in which equations of a document are written, a small part of LaTeX:
 *
 *     a b     signs: letters (also Greek ones), numbers with their degrees, operators, brackets
 *     \tan    a function's name, upright: arctan, sin, cos, tan, min
 *     \sum    the sign of a sum
 *     \text{…}  words
 *     \frac{a}{b}, \bar{x}, a_b, a_{bc}, a^b
 *     \\      a new line of the same equation
 *
 * Writers read it sign by sign; every one of them follows the same reader. */

#ifndef TP_DOCUMENT_MATH_H
#define TP_DOCUMENT_MATH_H

#include <stdbool.h>
#include <stddef.h>

typedef enum tp_math_kind {
  TP_MATH_END,      /* of the text, or of its group */
  TP_MATH_LETTER,   /* a quantity */
  TP_MATH_NUMBER,   /* with its sign of degrees */
  TP_MATH_FUNCTION, /* an upright name */
  TP_MATH_WORDS,
  TP_MATH_OPERATOR,
  TP_MATH_GROUP,    /* { … }: its content is `text` */
  TP_MATH_FRACTION, /* two groups follow */
  TP_MATH_BAR,      /* a group follows */
  TP_MATH_BELOW,    /* _: what follows is an index of what was before */
  TP_MATH_ABOVE,    /* ^: an exponent */
  TP_MATH_LINE      /* a new line */
} tp_math_kind;

typedef struct tp_math_sign {
  tp_math_kind kind;
  const char *text; /* within the equation */
  size_t length;
} tp_math_sign;

/* The sign at `*at`, and step past it; nothing beyond `end` is read. */
tp_math_sign tp_math_next(const char **at, const char *end);

/* Is the next sign an index, an exponent? It is not stepped past. */
bool tp_math_follows(const char *at, const char *end, tp_math_kind kind);

#endif
