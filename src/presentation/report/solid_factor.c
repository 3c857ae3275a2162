/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of a solid in words. */

#include "report/solid_page.h"
#include "report/words.h"

#include <math.h>

void tp_text_solid_factor(tp_text *t, const tp_solid_safety *own, int digits) {
  char n[TP_NUMBER_SIZE];
  if (own->fos.state == TP_FOS_NUMBER) {
    tp_text_add(t, "%s", tp_text_significant_down(n, own->fos.value, digits));
    return;
  }
  if (tp_text_fos(own->fos) != NULL && own->fos.state != TP_FOS_UNDECIDED) {
    tp_text_add(t, "%s", tp_text_fos(own->fos));
    return;
  }
  tp_text_add(t, "undecided");
  if (own->least > 0 && own->least < HUGE_VAL) {
    const tp_bounded least = {.value = own->least};
    tp_text_add(t, ", at least %s", tp_text_significant_down(n, least, digits));
  }
  if (own->most < HUGE_VAL) {
    const tp_bounded most = {.value = own->most};
    tp_text_add(t, ", at most %s", tp_text_significant_up(n, most, digits));
  }
}
