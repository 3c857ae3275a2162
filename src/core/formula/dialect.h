/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What may stand in a formula besides + - * / ^, parentheses, decimals and plain names, what
 * messages call its parts, and which names it knows. */

#ifndef TP_FORMULA_DIALECT_H
#define TP_FORMULA_DIALECT_H

#include <stdbool.h>
#include <stddef.h>

typedef struct tp_dialect {
  bool letters;    /* Greek letters in names, and the signs of print: U+2212, dots and crosses for
                    * products, braces for parentheses, degree signs behind numbers */
  bool products;   /* factors side by side: 27ab, 2(a + b) */
  bool functions;  /* sin(x), sin alpha, sin^2 alpha, and so on (tp_function); tan^-1 of an angle is
                    * the cotangent, of anything else the arctangent */
  bool lines;      /* several lines; blanks and tabs may stand anywhere */
  long most_nodes; /* numbers, names and operators in one formula; 0: as many as memory holds */

  const char *formula;      /* "a formula": what belongs where there is nothing */
  const char *operand;      /* "a number or a name": what is missing behind an operator */
  const char *no_operand;   /* "is no number": said of what is no operand */
  const char *continued;    /* "a formula": what a stray text does not continue */
  const char *unknown_name; /* "define it …": what to do about an unknown name */
  size_t quoted;            /* bytes of a stray text that a message quotes at most */
} tp_dialect;

/* The names that a formula may use: `find` gives the number of a name (not terminated, Greek
 * letters spelt out) or -1, `is_angle` tells whether it stands for an angle; it is asked where the
 * dialect has functions alone. */
typedef struct tp_vocabulary {
  long (*find)(const void *context, const char *name, size_t length);
  bool (*is_angle)(const void *context, long name);
  const void *context;
} tp_vocabulary;

#endif
