/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lengths, forces, stresses, coordinates and angles with certain digits in the units asked for, and
 * sentences on ties and centres. */

#include "report/page.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>
#include <string.h>

const char *tp_page_length(const tp_page *p, char out[TP_NUMBER_SIZE], tp_bounded metres,
                           int digits) {
  return tp_text_significant(out, tp_text_over(metres, p->solution->metres_per_unit), digits);
}

tp_bounded tp_page_in(tp_bounded number, tp_result_unit unit) {
  return unit.name != NULL ? tp_text_over(number, unit.si) : number;
}

static void add_quantity(tp_page *p, tp_bounded number, tp_result_unit asked, const char *unit) {
  char n[TP_NUMBER_SIZE];
  if (asked.name != NULL) {
    tp_text_add(&p->text, "%s %s", tp_text_significant(n, tp_page_in(number, asked), 5),
                asked.name);
    return;
  }
  const bool large = number.value >= 1e4;
  if (large) number = tp_text_over(number, 1e3);
  tp_text_add(&p->text, "%s %s%s", tp_text_significant(n, number, 5), large ? "k" : "", unit);
}

void tp_page_add_force(tp_page *p, tp_bounded newtons) {
  add_quantity(p, newtons, p->solution->result_units.force, "N");
}

void tp_page_add_stress(tp_page *p, tp_bounded pascals) {
  add_quantity(p, pascals, p->solution->result_units.stress, "Pa");
}

/* Drop the zeros behind the last decimal that is none. */
static const char *trim(char *number) {
  if (strchr(number, '.') == NULL || strchr(number, 'e') != NULL) return number;
  size_t left = strlen(number);
  while (number[left - 1] == '0') number[--left] = '\0';
  if (number[left - 1] == '.') number[left - 1] = '\0';
  return number;
}

const char *tp_page_coordinate(const tp_page *p, char out[TP_NUMBER_SIZE], tp_bounded metres) {
  enum { MOST_DECIMALS = 12 };
  const double size = sqrt(p->solution->block.area_m2.value) / p->solution->metres_per_unit;
  const double decimals = 6 - ceil(log10(size));
  if (!(decimals >= 0 && decimals <= MOST_DECIMALS)) return tp_page_length(p, out, metres, 6);
  tp_text_fixed(out, tp_text_over(metres, p->solution->metres_per_unit), (int)decimals);
  return trim(out);
}

const char *tp_page_degrees(char out[TP_NUMBER_SIZE], tp_bounded angle) {
  tp_text_fixed(out, angle, 3);
  return trim(out);
}

const char *tp_page_fos(char out[TP_NUMBER_SIZE], tp_fos fos) {
  switch (fos.state) {
  case TP_FOS_NUMBER:
    return tp_text_fos(fos) != NULL ? "none" : tp_text_fixed_down(out, fos.value, 3);
  case TP_FOS_NO_OVERTURNING:
    return "unbounded";
  case TP_FOS_UNDEFINED:
    return "none";
  case TP_FOS_UNDECIDED:
    return "undecided";
  case TP_FOS_NO_TILT:
  case TP_FOS_NOT_ASKED:
    break;
  }
  return "-";
}

void tp_page_add_tie(tp_page *p, long bits) {
  if (bits == 0) {
    tp_text_add(&p->text, ", exactly.\n");
  } else {
    tp_text_add(&p->text, ",\n  as far as %ld bits can distinguish.\n", bits);
  }
}

static bool overlap(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

void tp_page_add_centre(tp_page *p, const tp_case *c, tp_bounded x_m, tp_bounded y_m) {
  char n[2][TP_NUMBER_SIZE];
  tp_text_add(&p->text, " about ");
  for (size_t k = 0; k < c->pivot_count; k++) {
    const tp_pivot *pivot = c->pivots + k;
    if (!overlap(x_m, pivot->x_m) || !overlap(y_m, pivot->y_m)) continue;
    tp_text_add(&p->text, "pivot %zu, the %s at ", pivot->index + 1,
                tp_pivot_kind_name(pivot->kind));
    break;
  }
  tp_text_add(&p->text, "(%s, %s)", tp_page_coordinate(p, n[0], x_m),
              tp_page_coordinate(p, n[1], y_m));
}
