/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/pivots.h"

#include "output/json.h"
#include "report/loads.h"
#include "report/parts_json.h"
#include "report/words.h"

#include <math.h>
#include <stdio.h>

enum { ROWS_SHOWN = 16 };

static bool governs(const tp_case *c, size_t k) {
  return c->has_governing && k == c->governing;
}

const char *tp_text_turning(const tp_case *c, size_t k) {
  return governs(c, k) ? "governs" : c->pivots[k].admissible ? "free" : "blocked";
}

static void add_row(tp_page *p, const tp_case *c, size_t k) {
  const tp_pivot *pivot = c->pivots + k;
  char n[5][TP_NUMBER_SIZE];
  tp_text_add(&p->text, "%s%3zu %-8s %10s %10s ", governs(c, k) ? ">" : " ", k + 1,
              tp_text_pivot_kind(pivot->kind), tp_page_coordinate(p, n[0], pivot->x_m),
              tp_page_coordinate(p, n[1], pivot->y_m));
  if (pivot->never || pivot->always) {
    tp_text_add(&p->text, "%11s", pivot->never ? "never" : "always");
  } else {
    tp_text_add(&p->text, "%10s°", tp_text_fixed(n[2], pivot->critical_angle_deg, 3));
  }
  if (p->solution->has_tilt_angle) {
    tp_text_add(&p->text, " %9s %9s", tp_page_fos(n[3], pivot->fos_resultant),
                tp_page_fos(n[4], pivot->fos_elements));
  }
  tp_text_add(&p->text, "  %s\n", tp_text_turning(c, k));
}

/* The admissible ones, and of the others as many as fit, those nearest to the toe. */
void tp_page_add_pivots(tp_page *p, const tp_case *c) {
  char x[16], y[16];
  snprintf(x, sizeof x, "x (%s)", p->solution->length_unit);
  snprintf(y, sizeof y, "y (%s)", p->solution->length_unit);
  tp_text_add(&p->text, "  %-11s %10s %10s %11s", "Pivot", x, y, "topples at");
  if (p->solution->has_tilt_angle) tp_text_add(&p->text, " %9s %9s", "FoS", "elements");
  tp_text_add(&p->text, "  turning\n");
  size_t left_out = 0;
  for (size_t k = 0; k < c->pivot_count; k++) {
    const size_t from_toe = c->towards == TP_TOWARDS_LEFT ? k : c->pivot_count - 1 - k;
    if (c->pivots[k].admissible || from_toe < ROWS_SHOWN) {
      add_row(p, c, k);
    } else {
      left_out++;
    }
  }
  if (left_out > 0) {
    tp_text_add(&p->text,
                "  … and %zu more, all of them blocked (--json --pivots=all lists them)\n",
                left_out);
  }
  if (!c->has_governing) tp_text_add(&p->text, "  Turning is blocked about every pivot.\n");
  if (c->governing_tie) {
    tp_text_add(&p->text, "  Tie: another free pivot has the same critical angle");
    tp_page_add_tie(p, c->governing_tie_bits);
  }
}

/* A factor below zero is one of the governing pivot alone; elsewhere there is none. */
static void add_fos(tp_text *t, const char *key, tp_fos fos, bool admissible) {
  if (!admissible && tp_text_fos(fos) != NULL) {
    tp_text_add(t, "\"%s\": null, \"%s_is\": \"%s\"", key, key, tp_text_fos(fos));
  } else {
    tp_json_fos(t, key, fos);
  }
}

static void add_pivot(tp_text *t, const tp_pivot *p, size_t k, bool loaded) {
  tp_text_add(t, "        {\"index\": %zu, \"kind\": \"%s\", ", k, tp_text_pivot_kind(p->kind));
  tp_json_number(t, "x_m", p->x_m);
  tp_text_add(t, ", ");
  tp_json_number(t, "y_m", p->y_m);
  tp_text_add(t, ", ");
  tp_json_critical_angle(t, p);
  tp_text_add(t, ", ");
  add_fos(t, "fos", p->fos_resultant, p->admissible);
  tp_text_add(t, ", ");
  add_fos(t, "fos_elements", p->fos_elements, p->admissible);
  if (loaded) tp_json_limits(t, p);
  tp_text_add(t, ", \"admissible\": %s%s}", tp_json_truth(p->admissible),
              p->rounded ? ", \"rounded\": true" : "");
}

static bool is_at(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

/* One of those that can govern, or hold the block at its limit. */
static bool matters(const tp_case *c, size_t k) {
  const tp_pivot *p = c->pivots + k;
  bool holds = false;
  for (size_t r = 0; r < c->limit.reaction_count; r++) {
    const tp_reaction *force = c->limit.reactions + r;
    holds = holds || (is_at(force->x_m, p->x_m) && is_at(force->y_m, p->y_m));
  }
  return p->admissible || governs(c, k) || holds;
}

void tp_json_pivots(tp_text *t, const tp_solution *s, const tp_case *c, bool all) {
  tp_text_add(t, "      \"pivot_count\": %zu, \"pivots_listed\": \"%s\",\n      \"pivots\": [",
              c->pivot_count, all ? "all" : "governing");
  bool first = true;
  for (size_t k = 0; k < c->pivot_count; k++) {
    if (!all && !matters(c, k)) continue;
    tp_text_add(t, "%s\n", first ? "" : ",");
    add_pivot(t, c->pivots + k, k, s->loaded);
    first = false;
  }
  tp_text_add(t, "\n      ],\n");
}
