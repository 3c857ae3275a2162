/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Comparison of words without case, blanks and hyphens, and the nearest words by Levenshtein's edit
 * distance. */

#include "terms/words.h"

#include "common/nearest.h"
#include "terms/table.h"

#include <stdio.h>
#include <string.h>

void tp_word_form(char form[TP_WORD_SIZE], const char *word, size_t length) {
  size_t used = 0;
  for (size_t k = 0; k < length && used + 1 < TP_WORD_SIZE; k++) {
    const char c = word[k];
    if (strchr(" \t_-[]'`", c) != NULL) continue;
    form[used++] = (char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  form[used] = '\0';
}

/* The next word of a list, and step past it; its length, 0 where none is left. */
static size_t next_word(const char **word, const char **list, const char *separators) {
  *word = *list + strspn(*list, separators);
  *word += strspn(*word, " ");
  const size_t length = strcspn(*word, separators);
  *list = *word + length;
  return length;
}

bool tp_word_is_in(const char *form, const char *list) {
  const char *word = NULL;
  char own[TP_WORD_SIZE];
  size_t length = 0;
  tp_word_form(own, list, strlen(list));
  if (strcmp(own, form) == 0) return true;
  while ((length = next_word(&word, &list, ",;")) > 0) {
    tp_word_form(own, word, length);
    if (strcmp(own, form) == 0) return true;
  }
  return false;
}

bool tp_word_ends_path(const char *form, const char *path) {
  char own[TP_WORD_SIZE];
  tp_word_form(own, path, strlen(path));
  const size_t whole = strlen(own), length = strlen(form);
  if (length == 0 || length > whole || strcmp(own + whole - length, form) != 0) return false;
  return length == whole || own[whole - length - 1] == '.';
}

static const char *last_step(const char *path) {
  const char *dot = strrchr(path, '.');
  return dot != NULL ? dot + 1 : path;
}

bool tp_path_is_of_keys(const char *path, const char *keys) {
  const char *key = NULL;
  size_t length = 0;
  char last[TP_WORD_SIZE], own[TP_WORD_SIZE];
  tp_word_form(last, last_step(path), strlen(last_step(path)));
  while ((length = next_word(&key, &keys, " ")) > 0) {
    tp_word_form(own, key, length);
    if (strcmp(own, last) == 0) return true;
  }
  return false;
}

/* ---- the nearest -------------------------------------------------------------------------------
 */

/* How far a word is from the one asked for; one that it is a part of is nearer than a misspelling.
 */
static size_t distance(const char *form, const char *word, size_t length) {
  char own[TP_WORD_SIZE];
  tp_word_form(own, word, length);
  const size_t away = tp_word_distance(form, own);
  if (strlen(form) > 2 && strncmp(own, form, strlen(form)) == 0) return away < 1 ? away : 1;
  return strlen(form) > 2 && strstr(own, form) != NULL && away > 2 ? 2 : away;
}

typedef struct search {
  const char *form;
  size_t count, away[TP_NEAREST_WORDS];
  char (*nearest)[TP_WORD_SIZE];
} search;

static void offer(search *own, const char *word, size_t length) {
  const size_t away = distance(own->form, word, length);
  if (length >= TP_WORD_SIZE || away >= tp_word_reach(own->form)) return;
  for (size_t k = 0; k < own->count; k++) {
    if (strncmp(own->nearest[k], word, length) == 0 && own->nearest[k][length] == '\0') return;
  }
  size_t at = 0;
  while (at < own->count && own->away[at] <= away) at++;
  if (at == TP_NEAREST_WORDS) return;
  if (own->count < TP_NEAREST_WORDS) own->count++;
  for (size_t k = own->count - 1; k > at; k--) {
    own->away[k] = own->away[k - 1];
    memcpy(own->nearest[k], own->nearest[k - 1], TP_WORD_SIZE);
  }
  own->away[at] = away;
  memcpy(own->nearest[at], word, length);
  own->nearest[at][length] = '\0';
}

static void offer_list(search *own, const char *list) {
  const char *word = NULL;
  size_t length = 0;
  while ((length = next_word(&word, &list, ",;")) > 0) offer(own, word, length);
}

size_t tp_nearest_words(char nearest[TP_NEAREST_WORDS][TP_WORD_SIZE], const char *form) {
  search own = {.form = form, .nearest = nearest};
  for (size_t k = 0; k < tp_term_count; k++) {
    offer_list(&own, tp_terms[k].name);
    offer_list(&own, tp_terms[k].synonyms);
  }
  for (size_t k = 0; k < tp_file_key_count; k++) {
    offer(&own, last_step(tp_file_keys[k].path), strlen(last_step(tp_file_keys[k].path)));
  }
  for (size_t k = 0; k < tp_result_key_count; k++) {
    offer(&own, last_step(tp_result_keys[k].path), strlen(last_step(tp_result_keys[k].path)));
  }
  return own.count;
}
