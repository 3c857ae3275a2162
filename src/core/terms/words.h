/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words of the tables, as someone asks for them. */

#ifndef TP_TERMS_WORDS_H
#define TP_TERMS_WORDS_H

#include "topple.h"

enum { TP_WORD_SIZE = 128, TP_NEAREST_WORDS = 3 };

/* A word in small letters, without blanks, hyphens, underscores and brackets; cut where it is too
 * long. Two words with the same form are one. */
void tp_word_form(char form[TP_WORD_SIZE], const char *word, size_t length);

/* Is the form one of a list, whose words are separated by commas or semicolons? */
bool tp_word_is_in(const char *form, const char *list);

/* Is the form the path, or what is left of it after some full stop? */
bool tp_word_ends_path(const char *form, const char *path);

/* Is the last step of the path one of the keys, which are separated by blanks? */
bool tp_path_is_of_keys(const char *path, const char *keys);

/* The nearest words of all tables, nearest first; how many there are. */
size_t tp_nearest_words(char nearest[TP_NEAREST_WORDS][TP_WORD_SIZE], const char *form);

#endif
