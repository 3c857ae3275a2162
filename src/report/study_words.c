/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/study_words.h"

const char *tp_study_quantity_words(tp_study_quantity quantity) {
  static const char *const words[TP_STUDY_QUANTITIES] = {
      "critical angle °", "certain to stand to °", "static limit °", "factor of safety"};
  return words[quantity];
}

const char *tp_study_end_name(tp_study_end end) {
  static const char *const names[] = {"complete", "certain", "interrupted", "shard"};
  return names[end];
}
