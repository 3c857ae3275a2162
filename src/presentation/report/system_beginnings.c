/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The strong side of many blocks in words: numbers rounded to the side on which they are proven. */

#include "block_system/state_limits.h"
#include "report/system_page.h"
#include "report/system_words.h"

#include <math.h>

static double down(double number, double scale) {
  return floor(number * scale) / scale;
}

static double up(double number, double scale) {
  return ceil(number * scale) / scale;
}

static const double fifth = 1e5;

void tp_text_system_moving(tp_text *t, const tp_system_case *c) {
  tp_text_add(t, "%.5f%s", up(c->moving_fos, fifth),
              c->moving_fos_is_most ? ", and less: more friction does not help" : "");
}

/* As the blocks lie it is 1; `is_least`: the search ended there. */
static void add_standing(tp_text *t, double factor, bool is_least) {
  if (is_least) {
    tp_text_add(t, "up to %.0f, and more\n", factor);
  } else if (down(factor, fifth) > 1) {
    tp_text_add(t, "up to %.5f\n", down(factor, fifth));
  } else {
    tp_text_add(t, "1 alone; above that nothing is proven\n");
  }
}

static void add_factors(tp_text *t, const tp_system_case *c) {
  if (c->has_standing_fos) {
    tp_text_system_label(t, "certain to stand, strength divided by");
    add_standing(t, c->standing_fos, c->standing_fos_is_least);
  }
  if (tp_system_case_moves_sooner(c)) {
    tp_text_system_label(t, "motion can begin, strength divided by");
    tp_text_system_moving(t, c);
    tp_text_add(t, "\n");
  }
}

static void add_driving(tp_text *t, const tp_system_case *c) {
  if (c->has_standing_fos_driving) {
    tp_text_system_label(t, "certain to stand, driving loads times");
    add_standing(t, c->standing_fos_driving, c->standing_fos_driving >= TP_MOST_FACTOR);
  }
  const bool is_sooner =
      c->fos_driving.state != TP_FOS_NUMBER || c->fos_driving_is_least ||
      c->moving_fos_driving < c->fos_driving.value.value - c->fos_driving.value.error;
  if (c->has_moving_fos_driving && is_sooner) {
    tp_text_system_label(t, "motion can begin, driving loads times");
    tp_text_add(t, "%.5f\n", up(c->moving_fos_driving, fifth));
  }
}

/* Do forces hold no tilt beyond the scene's, in digits that are printed? */
static bool is_at_limit(const tp_system_case *c, double scale) {
  const tp_bounded *limit = &c->critical_angle_deg;
  return c->limit == TP_SYSTEM_LIMIT_NUMBER &&
         down(limit->value + limit->error, scale) <= c->tilt_angle_deg.value;
}

static void add_tilts(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  static const double fourth = 1e4;
  if (c->has_standing_angle) {
    tp_text_system_label(t, s->lies_in_place ? "certain to stand at dips"
                                             : "certain to stand at tilts");
    const double most = down(c->standing_angle_deg, fourth);
    if (most > c->tilt_angle_deg.value) {
      tp_text_add(t, "up to %.4f°\n", most);
    } else {
      tp_text_add(t, "of %.10g° alone%s\n", c->tilt_angle_deg.value,
                  is_at_limit(c, fourth) ? ": no forces hold more"
                                         : "; above that nothing is proven");
    }
  }
  const bool is_sooner =
      c->limit != TP_SYSTEM_LIMIT_NUMBER ||
      c->moving_angle_deg < c->critical_angle_deg.value - c->critical_angle_deg.error;
  if (c->has_moving_angle && is_sooner) {
    tp_text_system_label(t, s->lies_in_place ? "a motion can begin at a dip of"
                                             : "a motion can begin at a tilt of");
    tp_text_add(t, "%.4f°\n", up(c->moving_angle_deg, fourth));
  }
}

static void add_estimate(tp_text *t, double factor, const char *definition) {
  static const double hundred = 100;
  tp_text_system_label(t, "estimate, joints that do not dilate");
  tp_text_add(t, "%.2f, %s, not proven\n", down(factor, hundred), definition);
}

static void add_estimates(tp_text *t, const tp_system_case *c) {
  if (c->has_undilated_fos) add_estimate(t, c->undilated_fos, "strength reduction");
  if (c->has_undilated_fos_driving) add_estimate(t, c->undilated_fos_driving, "driving loads");
}

void tp_text_system_beginnings(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  add_factors(t, c);
  add_driving(t, c);
  add_tilts(t, s, c);
  add_estimates(t, c);
  if (!tp_system_case_is_unexamined(c) || c->verdict != TP_SYSTEM_CAN_HOLD) return;
  tp_text_add(t,
              "  Up to which factor no motion can begin was not examined: that is done for up to\n"
              "  %d free blocks.\n",
              TP_MOST_MOVING_BLOCKS);
}

void tp_text_system_start(tp_text *t, const tp_system_case *c) {
  if (c->verdict == TP_SYSTEM_MAY_MOVE || c->verdict == TP_SYSTEM_COLLAPSES) {
    tp_text_add(t, "\n  A motion that can begin as they lie:\n");
  } else {
    tp_text_add(t, "\n  A motion that can begin with strength divided by %.5f:\n",
                up(c->start.divisor, fifth));
  }
}
