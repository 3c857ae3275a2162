/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least of several numbers that are each enclosed by two bounds is enclosed by the least of the
 * lower and the least of the upper bounds. All rules about unknown factors follow from this. */

#include "verdict/safety.h"

#include <math.h>

tp_factor_range tp_factor_range_of(tp_fos_definition definition, tp_mechanism mechanism,
                                   tp_fos fos) {
  tp_factor_range range = {definition, mechanism, 0, INFINITY};
  switch (fos.state) {
  case TP_FOS_NUMBER:
    range.least = fmax(0, nextafter(fos.value.value - fos.value.error, -INFINITY));
    range.most = fmax(0, nextafter(fos.value.value + fos.value.error, INFINITY));
    break;
  case TP_FOS_UNDEFINED:
    range.most = 0;
    break;
  case TP_FOS_NO_OVERTURNING:
    range.least = INFINITY;
    break;
  case TP_FOS_UNDECIDED:
  case TP_FOS_NO_TILT:
  case TP_FOS_NOT_ASKED:
    break;
  }
  return range;
}

/* Is the first range more severe: by its upper bound, and where that is the same by its lower? */
static bool is_less(double most, double least, double than_most, double than_least) {
  return most < than_most || (most == than_most && least < than_least);
}

tp_safety tp_safety_of(tp_motion_verdict verdict, const tp_factor_range *ranges, size_t count) {
  tp_safety s = {.verdict = verdict, .least = INFINITY, .most = INFINITY};
  if (count == 0 && verdict != TP_VERDICT_STANDS) s.least = 0;
  for (size_t k = 0; k < count; k++) {
    const tp_factor_range *r = ranges + k;
    const tp_factor_range *held = s.has_factor ? ranges + s.factor : NULL;
    if (held == NULL || is_less(r->most, r->least, held->most, held->least)) {
      s.has_factor = true;
      s.factor = k;
    }
    s.least = fmin(s.least, r->least);
    s.most = fmin(s.most, r->most);
  }
  if (verdict < TP_VERDICT_OPEN && s.least > 1) s.least = 0; /* of other states than this one */
  if (verdict < TP_VERDICT_OPEN) s.most = fmin(s.most, 1);
  if (verdict == TP_VERDICT_STANDS) s.least = fmax(s.least, fmin(1, s.most));
  s.least = fmin(s.least, s.most);
  return s;
}

tp_fos tp_safety_fos(const tp_safety *s) {
  if (s->most == 0) return (tp_fos){.state = TP_FOS_UNDEFINED};
  if (isinf(s->least)) return (tp_fos){.state = TP_FOS_NO_OVERTURNING};
  if (isinf(s->most) || s->most - s->least > TP_SAFETY_WIDTH * s->most) {
    return (tp_fos){.state = TP_FOS_UNDECIDED};
  }
  const double value = s->least + (s->most - s->least) / 2;
  const double error = nextafter(fmax(value - s->least, s->most - value), INFINITY);
  return (tp_fos){TP_FOS_NUMBER, {.value = value, .error = s->most == s->least ? 0 : error}};
}

tp_design tp_safety_meets(const tp_safety *s, double required) {
  if (isnan(required)) return TP_DESIGN_OPEN;
  if (s->verdict < TP_VERDICT_OPEN || s->most < required) return TP_DESIGN_NOT_MET;
  return s->verdict == TP_VERDICT_STANDS && s->least >= required ? TP_DESIGN_MET : TP_DESIGN_OPEN;
}

int tp_safety_compare(const tp_safety *a, const tp_safety *b) {
  if (a->verdict != b->verdict) return a->verdict < b->verdict ? -1 : 1;
  if (is_less(a->most, a->least, b->most, b->least)) return -1;
  return is_less(b->most, b->least, a->most, a->least) ? 1 : 0;
}

size_t tp_safety_governing(const tp_safety *states, size_t count) {
  size_t worst = 0;
  for (size_t k = 1; k < count; k++) {
    if (tp_safety_compare(states + k, states + worst) < 0) worst = k;
  }
  return worst;
}

tp_safety tp_safety_of_all(const tp_safety *states, size_t count) {
  tp_safety all = states[tp_safety_governing(states, count)];
  for (size_t k = 0; k < count; k++) {
    all.least = fmin(all.least, states[k].least);
    all.most = fmin(all.most, states[k].most);
  }
  return all;
}
