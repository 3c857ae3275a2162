/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of a study's quantities and ends, and lines wrapped at 76 bytes. */

#include "report/study_words.h"

#include <string.h>

const char *tp_study_quantity_words(tp_study_quantity quantity) {
  static const char *const words[TP_STUDY_QUANTITIES] = {
      "critical angle °",      "certain to stand to °", "static limit °", "factor of safety",
      "FoS, Goodman and Bray", "acceleration g",        "support kN/m"};
  return words[quantity];
}

bool tp_study_quantity_is_angle(tp_study_quantity quantity) {
  return quantity <= TP_STUDY_LIMIT_DEG;
}

const char *tp_study_number(char out[TP_NUMBER_SIZE], double value, tp_study_quantity quantity) {
  const tp_bounded number = {value, 0, NULL};
  const int decimals = tp_study_quantity_is_angle(quantity) ? 2 : 3;
  const bool is_factor = quantity == TP_STUDY_FOS || quantity == TP_STUDY_FOS_GOODMAN_BRAY;
  return is_factor ? tp_text_fixed_down(out, number, decimals)
                   : tp_text_fixed(out, number, decimals);
}

void tp_study_add_lines(tp_text *t, const char *words) {
  enum { WIDTH = 76 };
  char plain[1024];
  tp_plain_text(plain, sizeof plain, words);
  size_t used = 0;
  for (const char *word = plain; *word != '\0';) {
    const size_t length = strcspn(word, " ");
    if (used > 0 && used + 1 + length > WIDTH) used = 0;
    tp_text_add(t, "%s%.*s", used > 0 ? " " : "\n  ", (int)length, word);
    used += length + (used > 0 ? 1 : 0);
    word += length;
    word += strspn(word, " ");
  }
}
