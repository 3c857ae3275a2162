/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of pivots with kind, coordinates, critical angle, factors and admissibility
 * (docs/mechanics.md section 3): the admissible ones and, of the others, as many as fit, nearest to
 * the toe; the same as JSON. */

#include "report/pivots.h"

#include "problem/bearing.h"
#include "report/loads.h"
#include "report/parts_json.h"
#include "report/words.h"
#include "terms/names.h"

#include <stdio.h>

static bool governs(const tp_case *c, size_t k) {
  return c->has_toppling_pivot && k == c->toppling_pivot;
}

const char *tp_text_turning(const tp_case *c, size_t k) {
  return governs(c, k) ? "governs" : c->pivots[k].admissible ? "free" : "blocked";
}

static void add_row(tp_page *p, const tp_case *c, size_t k) {
  const tp_pivot *pivot = c->pivots + k;
  char n[5][TP_NUMBER_SIZE];
  tp_text_add(&p->text, "%s%3zu %-8s %10s %10s ", governs(c, k) ? ">" : " ", pivot->index + 1,
              tp_pivot_kind_name(pivot->kind), tp_page_coordinate(p, n[0], pivot->x_m),
              tp_page_coordinate(p, n[1], pivot->y_m));
  if (pivot->never || pivot->always) {
    tp_text_add(&p->text, "%11s", pivot->never ? "never" : "always");
  } else {
    tp_text_add(&p->text, "%10s°", tp_text_fixed(n[2], pivot->critical_angle_deg, 3));
  }
  if (p->solution->has_tilt_angle) {
    tp_text_add(&p->text, " %9s %9s", tp_page_fos(n[3], pivot->fos),
                tp_page_fos(n[4], pivot->fos_elements));
  }
  tp_text_add(&p->text, "  %s\n", tp_text_turning(c, k));
}

bool tp_pivot_has_row(const tp_case *c, size_t k) {
  const size_t index = c->pivots[k].index;
  const size_t from_toe = c->towards == TP_TOWARDS_LEFT ? index : c->candidate_count - 1 - index;
  return c->pivots[k].admissible || from_toe < TP_PIVOTS_NEAR_TOE;
}

void tp_page_add_pivots(tp_page *p, const tp_case *c) {
  char x[16], y[16];
  snprintf(x, sizeof x, "x (%s)", p->solution->length_unit);
  snprintf(y, sizeof y, "y (%s)", p->solution->length_unit);
  tp_text_add(&p->text, "  %-11s %10s %10s %11s", "Pivot", x, y, tp_text_topples_at(p->solution));
  if (p->solution->has_tilt_angle) tp_text_add(&p->text, " %9s %9s", "FoS", "elements");
  tp_text_add(&p->text, "  turning\n");
  size_t left_out = c->candidate_count;
  for (size_t k = 0; k < c->pivot_count; k++) {
    if (!tp_pivot_has_row(c, k)) continue;
    add_row(p, c, k);
    left_out--;
  }
  if (left_out > 0) {
    tp_text_add(&p->text,
                "  … and %zu more, all of them blocked (--json --pivots=all lists them)\n",
                left_out);
  }
  if (!c->has_toppling_pivot) tp_text_add(&p->text, "  Turning is blocked about every pivot.\n");
  if (c->toppling_tie) {
    tp_text_add(&p->text, "  Tie: another free pivot has the same critical angle");
    tp_page_add_tie(p, c->toppling_tie_bits);
  }
}
