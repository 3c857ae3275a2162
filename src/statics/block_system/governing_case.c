/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cases compared by their bounds, and motions of blocks gathered. */

#include "block_system/governing_case.h"

static double high(tp_bounded number) {
  return number.value + number.error;
}

static double low(tp_bounded number) {
  return number.value - number.error;
}

tp_system_factor tp_system_case_factor(const tp_system_case *c) {
  const tp_system_factor strength = {c->fos, c->fos_is_least, TP_FOS_BY_REDUCTION};
  const tp_system_factor driving = {c->fos_driving, c->fos_driving_is_least, TP_FOS_BY_DRIVING};
  if (c->fos_driving.state == TP_FOS_UNDECIDED) return driving;
  if (c->fos_driving.state != TP_FOS_NUMBER || driving.is_least) return strength;
  if (c->fos.state == TP_FOS_UNDEFINED) return driving; /* it passes 1 without a leap */
  if (c->fos.state != TP_FOS_NUMBER) return strength;
  return high(driving.fos.value) < low(strength.fos.value) ? driving : strength;
}

bool tp_system_case_is_worse(const tp_system_case *one, const tp_system_case *other) {
  const bool falls = one->verdict == TP_SYSTEM_COLLAPSES;
  if (falls != (other->verdict == TP_SYSTEM_COLLAPSES)) return falls;
  const tp_fos own = tp_system_case_factor(one).fos, its = tp_system_case_factor(other).fos;
  const bool told = own.state == TP_FOS_NUMBER, also = its.state == TP_FOS_NUMBER;
  const bool never = own.state == TP_FOS_UNDEFINED, nor = its.state == TP_FOS_UNDEFINED;
  if (never != nor) return never;
  if (told != also) return told;
  if (told && high(own.value) < low(its.value)) return true;
  if (told && low(own.value) > high(its.value)) return false;
  return one->limit == TP_SYSTEM_LIMIT_NUMBER && other->limit == TP_SYSTEM_LIMIT_NUMBER &&
         high(one->critical_angle_deg) - low(one->tilt_angle_deg) <
             low(other->critical_angle_deg) - high(other->tilt_angle_deg);
}

bool tp_system_case_is_held_farther(const tp_system_case *c) {
  return c->verdict == TP_SYSTEM_COLLAPSES && c->limit == TP_SYSTEM_LIMIT_NUMBER &&
         low(c->critical_angle_deg) > high(c->tilt_angle_deg);
}

const tp_system_case *tp_system_governing(const tp_block_system *system) {
  const tp_system_case *least = system->cases;
  for (size_t k = 1; k < system->case_count; k++) {
    if (tp_system_case_is_worse(system->cases + k, least)) least = system->cases + k;
  }
  return least;
}

tp_mechanism tp_system_case_mechanism(const tp_system_case *c) {
  bool slides = false, topples = false;
  for (size_t k = 0; k < c->motion_count; k++) {
    const tp_mechanism own = c->motions[k].mechanism;
    slides = slides || own == TP_SLIDES || own == TP_SLIDES_AND_TOPPLES;
    topples = topples || own == TP_TOPPLES || own == TP_SLIDES_AND_TOPPLES;
  }
  return slides && topples ? TP_SLIDES_AND_TOPPLES
         : slides          ? TP_SLIDES
         : topples         ? TP_TOPPLES
                           : TP_STANDS;
}

bool tp_system_case_is_unexamined(const tp_system_case *own) {
  return own->sought == TP_SYSTEM_SOUGHT_TOO_MANY && own->verdict != TP_SYSTEM_STANDS;
}

bool tp_system_case_moves_sooner(const tp_system_case *own) {
  const bool is_known = own->fos.state == TP_FOS_NUMBER && !own->fos_is_least;
  return own->has_moving_fos &&
         (!is_known || own->moving_fos < own->fos.value.value - own->fos.value.error);
}
