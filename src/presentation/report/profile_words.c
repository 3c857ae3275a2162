/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words for the origin of a profile and for the state of its series of heights. */

#include "report/profile_words.h"

const char *tp_text_profile_origin(tp_profile_origin origin) {
  switch (origin) {
  case TP_PROFILE_POINTS:
    return "points";
  case TP_PROFILE_FILE:
    return "file";
  case TP_PROFILE_BASE:
    return "base profile";
  case TP_PROFILE_MATED_BASE:
    return "mated base";
  }
  return "unknown";
}

const char *tp_text_profile_series(tp_profile_series series) {
  switch (series) {
  case TP_SERIES_GIVEN:
    return "given";
  case TP_SERIES_UNEVEN:
    return "uneven";
  case TP_SERIES_SHORT:
    return "short";
  }
  return "unknown";
}
