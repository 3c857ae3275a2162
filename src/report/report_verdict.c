/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/report_verdict.h"

#include "report/report_limit.h"

void tp_page_add_verdict(tp_page *p, const tp_case *c) {
  const tp_solution *s = p->solution;
  char n[3][TP_NUMBER_SIZE];
  tp_page_degrees(n[0], s->tilt_angle_deg);
  tp_text_add(&p->text, "\n  ");
  if (c->falls_backwards && c->limit_back.kind == TP_LIMIT_AT_ANGLE) {
    const tp_bounded from = {.value = 0 - c->limit_back.critical_angle_deg.value,
                             .error = c->limit_back.critical_angle_deg.error};
    tp_text_add(&p->text, "Lets go up-dip already %s%s%s: below %s° it %s.\n",
                s->has_tilt_angle ? "at " : "on level ground", s->has_tilt_angle ? n[0] : "",
                s->has_tilt_angle ? "°" : "", tp_text_fixed(n[1], from, 3),
                tp_text_mechanism(c->limit_back.mechanism));
    return;
  }
  if (c->limit.kind == TP_LIMIT_NOWHERE) {
    tp_text_add(&p->text, "Does not stand: no forces of the base hold it at any tilt%s.\n",
                s->contact.corner_points > 0
                    ? ";\n  its contacts of a corner on a corner count as no support"
                    : "");
    return;
  }
  if (c->limit.kind == TP_LIMIT_UNDECIDED) {
    tp_text_add(&p->text, "Undecided at the precision allowed.\n");
    return;
  }
  if (c->falls_backwards) {
    tp_text_add(&p->text,
                "Topples up-dip already %s%s%s:\n  its centroid lies past the up-dip "
                "end of the contact.\n",
                s->has_tilt_angle ? "at " : "on level ground", s->has_tilt_angle ? n[0] : "",
                s->has_tilt_angle ? "°" : "");
    return;
  }
  if (c->has_governing && c->pivots[c->governing].always) {
    tp_text_add(&p->text, "Its loads topple it at any tilt.\n");
    return;
  }
  if (c->slides_sooner && !c->has_first_angle) {
    tp_text_add(&p->text, "Its loads slide it at any tilt.\n");
    return;
  }
  if (c->first == TP_INTERLOCKED) {
    tp_text_add(&p->text, "Interlocked: it neither slides nor topples at any tilt up to 90°.\n");
    return;
  }
  if (c->first == TP_STANDS) {
    tp_text_add(&p->text, "Does not topple at any tilt up to 90°; without friction_angle_deg\n"
                          "  sliding is not judged.\n");
    return;
  }
  tp_text_fixed(n[1], c->first_angle_deg, 3);
  if (!c->has_margin && c->first_angle_deg.value < 0) {
    tp_text_add(&p->text, "Does not hold even on level ground: it\n  ");
    tp_page_add_first(p, c);
    tp_text_add(&p->text, " at %s°.\n", n[1]);
    return;
  }
  if (!c->has_margin || c->mechanism == TP_MECHANISM_UNDECIDED) {
    if (c->mechanism == TP_MECHANISM_UNDECIDED) {
      tp_text_add(&p->text, "Whether it stands %s%s%s is undecided. ",
                  s->has_tilt_angle ? "at " : "on level ground", s->has_tilt_angle ? n[0] : "",
                  s->has_tilt_angle ? "°" : "");
    }
    tp_text_add(&p->text, "As the table is tilted, it\n  ");
    tp_page_add_first(p, c);
    tp_text_add(&p->text, " at %s°.\n", n[1]);
    return;
  }
  tp_text_fixed(n[2], c->margin_deg, 3);
  if (c->mechanism == TP_STANDS) {
    tp_text_add(&p->text, "Stands at %s°%s. Tilted further, it\n  ", n[0],
                c->limit.kind == TP_LIMIT_NOT_ASKED ? " by its moments" : "");
    tp_page_add_first(p, c);
    tp_text_add(&p->text, " at %s°, a margin of %s°.\n", n[1], n[2]);
  } else {
    tp_text_add(&p->text, "Does not stand at %s°: it\n  ", n[0]);
    tp_page_add_first(p, c);
    tp_text_add(&p->text, " at %s°, a margin of %s°.\n", n[1], n[2]);
  }
}
