/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which of the numbers that vary the angle depends on: Spearman's rank correlations with their
 * intervals, the strongest on top. */

#include "common/outside.h"
#include "study/chart_panels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_SHOWN = 10, LEAST_ROWS = 4 };

static const tp_chart_style bar = {TP_MARK_REGION, TP_COLOUR_BLUE, TP_DASH_SOLID, 0};
static const tp_chart_style whisker = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_SOLID, 0.7};
static const tp_chart_style zero = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_SOLID, 0.5};

/* The strongest that are known, in order; how many. */
static size_t choose(const tp_study_variable *chosen[MOST_SHOWN], const tp_study_view *v) {
  size_t count = 0;
  for (size_t k = 0; k < v->result->variable_count; k++) {
    const tp_study_variable *own = v->result->variables + k;
    const tp_study_rank *rank = own->rank_correlations + v->quantity;
    if (!rank->known) continue;
    size_t at = count;
    while (at > 0 && fabs(chosen[at - 1]->rank_correlations[v->quantity].value) < fabs(rank->value))
      at--;
    if (at == MOST_SHOWN) continue;
    if (count < MOST_SHOWN) count++;
    memmove(chosen + at + 1, chosen + at, (count - 1 - at) * sizeof(*chosen));
    chosen[at] = own;
  }
  return count;
}

static void add_bar(tp_chart *chart, const tp_study_variable *own, const tp_study_rank *rank,
                    double y) {
  const double half = 0.17;
  char text[96];
  tp_chart_add_guide(chart, bar);
  tp_chart_add_corner(chart, 0, y - half);
  tp_chart_add_corner(chart, rank->value, y - half);
  tp_chart_add_corner(chart, rank->value, y + half);
  tp_chart_add_corner(chart, 0, y + half);
  tp_chart_add_guide(chart, whisker);
  tp_chart_add_corner(chart, rank->low, y);
  tp_chart_add_corner(chart, rank->high, y);
  snprintf(text, sizeof text, "%.*s", (int)tp_whole_characters(own->key, 60), own->key);
  tp_chart_add_plain_label(chart, -0.98, y + half, TP_LABEL_ALONG, text);
  tp_chart_add_series(chart, (tp_chart_style){.mark = TP_MARK_NONE},
                      (const char *const[]){"rank correlation", own->key});
  tp_chart_add_point(chart, tp_chart_exactly(rank->value), tp_chart_exactly(y));
  tp_study_add_interval(chart, rank->low, rank->high);
}

void tp_study_add_ranks(tp_chart *chart, const tp_study_view *v) {
  const tp_study_variable *chosen[MOST_SHOWN];
  const size_t count = choose(chosen, v);
  char label[80];
  if (count == 0) return;
  const double rows = count > LEAST_ROWS ? (double)count : LEAST_ROWS;
  snprintf(label, sizeof label, "Rank correlation with the %s",
           v->quantity == TP_STUDY_LIMIT_DEG ? "static limit" : "critical angle");
  /* no tick lies within the range: rows have names */
  tp_chart_add_panel(chart, "Rank correlations, with 95 % intervals",
                     (tp_panel_axis){.label = label, .range = {-1, 1}, .tick = 0.5},
                     (tp_panel_axis){.range = {0.5, rows + 0.6}, .tick = 1000});
  for (size_t k = 0; k < count; k++) {
    add_bar(chart, chosen[k], chosen[k]->rank_correlations + v->quantity, rows - (double)k);
  }
  tp_chart_add_guide(chart, zero);
  tp_chart_add_corner(chart, 0, 0.5);
  tp_chart_add_corner(chart, 0, rows + 0.6);
}
