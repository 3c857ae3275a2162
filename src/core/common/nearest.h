/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How far two words are apart, for what a misspelt one may have meant. */

#ifndef TP_COMMON_NEAREST_H
#define TP_COMMON_NEAREST_H

#include <stddef.h>

/* Edit distance of Levenshtein, in bytes: how many are put in, left out or replaced. 63 where a
 * word is longer than that. */
size_t tp_word_distance(const char *one, const char *other);

/* From how far away on a word is no misspelling of this one. */
size_t tp_word_reach(const char *word);

#endif
