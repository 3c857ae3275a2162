/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of outcomes and quantities of a study in files and reports. */

#include "topple_study.h"

const char *tp_study_outcome_name(tp_study_outcome outcome) {
  static const char *const names[TP_STUDY_OUTCOMES] = {
      "stands",   "slides",    "topples", "slides and topples", "leaves its base", "interlocked",
      "may move", "undecided", "invalid"};
  return (size_t)outcome < TP_STUDY_OUTCOMES ? names[outcome] : "unknown";
}

const char *tp_study_quantity_name(tp_study_quantity quantity) {
  static const char *const names[TP_STUDY_QUANTITIES] = {"moments_deg", "onset_deg", "limit_deg",
                                                         "fos"};
  return (size_t)quantity < TP_STUDY_QUANTITIES ? names[quantity] : "unknown";
}
