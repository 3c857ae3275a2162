/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A table of mechanisms and outcomes. */

#include "study/outcome.h"

tp_study_outcome tp_study_outcome_of(tp_mechanism mechanism) {
  switch (mechanism) {
  case TP_STANDS:
    return TP_STUDY_STANDS;
  case TP_SLIDES:
    return TP_STUDY_SLIDES;
  case TP_TOPPLES:
    return TP_STUDY_TOPPLES;
  case TP_SLIDES_AND_TOPPLES:
    return TP_STUDY_SLIDES_AND_TOPPLES;
  case TP_LEAVES_BASE:
    return TP_STUDY_LEAVES_BASE;
  case TP_INTERLOCKED:
    return TP_STUDY_INTERLOCKED;
  case TP_MAY_MOVE:
    return TP_STUDY_MAY_MOVE;
  default:
    return TP_STUDY_UNDECIDED;
  }
}
