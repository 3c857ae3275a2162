/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Estimates of factors on the sheet of many blocks, for joints that do not dilate. They are in a
 * sentence and in no table of factors, as nothing is proven of them. */

#include "report/sheet_system.h"

#include <math.h>

/* Rounded down, as all factors are. */
static void add(tp_text *t, const tp_document *d, const char *format, double factor) {
  static const double hundred = 100;
  tp_text_add(t, " ");
  tp_text_add(t, tp_document_say(d, format), floor(factor * hundred) / hundred);
}

void tp_system_sheet_add_estimate(tp_text *t, const tp_system_sheet *s, const tp_system_case *c) {
  if (c->has_undilated_fos) {
    add(t, &s->document,
        "Estimate for joints that do not dilate, by strength reduction: %.2f. Nothing is proven "
        "of it.",
        c->undilated_fos);
  }
  if (c->has_undilated_fos_driving) {
    add(t, &s->document,
        "Estimate for joints that do not dilate, on driving loads: %.2f. Nothing is proven of it.",
        c->undilated_fos_driving);
  }
}
