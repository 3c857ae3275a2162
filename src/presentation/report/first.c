/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mechanism and centre at the limit, or those of sliding and of the governing pivot where the limit
 * is unknown or later. */

#include "report/first.h"

void tp_page_add_limit_motion(tp_page *p, const tp_case *c, const tp_limit *l) {
  tp_text_add(&p->text, "%s", tp_mechanism_name(l->mechanism));
  if (!l->has_centre) return;
  if (l->turns_up_dip) tp_text_add(&p->text, " turning up-dip");
  tp_page_add_centre(p, c, l->centre_x_m, l->centre_y_m);
}

void tp_page_add_first(tp_page *p, const tp_case *c) {
  if (c->limit.kind == TP_LIMIT_AT_ANGLE && !c->slides_sooner) {
    tp_page_add_limit_motion(p, c, &c->limit);
    return;
  }
  tp_text_add(&p->text, "%s", tp_mechanism_name(c->first));
  if (c->first != TP_TOPPLES || !c->has_toppling_pivot) return;
  const tp_pivot *pivot = c->pivots + c->toppling_pivot;
  tp_page_add_centre(p, c, pivot->x_m, pivot->y_m);
}
