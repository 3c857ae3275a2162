/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words for direction, limit, factor and collapse of many blocks. */

#include "report/system_words.h"

#include "block_system/governing_case.h"
#include "block_system/state_limits.h"
#include "terms/names.h"

#include <math.h>

void tp_text_system_stance(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  char n[TP_NUMBER_SIZE];
  const bool away = c->tilt_angle_deg.value < 0;
  const tp_bounded angle = {fabs(c->tilt_angle_deg.value), c->tilt_angle_deg.error, NULL};
  tp_text_add(t, "Towards the %s", tp_direction_name(c->towards));
  if (angle.value != 0 || angle.error != 0) {
    tp_text_add(t, ", %s %s of %s°", away ? "against" : "at", s->lies_in_place ? "a dip" : "a tilt",
                tp_text_fixed(n, angle, 3));
  } else {
    tp_text_add(t, ", as it lies");
  }
}

const char *tp_text_system_limit_name(const tp_block_system *s) {
  return s->lies_in_place ? "greatest dip that forces can hold"
                          : "greatest tilt that forces can hold";
}

/* Where proofs leave more open than the fourth digit, both ends, rounded outwards. */
static bool add_bracket(tp_text *t, tp_bounded number, double scale, const char *unit) {
  static const double close = 1e-4;
  if (!(number.error > close * fabs(number.value) && number.error * scale >= 1)) return false;
  tp_text_add(t, "between %.12g%s and %.12g%s",
              floor((number.value - number.error) * scale) / scale, unit,
              ceil((number.value + number.error) * scale) / scale, unit);
  return true;
}

void tp_text_system_limit(tp_text *t, const tp_system_case *c) {
  static const double fourth = 1e4;
  char n[TP_NUMBER_SIZE];
  switch (c->limit) {
  case TP_SYSTEM_LIMIT_NUMBER:
    if (!add_bracket(t, c->critical_angle_deg, fourth, "°")) {
      tp_text_add(t, "%s°", tp_text_fixed(n, c->critical_angle_deg, 4));
    }
    if (tp_system_case_is_held_farther(c)) tp_text_add(t, ", but not as they lie");
    break;
  case TP_SYSTEM_INTERLOCKED:
    tp_text_add(t, "none below 90°: interlocked");
    break;
  case TP_SYSTEM_LIMIT_UNDECIDED:
    tp_text_add(t, "undecided");
    break;
  }
}

static void add_number(tp_text *t, tp_bounded number, bool is_least) {
  static const double whole = 100; /* from where on digits behind the point tell nothing */
  static const double fifth = 1e5;
  char n[TP_NUMBER_SIZE];
  if (!is_least && add_bracket(t, number, fifth, "")) return;
  tp_text_add(t, "%s%s", is_least ? "above " : "",
              tp_text_fixed_down(n, number, is_least && number.value >= whole ? 0 : 5));
}

/* An upper bound of the factor of safety. */
static void add_limit_of_forces(tp_text *t, tp_bounded number, bool is_least) {
  if (!is_least) tp_text_add(t, "up to ");
  add_number(t, number, is_least);
  if (!is_least) tp_text_add(t, " (upper bound)");
}

static double rounded_down(double number) {
  static const double fifth = 1e5;
  return floor(number * fifth) / fifth;
}

static void add_range(tp_text *t, double least, double most) {
  static const double fifth = 1e5;
  const double low = rounded_down(least), high = ceil(most * fifth) / fifth;
  if (isinf(most) && !(low > 0)) {
    tp_text_add(t, "undecided");
  } else if (isinf(most)) {
    tp_text_add(t, "undecided: at least %.5f", low);
  } else if (!(low > 0)) {
    tp_text_add(t, "undecided: at most %.5f", high);
  } else {
    tp_text_add(t, "undecided: at least %.5f, at most %.5f", low, high);
  }
}

/* Proven to be no less than the most that is looked for. */
static bool is_above(double least, double most) {
  return isinf(most) && least >= TP_MOST_FACTOR && isfinite(least);
}

static void add_factor(tp_text *t, tp_fos_state state, double least, double most) {
  if (is_above(least, most)) {
    tp_text_add(t, "above %.0f", TP_MOST_FACTOR);
  } else if (state == TP_FOS_NUMBER) {
    tp_text_add(t, "%.5f", rounded_down(least));
  } else if (state == TP_FOS_NO_OVERTURNING) {
    tp_text_add(t, "unbounded");
  } else if (state == TP_FOS_UNDEFINED) {
    tp_text_add(t, "none: a motion can begin at every smaller multiple too");
  } else {
    add_range(t, least, most);
  }
}

