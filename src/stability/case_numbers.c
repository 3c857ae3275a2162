/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/case_numbers.h"

tp_case_state tp_case_moments_deg(tp_bounded *value, const tp_case *own) {
  if (!own->has_governing) return TP_CASE_UNKNOWN;
  const tp_pivot *pivot = own->pivots + own->governing;
  if (pivot->never) return TP_CASE_ALWAYS;
  if (pivot->always) return TP_CASE_NEVER;
  *value = pivot->critical_angle_deg;
  return TP_CASE_NUMBER;
}

tp_case_state tp_case_onset_deg(tp_bounded *value, const tp_case *own) {
  switch (own->onset.kind) {
  case TP_ONSET_AT_ANGLE:
    *value = own->onset.critical_angle_deg;
    return TP_CASE_NUMBER;
  case TP_ONSET_NEVER:
    return TP_CASE_ALWAYS;
  case TP_ONSET_NOWHERE:
    return TP_CASE_NEVER;
  default:
    return TP_CASE_UNKNOWN;
  }
}

tp_case_state tp_case_limit_deg(tp_bounded *value, const tp_case *own) {
  switch (own->limit.kind) {
  case TP_LIMIT_AT_ANGLE:
    *value = own->limit.critical_angle_deg;
    return TP_CASE_NUMBER;
  case TP_LIMIT_INTERLOCKED:
    return TP_CASE_ALWAYS;
  case TP_LIMIT_NOWHERE:
    return TP_CASE_NEVER;
  default:
    return TP_CASE_UNKNOWN;
  }
}

tp_case_state tp_case_fos(tp_bounded *value, const tp_case *own) {
  const tp_governing_fos *g = &own->governing_fos;
  switch (g->fos.state) {
  case TP_FOS_NUMBER:
    if (!g->complete && g->sliding_judged) return TP_CASE_UNKNOWN;
    *value = g->fos.value;
    return TP_CASE_NUMBER;
  case TP_FOS_NO_OVERTURNING:
    return TP_CASE_ALWAYS;
  case TP_FOS_UNDEFINED:
    return TP_CASE_NEVER;
  default:
    return TP_CASE_UNKNOWN;
  }
}

const tp_factor *tp_case_factor(const tp_case *own) {
  const tp_governing_fos *g = &own->governing_fos;
  return g->has_factor ? g->factors + g->factor : NULL;
}
