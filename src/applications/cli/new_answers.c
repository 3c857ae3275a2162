/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Syntax checks of answers (units, sizes, numbers, directions) and a writer of quoted YAML
 * strings. */

#include "cli/new_answers.h"

#include <string.h>

/* The length of the number, a decimal or a fraction of two, that the text begins with; 0: none. */
static size_t number_length(const char *text) {
  static const char digits[] = "0123456789";
  size_t length = strspn(text, "+-");
  if (length > 1) return 0;
  for (int part = 0; part < 2; part++) {
    const size_t whole = strspn(text + length, digits);
    const size_t point = text[length + whole] == '.' ? 1 : 0;
    const size_t rest = point == 1 ? strspn(text + length + whole + 1, digits) : 0;
    if (whole + rest == 0) return 0;
    length += whole + point + rest;
    if (part == 1 || text[length] != '/') break;
    length++;
  }
  return length;
}

const char *tp_cli_wrong_unit(const char *text) {
  static const char *const units[] = {"mm", "cm", "m", "km", "in", "ft"};
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    if (strcmp(text, units[k]) == 0) return NULL;
  }
  return "the length unit is one of mm, cm, m, km, in, ft";
}

/* Where the second number begins; NULL: the text is no two numbers. */
static const char *second_of(const char *text, size_t *first) {
  *first = number_length(text);
  const char *second = text + *first + strspn(text + *first, " x");
  const size_t length = number_length(second);
  return *first > 0 && second > text + *first && length > 0 && second[length] == '\0' ? second
                                                                                      : NULL;
}

const char *tp_cli_wrong_size(const char *text) {
  size_t first = 0;
  return second_of(text, &first) != NULL ? NULL
                                         : "a block is its width and height, as 2x4 or 0.5x1.25";
}

const char *tp_cli_wrong_number(const char *text) {
  const size_t length = number_length(text);
  return *text == '\0' || (length > 0 && text[length] == '\0')
             ? NULL
             : "a number has digits and a decimal point, as 26 or 25.8; no unit, no comma";
}

const char *tp_cli_wrong_towards(const char *text) {
  return strcmp(text, "left") == 0 || strcmp(text, "right") == 0 || strcmp(text, "both") == 0
             ? NULL
             : "the block is tilted towards left, right or both";
}

void tp_cli_write_quoted(FILE *out, const char *text) {
  char plain[4 * TP_CLI_ANSWER];
  tp_plain_text(plain, sizeof plain, text);
  fputc('"', out);
  for (const char *at = plain; *at != '\0'; at++) {
    if (*at == '"' || *at == '\\') fputc('\\', out);
    fputc(*at, out);
  }
  fputc('"', out);
}