void tp_text_system_safety(tp_text *t, const tp_system_safety *s) {
  add_factor(t, s->fos.state, s->at_least, s->at_most);
}

void tp_text_system_against(tp_text *t, const tp_system_safety *s) {
  const bool is_bound =
      s->fos.state == TP_FOS_NUMBER || (s->fos.state == TP_FOS_UNDECIDED && isfinite(s->at_most));
  if (!s->has_definition || !is_bound) return;
  tp_text_add(t, ", %s", tp_fos_definition_name(s->definition));
  if (s->mechanism != TP_STANDS) tp_text_add(t, ", %s", tp_mechanism_name(s->mechanism));
  if (s->without_earthquake) tp_text_add(t, ", without the earthquake");
}

void tp_text_system_bounds(tp_text *t, const tp_system_bounds *b) {
  const tp_safety one = {.least = b->at_least, .most = b->at_most};
  if (b->counts) {
    add_factor(t, tp_safety_fos(&one).state, b->at_least, b->at_most);
  } else {
    tp_text_add(t, "does not count: it does not decide when a motion begins");
  }
}

bool tp_system_case_has_critical_acceleration(const tp_system_case *c) {
  return c->has_acceleration && !tp_system_case_moves_at_rest(c);
}

bool tp_system_case_shakes_sooner(const tp_system_case *c) {
  const tp_bounded *limit = &c->critical_acceleration_g;
  return tp_system_case_has_critical_acceleration(c) && c->has_moving_acceleration &&
         c->moving_acceleration_g < limit->value - limit->error;
}

void tp_text_system_factor(tp_text *t, const tp_system_case *c) {
  if (c->fos.state == TP_FOS_NUMBER) {
    add_limit_of_forces(t, c->fos.value, c->fos_is_least);
  } else if (c->fos.state == TP_FOS_UNDEFINED) {
    tp_text_add(t, "none: not held with 1000 times the strength");
  } else {
    tp_text_add(t, c->verdict == TP_SYSTEM_COLLAPSES ? "below 1, undecided how far" : "undecided");
  }
}

void tp_text_system_driving(tp_text *t, const tp_system_case *c) {
  switch (c->fos_driving.state) {
  case TP_FOS_NUMBER:
    add_limit_of_forces(t, c->fos_driving.value, c->fos_driving_is_least);
    if (!c->fos_driving_is_least) {
      tp_text_add(t, ", %s", tp_mechanism_name(c->fos_driving_mechanism));
    }
    break;
  case TP_FOS_NO_OVERTURNING:
    tp_text_add(t, "none: no load points along x");
    break;
  case TP_FOS_UNDEFINED:
    tp_text_add(t, "none: not held even without");
    break;
  default:
    tp_text_add(t, "undecided");
    break;
  }
}

double tp_text_system_force_kn(double newtons, const tp_system_case *c) {
  static const double share = 1e-6;
  double most = 0;
  for (size_t k = 0; k < c->force_count; k++) most = fmax(most, fabs(c->forces[k].normal_n_m));
  return fabs(newtons) < share * most ? 0 : newtons / 1e3;
}

const char *tp_text_system_collapse(const tp_block_system *s, const tp_system_case *c) {
  const bool reduced = c->fos.state == TP_FOS_NUMBER && !c->fos_is_least;
  return reduced            ? "with strength divided by the factor"
         : s->lies_in_place ? "at the greatest dip"
                            : "at the greatest tilt";
}

int tp_text_system_digits(const tp_block_system *s) {
  enum { NEAR = 5, MOST = 15 };
  double far = 0, low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (size_t k = 0; k < s->contact_count; k++) {
    const tp_system_contact *c = s->contacts + k;
    const double at[2][2] = {{c->from_x_m.value, c->from_y_m.value},
                             {c->to_x_m.value, c->to_y_m.value}};
    for (int e = 0; e < 4; e++) {
      const double own = at[e / 2][e % 2];
      far = fmax(far, fabs(own));
      low[e % 2] = fmin(low[e % 2], own);
      high[e % 2] = fmax(high[e % 2], own);
    }
  }
  const double extent = fmax(high[0] - low[0], high[1] - low[1]);
  return extent > 0 && far > extent ? (int)fmin(MOST, NEAR + floor(log10(far / extent))) : NEAR;
}
