/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a word means, from the tables: terms first, then keys of files, then keys of results. A key
 * brings the terms behind it along. */

#include "common/host.h"
#include "common/outside.h"
#include "output/text.h"
#include "terms/table.h"
#include "terms/words.h"

#include <stdio.h>
#include <string.h>

enum { WIDTH = 78, INDENT = 4, LABEL = 10 };

static size_t width_of(const char *word, size_t length) {
  size_t width = 0;
  for (size_t k = 0; k < length; k++) width += ((unsigned char)word[k] & 0xC0) != 0x80;
  return width;
}

/* A text in lines from `indent` on, behind a label on the first one, which may be empty. */
static void add_lines(tp_text *text, const char *label, const char *words, size_t indent) {
  tp_text_add(text, "%*s%-*s", INDENT, "", (int)(indent - INDENT), label);
  size_t column = indent;
  while (*words != '\0') {
    const size_t length = strcspn(words, " "), width = width_of(words, length);
    if (column > indent && column + 1 + width > WIDTH) {
      tp_text_add(text, "\n%*s", (int)indent, "");
      column = indent;
    }
    if (column > indent) tp_text_append(text, " ", 1);
    tp_text_append(text, words, length);
    column += width + (column > indent ? 1 : 0);
    words += length;
    words += strspn(words, " ");
  }
  tp_text_append(text, "\n", 1);
}

static void add_labelled(tp_text *text, const char *label, const char *words) {
  if (*words != '\0') add_lines(text, label, words, INDENT + LABEL);
}

static void add_gap(tp_text *text) {
  if (text->length > 0) tp_text_append(text, "\n", 1);
}

static void add_term(tp_text *text, const tp_term *term) {
  add_gap(text);
  tp_text_add(text, "%s%s%s%s\n", term->name, *term->symbol != '\0' ? " (" : "", term->symbol,
              *term->symbol != '\0' ? ")" : "");
  add_lines(text, "", term->meaning, INDENT);
  add_labelled(text, "Formula", term->formula);
  add_labelled(text, "Unit", term->unit);
  add_labelled(text, "Source", term->source);
  add_labelled(text, "Also", term->synonyms);
  add_labelled(text, "Keys", term->keys);
}

static bool term_is(const tp_term *term, const char *form) {
  return tp_word_is_in(form, term->name) || tp_word_is_in(form, term->symbol) ||
         tp_word_is_in(form, term->synonyms);
}

/* Is a key that is asked for one that the term is behind? */
static bool term_is_behind(const tp_term *term, const char *form) {
  char last[TP_WORD_SIZE];
  const char *dot = strrchr(form, '.');
  snprintf(last, sizeof last, "%s", dot != NULL ? dot + 1 : form);
  return tp_path_is_of_keys(last, term->keys);
}

static void add_terms(tp_text *text, const char *form) {
  for (size_t k = 0; k < tp_term_count; k++) {
    if (term_is(tp_terms + k, form)) add_term(text, tp_terms + k);
  }
  for (size_t k = 0; k < tp_term_count; k++) {
    if (!term_is(tp_terms + k, form) && term_is_behind(tp_terms + k, form)) {
      add_term(text, tp_terms + k);
    }
  }
}

static void add_file_keys(tp_text *text, const char *form) {
  for (size_t k = 0; k < tp_file_key_count; k++) {
    const tp_file_key *key = tp_file_keys + k;
    if (!tp_word_ends_path(form, key->path)) continue;
    add_gap(text);
    tp_text_add(text, "%s, a key of %s\n", key->path,
                strcmp(key->file, "scene") == 0   ? "scenes"
                : strcmp(key->file, "study") == 0 ? "studies"
                                                  : "claims");
    add_lines(text, "", key->meaning, INDENT);
    add_labelled(text, "Unit", key->unit);
    add_labelled(text, strcmp(key->unless_given, "required") == 0 ? "" : "Default",
                 key->unless_given);
    char page[TP_WORD_SIZE];
    snprintf(page, sizeof page, "docs/%s", key->page);
    add_labelled(text, "More", page);
  }
}

/* Do two keys of results say the same of the same command? */
static bool are_alike(const tp_result_key *one, const tp_result_key *other) {
  return strcmp(one->command, other->command) == 0 && strcmp(one->meaning, other->meaning) == 0;
}

/* Of keys that say the same the first one tells the places of all. */
static bool is_told(size_t key, const char *form) {
  for (size_t k = 0; k < key; k++) {
    if (tp_word_ends_path(form, tp_result_keys[k].path) &&
        are_alike(tp_result_keys + k, tp_result_keys + key)) {
      return true;
    }
  }
  return false;
}

static void add_result_keys(tp_text *text, const char *form) {
  for (size_t k = 0; k < tp_result_key_count; k++) {
    const tp_result_key *key = tp_result_keys + k;
    if (!tp_word_ends_path(form, key->path) || is_told(k, form)) continue;
    add_gap(text);
    tp_text_add(text, "%s, a result of topple %s --json\n", key->path, key->command);
    for (size_t j = k + 1; j < tp_result_key_count; j++) {
      const tp_result_key *other = tp_result_keys + j;
      if (tp_word_ends_path(form, other->path) && are_alike(key, other)) {
        tp_text_add(text, "%s\n", other->path);
      }
    }
    add_lines(text, "", key->meaning, INDENT);
    add_labelled(text, "Unit", key->unit);
  }
}

/* What is not there, and what is nearest. */
static tp_status fail_unknown(const char *word, const char *form, tp_message *message) {
  char nearest[TP_NEAREST_WORDS][TP_WORD_SIZE];
  const size_t count = tp_nearest_words(nearest, form);
  char list[TP_NEAREST_WORDS * (TP_WORD_SIZE + 4)] = "";
  for (size_t k = 0; k < count; k++) {
    const size_t used = strlen(list);
    snprintf(list + used, sizeof list - used, "%s'%s'",
             k == 0           ? ""
             : k + 1 == count ? " and "
                              : ", ",
             nearest[k]);
  }
  return tp_fail(message, TP_NO_ANSWER, (tp_place){0}, "nothing is called '%s'; %s %s",
                 tp_quote_all(word).text, count > 0 ? "nearest:" : "all terms are listed by",
                 count > 0 ? list : "'topple explain'");
}

tp_status tp_report_explained(char **text, const char *word, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, word);
  char form[TP_WORD_SIZE];
  tp_text own = {0};
  tp_word_form(form, word, strlen(word));
  if (form[0] != '\0') {
    add_terms(&own, form);
    add_file_keys(&own, form);
    add_result_keys(&own, form);
  }
  if (own.length == 0 && !own.failed) return fail_unknown(word, form, message);
  const tp_status status = tp_text_finish(&own, text);
  return status == TP_OK ? TP_OK : tp_fail_memory(message, "the explanation");
}

tp_status tp_report_terms(char **text) {
  TP_GUARD_HOST;
  if (text == NULL) return TP_BAD_INPUT;
  tp_text own = {0};
  for (size_t k = 0; k < tp_term_count; k++) {
    tp_text_add(&own, "%s%s%s%s\n", tp_terms[k].name, *tp_terms[k].symbol != '\0' ? " (" : "",
                tp_terms[k].symbol, *tp_terms[k].symbol != '\0' ? ")" : "");
  }
  return tp_text_finish(&own, text);
}
