/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/page.h"

#include <string.h>

const char *tp_page_length(const tp_page *p, char out[TP_NUMBER_SIZE], tp_bounded metres,
                           int digits) {
  return tp_text_significant(out, tp_text_over(metres, p->solution->metres_per_unit), digits);
}

void tp_page_add_quantity(tp_page *p, tp_bounded number, const char *unit) {
  char n[TP_NUMBER_SIZE];
  const bool large = number.value >= 1e4;
  if (large) number = tp_text_over(number, 1e3);
  tp_text_add(&p->text, "%s %s%s", tp_text_significant(n, number, 5), large ? "k" : "", unit);
}

const char *tp_page_degrees(char out[TP_NUMBER_SIZE], tp_bounded angle) {
  tp_text_fixed(out, angle, 3);
  if (strchr(out, '.') == NULL) return out;
  size_t length_left = strlen(out);
  while (out[length_left - 1] == '0') out[--length_left] = '\0';
  if (out[length_left - 1] == '.') out[length_left - 1] = '\0';
  return out;
}

const char *tp_page_fos(char out[TP_NUMBER_SIZE], tp_fos fos) {
  switch (fos.state) {
  case TP_FOS_NUMBER:
    return tp_text_fixed(out, fos.value, 3);
  case TP_FOS_NO_OVERTURNING:
    return "unbounded";
  case TP_FOS_UNDEFINED:
    return "none";
  case TP_FOS_NO_TILT:
  case TP_FOS_NOT_ASKED:
    break;
  }
  return "-";
}

void tp_page_add_pivot(tp_page *p, const tp_case *c) {
  const tp_pivot *pivot = c->pivots + c->governing;
  char n[2][TP_NUMBER_SIZE];
  tp_text_add(&p->text, "the %s at (%s, %s)", tp_text_pivot_kind(pivot->kind),
              tp_page_length(p, n[0], pivot->x_m, 6), tp_page_length(p, n[1], pivot->y_m, 6));
}
