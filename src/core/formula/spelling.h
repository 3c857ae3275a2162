/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names as formulas write them: letters, digits and _, not a digit first, and Greek letters. */

#ifndef TP_FORMULA_SPELLING_H
#define TP_FORMULA_SPELLING_H

#include <stddef.h>

/* The length of the plain name, without Greek letters, at the front of a text; 0 where none
 * begins. */
size_t tp_name_length(const char *text);

/* A name, Greek letters spelt out, is shorter; what is longer is refused, never cut. */
enum { TP_NAME_SIZE = 128 };

/* The name within the first `most` bytes of a text with Greek letters spelt out (delta for its
 * letter, d for the capital one); bytes used, 0 where no name begins. */
size_t tp_name_spell(char *name, size_t size, const char *text, size_t most);

#endif
