/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of a solid in words. */

#include "report/solid_page.h"
#include "report/words.h"

#include <math.h>

void tp_text_solid_factor(tp_text *t, const tp_solid_safety *safety, int digits) {
  char n[TP_NUMBER_SIZE];
  if (safety->fos.state == TP_FOS_NUMBER) {
    tp_text_add(t, "%s", tp_text_significant_down(n, safety->fos.value, digits));
    return;
  }
  if (tp_text_fos(safety->fos) != NULL && safety->fos.state != TP_FOS_UNDECIDED) {
    tp_text_add(t, "%s", tp_text_fos(safety->fos));
    return;
  }
  tp_text_add(t, "undecided");
  if (safety->least > 0 && safety->least < HUGE_VAL) {
    const tp_bounded least = {.value = safety->least};
    tp_text_add(t, ", at least %s", tp_text_significant_down(n, least, digits));
  }
  if (safety->most < HUGE_VAL) {
    const tp_bounded most = {.value = safety->most};
    tp_text_add(t, ", at most %s", tp_text_significant_up(n, most, digits));
  }
}
