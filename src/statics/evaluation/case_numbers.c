/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Angles and factors of one direction of tilt for columns of tables, each a number, always, never
 * or unknown. */

#include "evaluation/case_numbers.h"

tp_case_state tp_case_moments_deg(tp_bounded *value, const tp_case *own) {
  if (!own->has_toppling_pivot) return TP_CASE_UNKNOWN;
  const tp_pivot *pivot = own->pivots + own->toppling_pivot;
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

static tp_case_state number_of(tp_bounded *value, tp_fos fos) {
  if (fos.state == TP_FOS_NUMBER) *value = fos.value;
  return fos.state == TP_FOS_NUMBER           ? TP_CASE_NUMBER
         : fos.state == TP_FOS_NO_OVERTURNING ? TP_CASE_ALWAYS
         : fos.state == TP_FOS_UNDEFINED      ? TP_CASE_NEVER
                                              : TP_CASE_UNKNOWN;
}

/* The last by the definition: those that count stand behind those that do not. */
static tp_case_state by_definition(tp_bounded *value, const tp_case *own,
                                   tp_fos_definition definition) {
  const tp_governing_fos *g = &own->governing_fos;
  tp_case_state state = TP_CASE_UNKNOWN;
  for (size_t k = 0; k < g->factor_count; k++) {
    if (g->factors[k].definition == definition) state = number_of(value, g->factors[k].fos);
  }
  return state;
}

tp_case_state tp_case_fos_moments(tp_bounded *value, const tp_case *own) {
  return by_definition(value, own, TP_FOS_BY_MOMENTS);
}

tp_case_state tp_case_fos_sliding(tp_bounded *value, const tp_case *own) {
  return by_definition(value, own, TP_FOS_BY_SHEAR);
}

const tp_factor *tp_case_factor(const tp_case *own) {
  const tp_governing_fos *g = &own->governing_fos;
  return g->has_factor ? g->factors + g->factor : NULL;
}
