/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Decoder of UTF-8 (Unicode, table 3-7) and the table of code points without visible form, which
 * are spelt as escapes. */

#include "common/outside.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char ellipsis[] = "…";

/* Unicode 3.9, table 3-7: no overlong form, no surrogate, nothing beyond U+10FFFF. */
size_t tp_character_read(uint32_t *character, const char *text) {
  const unsigned char first = (unsigned char)text[0];
  *character = first;
  if (first < 0x80) return 1;
  *character = TP_NO_CHARACTER;
  const size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 1;
  uint32_t value = first & (0xffU >> (length + 1));
  for (size_t k = 1; k < length; k++) {
    const unsigned char next = (unsigned char)text[k];
    if ((next & 0xc0) != 0x80) return 1;
    value = value << 6 | (next & 0x3fU);
  }
  static const uint32_t least[] = {0x80, 0x800, 0x10000};
  if (value < least[length - 2] || value > 0x10ffff) return 1;
  if (value >= 0xd800 && value <= 0xdfff) return 1;
  *character = value;
  return length;
}

static bool is_space(uint32_t c) {
  return (c >= '\t' && c <= '\r') || c == 0x85 || c == 0x2028 || c == 0x2029;
}

/* Characters that are not seen but act: of the general categories Cc and Cf of Unicode, fillers,
 * and code points that are no characters. Selectors of variants of a character are seen in it. */
static bool acts_unseen(uint32_t c) {
  static const struct {
    uint32_t first, last;
  } unseen[] = {{0x00, 0x1f},       {0x7f, 0x9f},       {0xad, 0xad},       {0x34f, 0x34f},
                {0x600, 0x605},     {0x61c, 0x61c},     {0x6dd, 0x6dd},     {0x70f, 0x70f},
                {0x890, 0x891},     {0x8e2, 0x8e2},     {0x115f, 0x1160},   {0x17b4, 0x17b5},
                {0x180b, 0x180f},   {0x200b, 0x200f},   {0x2028, 0x202e},   {0x2060, 0x206f},
                {0x3164, 0x3164},   {0xfdd0, 0xfdef},   {0xfeff, 0xfeff},   {0xffa0, 0xffa0},
                {0xfff0, 0xfffb},   {0x110bd, 0x110bd}, {0x110cd, 0x110cd}, {0x13430, 0x1343f},
                {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0000, 0xe0fff}};
  for (size_t k = 0; k < sizeof unseen / sizeof unseen[0]; k++) {
    if (c >= unseen[k].first && c <= unseen[k].last) return true;
  }
  return (c & 0xfffe) == 0xfffe; /* the last two of every plane */
}

const char *tp_plain_next(char plain[TP_PLAIN_SIZE], const char **text) {
  uint32_t c = 0;
  const size_t length = tp_character_read(&c, *text);
  if (c == TP_NO_CHARACTER) {
    snprintf(plain, TP_PLAIN_SIZE, "\\x%02X", (unsigned)(unsigned char)**text);
  } else if (is_space(c)) {
    snprintf(plain, TP_PLAIN_SIZE, " ");
  } else if (acts_unseen(c)) {
    const char *format = c < 0x80 ? "\\x%02X" : c <= 0xffff ? "\\u%04X" : "\\U%08X";
    snprintf(plain, TP_PLAIN_SIZE, format, (unsigned)c);
  } else {
    memcpy(plain, *text, length);
    plain[length] = '\0';
  }
  *text += length;
  return plain;
}

void tp_plain_text(char *plain, size_t size, const char *text) {
  char next[TP_PLAIN_SIZE];
  size_t length = 0, fits = 0; /* and `fits` leaves room for the ellipsis */
  if (plain == NULL || size == 0) return;
  if (text == NULL || size <= strlen(ellipsis)) text = "";
  while (*text != '\0') {
    const size_t added = strlen(tp_plain_next(next, &text));
    if (length + added >= size) {
      length = fits;
      memcpy(plain + length, ellipsis, strlen(ellipsis));
      length += strlen(ellipsis);
      break;
    }
    memcpy(plain + length, next, added);
    length += added;
    if (length + strlen(ellipsis) < size) fits = length;
  }
  plain[length] = '\0';
}

char *tp_plain_new(const char *text) {
  enum { MOST_OF_A_BYTE = 4 }; /* \xFF; what takes more is of characters of more bytes */
  const size_t size = MOST_OF_A_BYTE * (strlen(text) + 1);
  char *plain = malloc(size);
  if (plain != NULL) tp_plain_text(plain, size, text);
  return plain;
}

size_t tp_whole_characters(const char *text, size_t most) {
  size_t taken = 0;
  while (text[taken] != '\0') {
    uint32_t c = 0;
    const size_t next = tp_character_read(&c, text + taken);
    if (taken + next > most) break;
    taken += next;
  }
  return taken;
}

/* Bytes of a text that a message quotes: a line of 80 columns keeps room for what is said of it. */
enum { MOST_QUOTED = 60 };

tp_quote tp_quote_of(const char *text, size_t length) {
  char own[MOST_QUOTED + sizeof ellipsis];
  const size_t all = strnlen(text, length);
  const size_t taken = tp_whole_characters(text, all < MOST_QUOTED ? all : MOST_QUOTED);
  memcpy(own, text, taken);
  strcpy(own + taken, taken < all ? ellipsis : "");
  tp_quote quote;
  tp_plain_text(quote.text, sizeof quote.text, own);
  return quote;
}

tp_quote tp_quote_all(const char *text) {
  return tp_quote_of(text, strlen(text));
}

const char *tp_tail_of(const char *text, size_t room) {
  const size_t length = strlen(text);
  if (length <= room) return text;
  const char *tail = text + length - room;
  while (((unsigned char)*tail & 0xc0) == 0x80) tail++; /* ends at the zero */
  return tail;
}
