/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Text from outside (titles, keys, names of files, words of the command line) made plain: what a
 * terminal prints as one line, and nothing else.
 *
 * One rule. Characters of UTF-8 that can be seen stay as they are. White space of any kind becomes
 * a blank. What acts unseen (control characters, marks of writing direction, characters without
 * width, code points that are no characters) is spelt out, \x1B, \u202E or \U000E0001, and so is a
 * byte that belongs to no character, \xFF. A backslash stays, so that plain text is its own plain
 * text. tp_plain_text, which is public, makes a whole text plain; the encoders for every language
 * of output are in output/encode.h. */

#ifndef TP_COMMON_OUTSIDE_H
#define TP_COMMON_OUTSIDE_H

#include "topple.h"

#include <stdint.h>

/* Stands for a byte that begins no character of UTF-8. */
#define TP_NO_CHARACTER UINT32_MAX

/* The character at `text`, which is not empty, and how many bytes it takes, 1 where it is none. */
size_t tp_character_read(uint32_t *character, const char *text);

/* The whole of tp_plain_text, to be freed; NULL when memory is exhausted. */
char *tp_plain_new(const char *text);

enum { TP_PLAIN_SIZE = 12 };

/* The character at `*text` as plain text, and step past it. */
const char *tp_plain_next(char plain[TP_PLAIN_SIZE], const char **text);

/* What a message quotes: at most so many bytes, made plain and cut at a character. */
typedef struct tp_quote {
  char text[128];
} tp_quote;

/* Of the first `length` bytes, or of all that there are. */
tp_quote tp_quote_of(const char *text, size_t length);
tp_quote tp_quote_all(const char *text);

/* How many of the first `most` bytes are whole characters. */
size_t tp_whole_characters(const char *text, size_t most);

/* The start of the last `room` bytes of the text that is no part of a character. */
const char *tp_tail_of(const char *text, size_t room);

#endif
