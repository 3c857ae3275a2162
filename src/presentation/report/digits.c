/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The chief numbers of a solution to as many digits as were asked for, in SI units and degrees: a
 * number a line, never broken, so that it can be copied. */

#include "report/digits.h"
#include "report/words.h"
#include "terms/names.h"

static void add(tp_page *p, const char *name, const char *unit, tp_bounded number) {
  char n[TP_NUMBER_SIZE];
  const char *digits =
      number.digits != NULL ? number.digits : tp_text_significant(n, number, p->solution->digits);
  tp_text_add(&p->text, "  %-24s %s%s\n", name, digits, unit);
}

/* Rounded down, but where the digits are those of a longer number, all of them certain. */
static void add_fos(tp_page *p, const char *name, tp_fos fos) {
  char n[TP_NUMBER_SIZE];
  if (fos.state != TP_FOS_NUMBER || tp_text_fos(fos) != NULL) return;
  tp_text_significant_down(n, fos.value, p->solution->digits);
  tp_text_add(&p->text, "  %-24s %s\n", name, fos.value.digits != NULL ? fos.value.digits : n);
}

static void add_limit(tp_page *p, const tp_limit *limit) {
  if (limit->kind != TP_LIMIT_AT_ANGLE) return;
  add(p, "static limit", "°", limit->critical_angle_deg);
  if (limit->has_centre) {
    add(p, "  its centre, x", " m", limit->centre_x_m);
    add(p, "  its centre, y", " m", limit->centre_y_m);
  }
  add_fos(p, "  its factor of safety", limit->fos);
}

static void add_case(tp_page *p, const tp_case *c) {
  tp_text_add(&p->text, "  towards the %s:\n", tp_direction_name(c->towards));
  if (c->has_toppling_pivot) {
    const tp_pivot *pivot = c->pivots + c->toppling_pivot;
    if (!pivot->never && !pivot->always) add(p, "critical angle", "°", pivot->critical_angle_deg);
    add_fos(p, "factor of safety", pivot->fos);
    add_fos(p, "  by elements", pivot->fos_elements);
  }
  if (c->sliding.known && !c->sliding.never && !c->sliding.always) {
    add(p, "sliding", "°", c->sliding.critical_angle_deg);
    add_fos(p, "  its factor of safety", c->sliding.fos);
  }
  add_limit(p, &c->limit);
}

void tp_page_add_digits(tp_page *p) {
  enum { SHOWN = 9 };
  const tp_solution *s = p->solution;
  if (s->digits <= SHOWN) return;
  tp_text_add(&p->text, "\nTo %d digits\n", s->digits);
  add(p, "area", " m²", s->block.area_m2);
  add(p, "centroid, x", " m", s->block.centroid_x_m);
  add(p, "centroid, y", " m", s->block.centroid_y_m);
  if (s->block.has_weight) add(p, "weight", " N", s->block.weight_n);
  for (size_t k = 0; k < s->case_count; k++) add_case(p, s->cases + k);
}
