/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers of a solid as a row has them: infinite where nothing moves it, minus infinite where it
 * does not stand by itself. */

#include "study/solid_sample.h"

#include "study/outcome.h"

#include <math.h>

/* Without a tilt or an earthquake a row says what it does first as it is tilted. */
static bool has_load(const tp_solid *solid) {
  return solid->has_tilt_angle || solid->has_seismic;
}

static tp_mechanism verdict_of(const tp_solid *solid, const tp_solid_band *own) {
  if (!own->has_stance) return TP_TOPPLES;
  if (has_load(solid)) return own->stance.verdict;
  return own->stance.has_critical ? own->stance.critical_mechanism : TP_TOPPLES;
}

static double factor(const tp_solid_band *own, bool has, tp_bounded fos) {
  if (has) return fos.value;
  return own->has_stance && own->stance.verdict == TP_STANDS ? INFINITY : -INFINITY;
}

/* No number where it is undecided: infinite would say that nothing moves it. */
static double fos_of(const tp_solid *solid) {
  const tp_solid_safety *safety = tp_solid_safety_of(solid);
  if (!has_load(solid)) return (double)NAN;
  if (safety == NULL) return -INFINITY;
  switch (safety->fos.state) {
  case TP_FOS_NUMBER:
    return safety->fos.value.value;
  case TP_FOS_NO_OVERTURNING:
    return INFINITY;
  case TP_FOS_UNDEFINED:
    return -INFINITY;
  default:
    return (double)NAN;
  }
}

static void take_stance(tp_study_row *row, const tp_solid *solid, const tp_solid_band *own) {
  const tp_solid_stance *stance = &own->stance;
  row->quantities[TP_STUDY_LIMIT_DEG] =
      stance->has_critical ? stance->critical_deg.value : -INFINITY;
  row->quantities[TP_STUDY_FOS] = fos_of(solid);
  row->quantities[TP_STUDY_ACCELERATION_G] = stance->has_acceleration ? stance->acceleration_g.value
                                             : solid->has_tilt_angle && !solid->has_tilt_azimuth
                                                 ? (double)NAN
                                                 : -INFINITY;
  if (has_load(solid)) {
    row->fos_moments = factor(own, stance->has_fos_toppling, stance->fos_toppling);
    if (stance->has_fos_sliding) row->fos_sliding = stance->fos_sliding.value;
    if (stance->has_fos) {
      row->fos_mechanism = tp_study_outcome_name(tp_study_outcome_of(stance->fos_mechanism));
    }
  }
  if (stance->has_critical) {
    row->limit_mechanism = tp_study_outcome_name(tp_study_outcome_of(stance->critical_mechanism));
  }
  if (solid->has_tilt_angle) row->tilt_deg = solid->tilt_angle_deg;
}

/* On contacts factors of toppling and sliding are one. */
static void take_contacts(tp_study_row *row, size_t at, const tp_solid *solid) {
  const tp_solid_contacts *own = &solid->contacts;
  const double fos = fos_of(solid);
  row->at[at] = (tp_study_at){tp_study_outcome_of(own->verdict), fos};
  row->open = row->open || tp_solid_is_undecided(solid);
  if (at > 0) return;
  row->quantities[TP_STUDY_LIMIT_DEG] = own->has_critical    ? own->critical_deg.value
                                        : own->is_held_level ? INFINITY
                                                             : -INFINITY;
  row->quantities[TP_STUDY_FOS] = fos;
  row->quantities[TP_STUDY_ACCELERATION_G] =
      own->has_acceleration ? own->acceleration_g.value : (double)NAN;
  if (own->has_critical) {
    row->limit_mechanism = tp_study_outcome_name(tp_study_outcome_of(own->critical.mechanism));
  }
  if (solid->has_tilt_angle) row->tilt_deg = solid->tilt_angle_deg;
  if (solid->has_required_fos) row->design = (int)tp_solid_meets(solid, solid->required_fos);
}

static void take_wedge(tp_study_row *row, size_t at, const tp_solid *solid) {
  const tp_solid_wedge *own = &solid->wedge;
  const double fos = own->has_fos ? own->fos.value : INFINITY; /* nothing drives it */
  row->at[at] = (tp_study_at){tp_study_outcome_of(own->verdict), fos};
  row->open = row->open || tp_solid_is_undecided(solid);
  if (at > 0) return;
  row->quantities[TP_STUDY_LIMIT_DEG] = (double)NAN;
  row->quantities[TP_STUDY_ACCELERATION_G] =
      own->has_acceleration ? own->acceleration_g.value : (double)NAN;
  row->quantities[TP_STUDY_FOS] = fos;
  if (own->has_fos) {
    row->fos_sliding = fos;
    row->fos_mechanism = tp_study_outcome_name(tp_study_outcome_of(TP_SLIDES));
  }
  if (solid->has_required_fos) row->design = (int)tp_solid_meets(solid, solid->required_fos);
}

void tp_study_take_solid(tp_study_row *row, size_t at, const tp_solid *solid) {
  if (solid->has_contacts) {
    take_contacts(row, at, solid);
    return;
  }
  if (solid->has_wedge) {
    take_wedge(row, at, solid);
    return;
  }
  const tp_solid_band *own = solid->bands + solid->governing;
  row->at[at] = (tp_study_at){tp_study_outcome_of(verdict_of(solid, own)), fos_of(solid)};
  row->open = row->open || tp_solid_is_undecided(solid);
  if (at > 0) return;
  take_stance(row, solid, own);
  if (solid->has_required_fos) row->design = (int)tp_solid_meets(solid, solid->required_fos);
}
