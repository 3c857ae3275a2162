/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers of a case of many blocks as a row has them: infinite where all is held, minus infinite
 * where nothing is enough. */

#include "study/system_sample.h"

#include "block_system/governing_case.h"
#include "study/outcome.h"

#include <math.h>

static double limit_deg(const tp_system_case *own) {
  switch (own->limit) {
  case TP_SYSTEM_LIMIT_NUMBER:
    return own->critical_angle_deg.value;
  case TP_SYSTEM_INTERLOCKED:
    return INFINITY;
  default:
    return NAN;
  }
}

/* A factor that is only known to lie between bounds is the upper one, the least number at which a
 * motion is proven, and the sample is open; without that the number that is exceeded. Where no
 * strength is enough, or nothing holds even without what drives, it is below all. */
static double fos_of(const tp_system_safety *own) {
  switch (own->fos.state) {
  case TP_FOS_UNDEFINED:
    return -INFINITY;
  case TP_FOS_NO_OVERTURNING:
    return INFINITY;
  case TP_FOS_NUMBER:
    return own->fos.value.value;
  default:
    return isfinite(own->at_most) ? own->at_most : own->at_least > 1 ? own->at_least : (double)NAN;
  }
}

static double goodman_bray_fos(const tp_goodman_bray *own) {
  if (!own->applies) return NAN;
  return own->has_fos ? own->fos : -INFINITY;
}

static double acceleration_g(const tp_system_case *own) {
  if (tp_system_case_moves_at_rest(own)) return -INFINITY;
  if (own->has_acceleration) return own->critical_acceleration_g.value;
  return own->verdict == TP_SYSTEM_COLLAPSES ? -INFINITY : (double)NAN;
}

/* What to design for where a method tells it; else what forces can hold with. */
static double support_n_m(const tp_system_case *own) {
  if (!own->has_support) return NAN;
  if (own->support.has_goodman_bray) return own->support.goodman_bray_n_m;
  switch (own->support.state) {
  case TP_SYSTEM_SUPPORT_NUMBER:
    return own->support.force_n_m.value;
  case TP_SYSTEM_SUPPORT_NOT_NEEDED:
    return 0;
  case TP_SYSTEM_SUPPORT_NONE:
    return INFINITY;
  default:
    return NAN;
  }
}

static void take_case(tp_study_row *row, const tp_block_system *system) {
  const tp_system_case *own = tp_system_governing(system);
  const tp_mechanism collapse = tp_system_case_mechanism(own);
  row->quantities[TP_STUDY_LIMIT_DEG] = limit_deg(own);
  row->quantities[TP_STUDY_FOS] = fos_of(&system->governing_fos);
  row->quantities[TP_STUDY_FOS_GOODMAN_BRAY] = goodman_bray_fos(&own->goodman_bray);
  row->quantities[TP_STUDY_ACCELERATION_G] = acceleration_g(own);
  row->quantities[TP_STUDY_SUPPORT_N_M] = support_n_m(own);
  if (collapse != TP_STANDS) {
    row->limit_mechanism = tp_study_outcome_name(tp_study_outcome_of(collapse));
  }
  row->tilt_deg = own->tilt_angle_deg.value;
  if (!isnan(row->quantities[TP_STUDY_FOS]) && system->governing_fos.has_definition) {
    row->fos_definition = (int)system->governing_fos.definition;
  }
}

/* What forces can hold and no proof says more of is open, and so is what is required of it. */
static bool is_open(const tp_block_system *system) {
  const tp_system_case *own = tp_system_most_severe(system);
  const tp_system_verdict verdict = tp_system_case_worst_verdict(own);
  return verdict == TP_SYSTEM_UNDECIDED || verdict == TP_SYSTEM_CAN_HOLD ||
         own->limit == TP_SYSTEM_LIMIT_UNDECIDED ||
         system->governing_fos.fos.state == TP_FOS_UNDECIDED ||
         (own->has_support && own->support.state == TP_SYSTEM_SUPPORT_UNDECIDED);
}

void tp_study_take_system(tp_study_row *row, size_t at, const tp_block_system *system) {
  const tp_system_case *own = tp_system_most_severe(system);
  row->at[at] = (tp_study_at){tp_study_outcome_of_system(own), fos_of(&system->governing_fos)};
  row->open = row->open || is_open(system);
  if (at > 0) return;
  take_case(row, system);
  if (system->has_required_fos) {
    row->design = (int)tp_block_system_meets(system, system->required_fos.value);
    row->open = row->open || row->design == TP_DESIGN_OPEN;
  }
}
