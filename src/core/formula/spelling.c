/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Length of a name in a text, and its spelling in ASCII with Greek letters by their names, from a
 * table of UTF-8. */

#include "formula/spelling.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

static bool is_plain(char c, bool first) {
  return isalpha((unsigned char)c) || c == '_' || (!first && isdigit((unsigned char)c));
}

size_t tp_name_length(const char *text) {
  size_t length = 0;
  while (is_plain(text[length], length == 0)) length++;
  return length;
}

/* UTF-8 of the letters that papers of this field use. The capital delta is a difference, as in the
 * block's width. */
static const struct {
  const char *letter, *name;
} letters[] = {{"\u03b1", "alpha"}, {"\u03b2", "beta"},  {"\u03b3", "gamma"},  {"\u03b4", "delta"},
               {"\u03b8", "theta"}, {"\u03ba", "kappa"}, {"\u03bb", "lambda"}, {"\u03bc", "mu"},
               {"\u03c1", "rho"},   {"\u03c3", "sigma"}, {"\u03c4", "tau"},    {"\u03c6", "phi"},
               {"\u03d5", "phi"},   {"\u03c8", "psi"},   {"\u0394", "d"},      {"\u2206", "d"},
               {"\u2113", "l"}};

/* One character of a name: its bytes, and what it is spelt as. */
static size_t spell_one(const char **spelt, size_t *length, const char *text, bool first) {
  if (is_plain(*text, first)) {
    *spelt = text;
    *length = 1;
    return 1;
  }
  if (((unsigned char)*text & 0x80) == 0) return 0;
  for (size_t k = 0; k < sizeof letters / sizeof letters[0]; k++) {
    const size_t bytes = strlen(letters[k].letter);
    if (strncmp(text, letters[k].letter, bytes) != 0) continue;
    *spelt = letters[k].name;
    *length = strlen(letters[k].name);
    return bytes;
  }
  return 0;
}

size_t tp_name_spell(char *name, size_t size, const char *text, size_t most) {
  size_t used = 0, filled = 0;
  const char *spelt = NULL;
  size_t length = 0;
  for (;;) {
    const size_t bytes = used < most ? spell_one(&spelt, &length, text + used, used == 0) : 0;
    if (bytes == 0 || used + bytes > most || filled + length >= size) break;
    memcpy(name + filled, spelt, length);
    filled += length;
    used += bytes;
  }
  name[filled] = '\0';
  return used;
}
