/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The encoders of text from outside: the first byte says for which language, the rest is the text.
 * What must hold is read back here without what the encoders are made of. */

#include "common/outside.h"
#include "fuzz.h"
#include "output/encode.h"

#include <stdlib.h>
#include <string.h>

/* UTF-8 on one line: each first byte with as many others as it announces, and no character that
 * acts on a terminal, by the bytes that they begin with. */
static void check_plain(const char *text) {
  static const char *const acting[] = {"\u061c", "\u200b", "\u200e", "\u200f", "\u2028", "\u2029",
                                       "\u202a", "\u202e", "\u2060", "\u2066", "\u2069", "\ufeff",
                                       "\ufffe", "\uffff", "\u00ad", NULL};
  for (int k = 0; acting[k] != NULL; k++) FUZZ_EXPECT(strstr(text, acting[k]) == NULL);
  while (*text != '\0') {
    const unsigned char first = (unsigned char)*text++;
    FUZZ_EXPECT(first >= ' ' && first != 0x7f && (first < 0x80 || (first > 0xc1 && first < 0xf5)));
    const int more = first < 0x80 ? 0 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
    FUZZ_EXPECT(first != 0xc2 || (unsigned char)*text >= 0xa0);
    FUZZ_EXPECT(first != 0xed || (unsigned char)*text < 0xa0);
    for (int k = 0; k < more; k++) FUZZ_EXPECT(((unsigned char)*text++ & 0xc0) == 0x80);
  }
}

/* Made plain it is itself, in as little room as it takes and in less. */
static void check_bounds(const char *outside) {
  char whole[4096], again[4096], part[40];
  tp_plain_text(whole, sizeof whole, outside);
  check_plain(whole);
  tp_plain_text(again, sizeof again, whole);
  FUZZ_EXPECT(strcmp(whole, again) == 0);
  for (size_t size = 4; size <= sizeof part; size++) {
    tp_plain_text(part, size, outside);
    FUZZ_EXPECT(strlen(part) < size);
    check_plain(part);
    check_plain(tp_quote_of(outside, size).text);
  }
}

static void check_c_comment(const char *text) {
  static const char *const never[] = {"*/", "/*", "??", NULL};
  check_plain(text);
  for (int k = 0; never[k] != NULL; k++) FUZZ_EXPECT(strstr(text, never[k]) == NULL);
  const size_t length = strlen(text);
  FUZZ_EXPECT(length == 0 || strchr("*/\\", text[length - 1]) == NULL);
}

static void check_json(const char *text) {
  const size_t length = strlen(text);
  FUZZ_EXPECT(length >= 2 && text[0] == '"' && text[length - 1] == '"');
  for (const char *c = text + 1; c < text + length - 1; c++) {
    FUZZ_EXPECT((unsigned char)*c >= ' ' && *c != '"');
    if (*c != '\\') continue;
    c++;
    FUZZ_EXPECT(c < text + length - 1 && strchr("\"\\u", *c) != NULL);
    if (*c == 'u') FUZZ_EXPECT(strspn(c + 1, "0123456789abcdef") >= 4);
  }
}

static void check_markdown(const char *text) {
  check_plain(text);
  for (const char *c = text; *c != '\0'; c++) {
    FUZZ_EXPECT(strchr("<>|`*_[]{}#~$@", *c) == NULL || (*c == '#' && c > text && c[-1] == '&'));
    FUZZ_EXPECT(strncmp(c, "://", 3) != 0 && strncmp(c, "www.", 4) != 0);
    if (*c == '\\') FUZZ_EXPECT(*++c != '\0');
  }
}

static void check_markdown_code(const char *text) {
  check_plain(text);
  const size_t length = strlen(text), mark = text[0] == '`' ? 1 : strlen("<code>");
  FUZZ_EXPECT(length >= 2 * mark);
  const char *const never = mark == 1 ? "`|" : "`|<*_[]\\";
  for (const char *c = text + mark; c < text + length - mark - (mark > 1); c++) {
    FUZZ_EXPECT(strchr(never, *c) == NULL);
  }
}

/* A field alone on its line: one that is quoted ends at its end, one that is not has no mark. */
static void check_csv(const char *text) {
  check_plain(text);
  const size_t length = strlen(text);
  if (text[0] != '"') {
    FUZZ_EXPECT(strpbrk(text, ",;\"") == NULL);
    FUZZ_EXPECT(length == 0 || strchr("=@", text[0]) == NULL);
    char *end = NULL;
    (void)strtod(text, &end);
    FUZZ_EXPECT(length == 0 || strchr("+-", text[0]) == NULL || *end == '\0');
    return;
  }
  FUZZ_EXPECT(length >= 2 && text[length - 1] == '"' && strchr("=@", text[1]) == NULL);
  for (const char *c = text + 1; c < text + length - 1; c++) {
    if (*c != '"') continue;
    FUZZ_EXPECT(*++c == '"' && c < text + length - 1);
  }
}

static void check_gnuplot(const char *text) {
  check_plain(text);
  const size_t length = strlen(text);
  FUZZ_EXPECT(length >= 2 && text[0] == '\'' && text[length - 1] == '\'');
  FUZZ_EXPECT(length == 2 || text[1] != '\'');
  FUZZ_EXPECT(strstr(text, "]]>") == NULL);
  for (const char *c = text + 1; c < text + length - 1; c++) {
    if (*c != '\'') continue;
    FUZZ_EXPECT(*++c == '\'' && c < text + length - 1);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const struct {
    void (*encode)(tp_text *text, const char *outside);
    void (*check)(const char *text);
  } languages[] = {{tp_encode_plain, check_plain},
                   {tp_encode_json, check_json},
                   {tp_encode_c_comment, check_c_comment},
                   {tp_encode_latex_comment, check_plain},
                   {tp_encode_markdown, check_markdown},
                   {tp_encode_markdown_code, check_markdown_code},
                   {tp_encode_csv, check_csv},
                   {tp_encode_gnuplot, check_gnuplot}};
  enum { LANGUAGES = sizeof languages / sizeof languages[0] };
  if (size == 0) return -1;
  char *outside = fuzz_text(data + 1, size - 1), *encoded = NULL;
  const size_t language = data[0] % LANGUAGES;
  tp_text text = {0};
  tp_text_add(&text, "%s", "");
  languages[language].encode(&text, outside);
  FUZZ_EXPECT(tp_text_finish(&text, &encoded) == TP_OK);
  languages[language].check(encoded);
  check_bounds(outside);
  free(encoded);
  free(outside);
  return 0;
}
