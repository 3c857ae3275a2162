/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The account of moments by elements, as Appendix A of the paper writes it. */

#include "common/host.h"
#include "report/account_units.h"
#include "report/words.h"
#include "terms/names.h"

#include <stdio.h>

static void add_account(tp_page *p, const tp_case *c) {
  const tp_solution *s = p->solution;
  const tp_account *a = &c->elements;
  const tp_account_units units = tp_account_units_of(s);
  char n[5][TP_NUMBER_SIZE], head[4][48];
  if (a->account_count == 0) return;
  tp_text_add(&p->text, "\nMoments by elements");
  tp_page_add_centre(p, c, c->pivots[c->toppling_pivot].x_m, c->pivots[c->toppling_pivot].y_m);
  tp_text_add(&p->text,
              !s->frame.world        ? ",\ntilted towards the %s by %s°%s\n"
              : a->at_critical_angle ? ",\nsteepened towards the %s to %s°%s\n"
                                     : ",\nas it lies, towards the %s, at %s°%s\n",
              tp_direction_name(c->towards), tp_page_degrees(n[0], a->angle_deg),
              a->at_critical_angle ? ", the critical angle" : "");
  snprintf(head[0], sizeof head[0], "weight (%s)", units.weight);
  snprintf(head[1], sizeof head[1], "x arm (%s)", s->length_unit);
  snprintf(head[2], sizeof head[2], "y arm (%s)", s->length_unit);
  snprintf(head[3], sizeof head[3], "(%s)", units.moment);
  tp_text_add(&p->text, "%5s  %-8s %11s %11s %11s %13s %13s\n", "", "", "", "", "", "stabilising",
              "overturning");
  tp_text_add(&p->text, "%5s  %-8s %11s %11s %11s %13s %13s\n", "#", "element", head[0], head[1],
              head[2], head[3], head[3]);
  for (size_t k = 0; k < a->account_count; k++) {
    const tp_element *e = a->account + k;
    tp_text_add(
        &p->text, "%5zu  %-8s %11s %11s %11s %13s %13s\n", k + 1, tp_element_kind_name(e->kind),
        tp_text_significant(n[0], tp_page_in(e->weight, units.force), 6),
        tp_page_length(p, n[1], e->normal_arm_m, 6), tp_page_length(p, n[2], e->parallel_arm_m, 6),
        tp_account_moment(p, n[3], e->stabilising, &units),
        tp_account_moment(p, n[4], e->overturning, &units));
  }
  tp_text_add(&p->text, "  sum  %-8s %11s %11s %11s %13s %13s\n", "", "", "", "",
              tp_account_moment(p, n[0], a->stabilising, &units),
              tp_account_moment(p, n[1], a->overturning, &units));
  const tp_pivot *pivot = c->pivots + c->toppling_pivot;
  if (pivot->fos_elements.state == TP_FOS_NUMBER) {
    tp_text_add(&p->text, "  FoS by elements %s, by the resultant %s\n",
                tp_page_fos(n[0], pivot->fos_elements), tp_page_fos(n[1], pivot->fos));
  }
}

tp_status tp_report_elements(char **text, const tp_solution *solution) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solution);
  tp_page p = {.solution = solution};
  tp_text_add(&p.text, "%s", "");
  for (size_t k = 0; k < solution->case_count; k++) add_account(&p, solution->cases + k);
  return tp_text_finish(&p.text, text);
}
