/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "compare.h"

#include <math.h>

/* Both ends of a facet, whose order a mirror changes. */
static void compare_facet(const comparison *c, const tp_bounded one[4], const tp_bounded other[4],
                          const char *what) {
  if (c->r->more_vertices) return; /* it may be a piece of the facet */
  compare_point(c, one, other + (c->r->mirrored ? 2 : 0), what);
  compare_point(c, one + 2, other + (c->r->mirrored ? 0 : 2), what);
}

/* The sum of the shares of both reactions, however they are divided between the points. */
static void compare_reactions(const comparison *c, const tp_limit *one, const tp_limit *other) {
  arb_t sums[2][2], expected, length;
  const tp_limit *limits[] = {one, other};
  arb_init(expected);
  arb_init(length);
  arb_set_fmpq(length, c->r->numbers + LENGTH, COMPARE_BITS);
  for (int i = 0; i < 2; i++) {
    arb_init(sums[i][0]);
    arb_init(sums[i][1]);
    for (size_t k = 0; k < limits[i]->reaction_count; k++) {
      compare_set_ball(expected, limits[i]->reactions[k].share_x);
      arb_add(sums[i][0], sums[i][0], expected, COMPARE_BITS);
      compare_set_ball(expected, limits[i]->reactions[k].share_y);
      arb_add(sums[i][1], sums[i][1], expected, COMPARE_BITS);
    }
  }
  for (int row = 0; row < 2; row++) {
    compare_map_row(expected, c->r, row, sums[0][0], sums[0][1]);
    arb_div(expected, expected, length, COMPARE_BITS);
    compare_need(c, arb_overlaps(expected, sums[1][row]) != 0, "sum of the reactions");
    arb_clear(sums[0][row]);
    arb_clear(sums[1][row]);
  }
  arb_clear(expected);
  arb_clear(length);
}

/* Turned on the table, an angle can leave what a limit is sought over. */
static bool limits_compare(const comparison *c, const tp_limit *one, const tp_limit *other) {
  enum { CLEAR_OF_UPRIGHT = 50 }; /* no turn is larger than 40 degrees */
  if (!c->r->turned) return true;
  const bool near =
      one->kind == TP_LIMIT_AT_ANGLE && fabs(one->critical_angle_deg.value) < CLEAR_OF_UPRIGHT;
  if (near) compare_need(c, other->kind == TP_LIMIT_AT_ANGLE, "the turned limit is an angle");
  return near;
}

static bool is_open(const tp_limit *limit) {
  return limit->kind == TP_LIMIT_UNDECIDED;
}

static void compare_limits(const comparison *c, const tp_limit *one, const tp_limit *other,
                           const char *what) {
  if (is_open(one) || is_open(other) || !limits_compare(c, one, other)) return;
  compare_need(c, one->kind == other->kind, what);
  if (one->kind != TP_LIMIT_AT_ANGLE || c->why[0] != '\0') return;
  compare_angle(c, one->critical_angle_deg, other->critical_angle_deg, what);
  compare_need(c, one->tie == other->tie, "tie of mechanisms");
  compare_need(
      c, one->mechanism == other->mechanism || (one->tie && one->mechanism == other->tied_with),
      "mechanism of the limit");
  compare_fos(c, one->fos, other->fos, "factor of safety of the limit");
  compare_number(c, one->friction_angle_deg, other->friction_angle_deg, 0, "friction at the limit");
  if (one->tie) return;
  if (!c->r->capacities) compare_reactions(c, one, other);
  compare_need(c, one->has_facet == other->has_facet && one->has_centre == other->has_centre,
               "facet or centre of the limit");
  if (one->has_facet) {
    compare_facet(
        c, (tp_bounded[]){one->facet_x0_m, one->facet_y0_m, one->facet_x1_m, one->facet_y1_m},
        (tp_bounded[]){other->facet_x0_m, other->facet_y0_m, other->facet_x1_m, other->facet_y1_m},
        "facet of the limit");
  }
  if (!one->has_centre) return;
  compare_need(c, one->turns_up_dip == other->turns_up_dip, "sense of turning");
  compare_point(c, (tp_bounded[]){one->centre_x_m, one->centre_y_m},
                (tp_bounded[]){other->centre_x_m, other->centre_y_m}, "centre of the limit");
}

static void compare_sliding(const comparison *c, const tp_case *one, const tp_case *other) {
  const tp_sliding *a = &one->sliding, *b = &other->sliding;
  compare_need(c, a->known == b->known && a->never == b->never, "sliding");
  if (a->known && !a->never) {
    compare_angle(c, a->critical_angle_deg, b->critical_angle_deg, "sliding angle");
    compare_angle(c, a->facet_angle_deg, b->facet_angle_deg, "facet angle");
    compare_facet(c, (tp_bounded[]){a->facet_x0_m, a->facet_y0_m, a->facet_x1_m, a->facet_y1_m},
                  (tp_bounded[]){b->facet_x0_m, b->facet_y0_m, b->facet_x1_m, b->facet_y1_m},
                  "facet that slides");
    compare_fos(c, a->fos, b->fos, "factor of sliding");
    compare_fos(c, a->fos_strength, b->fos_strength, "factor of sliding by strength");
  }
  if (one->toppling_tie) return; /* two toes */
  const tp_toe *s = &one->toe, *t = &other->toe;
  compare_need(c, s->known == t->known && s->holds == t->holds && s->upright == t->upright, "toe");
  if (s->known && !s->upright) {
    compare_angle(c, s->limit_angle_deg, t->limit_angle_deg, "limit angle of the toe");
  }
}

static void compare_verdicts(const comparison *c, const tp_case *one, const tp_case *other) {
  if (is_open(&one->limit) || is_open(&other->limit)) return;
  if (one->mechanism == TP_MECHANISM_UNDECIDED || other->mechanism == TP_MECHANISM_UNDECIDED)
    return;
  const bool open = is_open(&one->limit_otherwise) || is_open(&other->limit_otherwise);
  compare_need(c, open || one->base_matters == other->base_matters, "the base matters");
  compare_need(c,
               one->mechanism == other->mechanism ||
                   one->onset.has_motions != other->onset.has_motions || /* it goes by them */
                   (one->limit.tie && one->limit.mechanism == other->limit.tied_with),
               "mechanism");
  compare_need(c, one->falls_backwards == other->falls_backwards, "falls backwards");
  compare_need(c, one->has_margin_to_first == other->has_margin_to_first, "margin to the first");
  if (one->has_margin_to_first) {
    compare_number(c, one->margin_to_first_deg, other->margin_to_first_deg, 0,
                   "margin to the first");
  }
  if (one->onset.kind == TP_ONSET_UNDECIDED || other->onset.kind == TP_ONSET_UNDECIDED) return;
  compare_need(c, one->has_margin == other->has_margin, "margin");
  if (one->has_margin) compare_number(c, one->margin_deg, other->margin_deg, 0, "margin");
}

void compare_all_limits(const comparison *c, const tp_case *one, const tp_case *other) {
  compare_limits(c, &one->limit, &other->limit, "limit");
  if (c->r->turned) return;
  compare_limits(c, &one->limit_otherwise, &other->limit_otherwise, "limit otherwise");
  compare_limits(c, &one->limit_holds_from, &other->limit_holds_from, "limit of tilting back");
  compare_onsets(c, one, other);
  compare_sliding(c, one, other);
  compare_verdicts(c, one, other);
}
