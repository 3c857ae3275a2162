/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "compare_bits.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

typedef struct comparison {
  char *why;
  int power;
} comparison;

static void need(const comparison *c, bool holds, const char *what) {
  if (!holds && c->why[0] == '\0') snprintf(c->why, 256, "%s", what);
}

/* Of a length to the power of `degree`. */
static void need_scaled(const comparison *c, tp_bounded one, tp_bounded other, int degree,
                        const char *what) {
  need(c, other.value == ldexp(one.value, degree * c->power), what);
  const bool underflows = one.error <= DBL_MIN || other.error <= DBL_MIN;
  need(c, underflows || other.error == ldexp(one.error, degree * c->power), what);
}

static void need_fos(const comparison *c, tp_fos one, tp_fos other, const char *what) {
  need(c, one.state == other.state, what);
  if (one.state == TP_FOS_NUMBER) need_scaled(c, one.value, other.value, 0, what);
}

static void compare_limits(const comparison *c, const tp_limit *one, const tp_limit *other) {
  need(c, one->kind == other->kind, "kind of limit");
  if (one->kind != TP_LIMIT_AT_ANGLE || one->kind != other->kind) return;
  need(c, one->mechanism == other->mechanism && one->tie == other->tie, "mechanism of the limit");
  need_scaled(c, one->critical_angle_deg, other->critical_angle_deg, 0, "limit");
  need_fos(c, one->fos, other->fos, "factor of the limit");
  if (!one->has_centre || !other->has_centre) return;
  need_scaled(c, one->centre_x_m, other->centre_x_m, 1, "centre of the limit");
  need_scaled(c, one->centre_y_m, other->centre_y_m, 1, "centre of the limit");
}

static void compare_cases(const comparison *c, const tp_case *one, const tp_case *other) {
  need(c, one->pivot_count == other->pivot_count, "pivots");
  for (size_t k = 0; k < one->pivot_count && c->why[0] == '\0'; k++) {
    const tp_pivot *p = one->pivots + k, *q = other->pivots + k;
    need(c, p->kind == q->kind && p->admissible == q->admissible, "kind of pivot");
    need_scaled(c, p->x_m, q->x_m, 1, "pivot");
    need_scaled(c, p->y_m, q->y_m, 1, "pivot");
    need_scaled(c, p->critical_angle_deg, q->critical_angle_deg, 0, "critical angle");
    need_fos(c, p->fos, q->fos, "factor of a pivot");
    need_fos(c, p->fos_elements, q->fos_elements, "factor of a pivot by elements");
  }
  need(c,
       one->has_toppling_pivot == other->has_toppling_pivot &&
           one->toppling_pivot == other->toppling_pivot && one->toppling_tie == other->toppling_tie,
       "governing pivot");
  need(c, one->mechanism == other->mechanism && one->first == other->first, "mechanism");
  need_scaled(c, one->first_angle_deg, other->first_angle_deg, 0, "first angle");
  compare_limits(c, &one->limit, &other->limit);
  if (one->has_margin) need_scaled(c, one->margin_deg, other->margin_deg, 0, "margin");
  if (one->has_margin_to_first) {
    need_scaled(c, one->margin_to_first_deg, other->margin_to_first_deg, 0, "margin to the first");
  }
}

bool solutions_same_bits(char why[256], const tp_solution *one, const tp_solution *other,
                         int power) {
  const comparison c = {why, power};
  const tp_block_result *a = &one->block, *b = &other->block;
  why[0] = '\0';
  need(&c, one->level == other->level && one->bits == other->bits, "level");
  need_scaled(&c, a->area_m2, b->area_m2, 2, "area");
  need_scaled(&c, a->weight_n, b->weight_n, 2, "weight");
  need_scaled(&c, a->centroid_x_m, b->centroid_x_m, 1, "centroid");
  need_scaled(&c, a->centroid_y_m, b->centroid_y_m, 1, "centroid");
  need_scaled(&c, a->second_moment_xx_m4, b->second_moment_xx_m4, 4, "second moment");
  need_scaled(&c, a->second_moment_yy_m4, b->second_moment_yy_m4, 4, "second moment");
  need_scaled(&c, a->second_moment_xy_m4, b->second_moment_xy_m4, 4, "second moment");
  need_scaled(&c, one->contact.length_m, other->contact.length_m, 1, "length of contact");
  need(&c, one->case_count == other->case_count, "cases");
  for (size_t k = 0; k < one->case_count && why[0] == '\0'; k++) {
    compare_cases(&c, one->cases + k, other->cases + k);
  }
  return why[0] == '\0';
}
