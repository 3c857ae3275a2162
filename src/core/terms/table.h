/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What words mean: terms of rock mechanics (terms.csv), keys of the files that are read (keys.csv)
 * and keys of results (docs/schema), as make.py puts them into the library when it is built. Texts
 * are plain; one that there is not is empty. */

#ifndef TP_TERMS_TABLE_H
#define TP_TERMS_TABLE_H

#include <stddef.h>

typedef struct tp_term {
  const char *name, *symbol;
  const char *synonyms; /* separated by semicolons */
  const char *unit, *formula, *source;
  const char *keys; /* separated by blanks */
  const char *meaning;
} tp_term;

/* A key of a scene, a study or a file of claims; `path` from the top, [] an item of a list. */
typedef struct tp_file_key {
  const char *file, *path, *unit, *unless_given, *meaning, *page;
} tp_file_key;

/* A key of JSON that a command prints; `path` likewise, … for any number with its error. */
typedef struct tp_result_key {
  const char *command, *path, *unit, *meaning;
} tp_result_key;

extern const tp_term tp_terms[];
extern const size_t tp_term_count;
extern const tp_file_key tp_file_keys[];
extern const size_t tp_file_key_count;
extern const tp_result_key tp_result_keys[];
extern const size_t tp_result_key_count;

#endif
