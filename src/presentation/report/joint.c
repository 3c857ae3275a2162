/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Shift, gaps and matching of a shifted block in words and as JSON (docs/rest.md). */

#include "report/joint.h"

/* "5 mm to the left". */
static void add_shift(tp_page *p, tp_bounded shift_m, int digits) {
  char n[TP_NUMBER_SIZE];
  const bool left = shift_m.value < 0;
  const tp_bounded size = {left ? -shift_m.value : shift_m.value, shift_m.error, NULL};
  tp_text_add(&p->text, "%s %s to the %s", tp_page_length(p, n, size, digits),
              p->solution->length_unit, left ? "left" : "right");
}

static void add_matching(tp_page *p, const tp_joint_result *r) {
  char n[2][TP_NUMBER_SIZE];
  tp_text_add(
      &p->text,
      ";\n         matching %s: the share of its underside\n         with a gap of %s %s at most",
      tp_text_significant(n[0], r->matching, 5), tp_page_length(p, n[1], r->closure_m, 5),
      p->solution->length_unit);
  if (!r->has_matching_sought) return;
  tp_text_add(&p->text, "; the least shift found\n         at which this is at most %s",
              tp_text_significant(n[0], r->matching_sought, 5));
  static const double visible = 1e-3;
  if (r->matching_before.value - r->matching.value < visible) return;
  tp_text_add(&p->text, "; it jumps\n         there from %s, at ",
              tp_text_significant(n[0], r->matching_before, 5));
  add_shift(p, r->shift_before_m, 8);
}

void tp_page_add_joint(tp_page *p) {
  const tp_joint_result *r = &p->solution->joint;
  const char *unit = p->solution->length_unit;
  char n[3][TP_NUMBER_SIZE];
  if (!r->known) return;
  tp_text_add(&p->text, "Joint    shifted by ");
  add_shift(p, r->shift_m, r->has_matching_sought ? 8 : 5);
  tp_text_add(&p->text,
              " along its mated base;\n         gaps of %s %s at most, %s %s in the mean\n         "
              "over the %s %s that lie above the base",
              tp_page_length(p, n[0], r->largest_gap_m, 5), unit,
              tp_page_length(p, n[1], r->mean_gap_m, 5), unit,
              tp_page_length(p, n[2], r->above_base_m, 5), unit);
  if (r->has_closure) add_matching(p, r);
  tp_text_add(&p->text, "\n");
}
