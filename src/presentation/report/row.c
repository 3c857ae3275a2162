/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of columns, each a function of solution and case that gives a number or words; CSV and JSON
 * walk the same table. */

#include "report/row.h"

#include "evaluation/case_numbers.h"
#include "output/encode.h"
#include "report/onset.h"
#include "report/parts_json.h"
#include "report/words.h"
#include "terms/names.h"

#include <stdio.h>

/* ---- numbers: false where it is not known ------------------------------------------------------
 */

typedef bool number_of(tp_bounded *number, const tp_solution *s, const tp_case *c);

static bool tilt(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)c;
  *number = s->tilt_angle_deg;
  return s->has_tilt_angle;
}

static bool fos(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  return tp_case_fos(number, c) == TP_CASE_NUMBER;
}

static bool onset(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  return tp_case_onset_deg(number, c) == TP_CASE_NUMBER;
}

static bool moments(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  return tp_case_moments_deg(number, c) == TP_CASE_NUMBER;
}

static bool sliding(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  *number = c->sliding.critical_angle_deg;
  return c->sliding.known && !c->sliding.never && !c->sliding.always;
}

static bool limit(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  return tp_case_limit_deg(number, c) == TP_CASE_NUMBER;
}

static bool first_angle(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  *number = c->first_angle_deg;
  return c->has_first_angle;
}

static bool pivot_x(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  if (c->has_governing) *number = c->pivots[c->governing].x_m;
  return c->has_governing;
}

static bool fos_moments(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  return tp_case_fos_moments(number, c) == TP_CASE_NUMBER;
}

static bool fos_sliding(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  return tp_case_fos_sliding(number, c) == TP_CASE_NUMBER;
}

static bool pivot_y(tp_bounded *number, const tp_solution *s, const tp_case *c) {
  (void)s;
  if (c->has_governing) *number = c->pivots[c->governing].y_m;
  return c->has_governing;
}

/* ---- words: empty where there is none ----------------------------------------------------------
 */

typedef void add_words(tp_text *t, const tp_solution *s, const tp_case *c);

static void add_towards(tp_text *t, const tp_solution *s, const tp_case *c) {
  (void)s;
  tp_text_add(t, "%s", tp_direction_name(c->towards));
}

static void add_verdict(tp_text *t, const tp_solution *s, const tp_case *c) {
  if (s->has_tilt_angle) tp_text_add(t, "%s", tp_mechanism_name(c->mechanism));
}

static void add_fos_mechanism(tp_text *t, const tp_solution *s, const tp_case *c) {
  const tp_factor *factor = tp_case_factor(c);
  (void)s;
  if (factor != NULL) tp_text_add(t, "%s", tp_mechanism_name(factor->mechanism));
}

static void add_fos_definition(tp_text *t, const tp_solution *s, const tp_case *c) {
  const tp_factor *factor = tp_case_factor(c);
  (void)s;
  if (factor != NULL) tp_text_add(t, "%s", tp_fos_definition_name(factor->definition));
}

static void add_limit_mechanism(tp_text *t, const tp_solution *s, const tp_case *c) {
  const tp_limit *own = &c->limit;
  (void)s;
  if (own->kind == TP_LIMIT_NOT_ASKED) return;
  tp_text_add(t, "%s",
              own->kind == TP_LIMIT_NOWHERE ? "holds nowhere" : tp_mechanism_name(own->mechanism));
}

static void add_beginnings(tp_text *t, const tp_solution *s, const tp_case *c) {
  (void)s;
  tp_text_beginnings(t, &c->onset);
}

static void add_first(tp_text *t, const tp_solution *s, const tp_case *c) {
  (void)s;
  tp_text_add(t, "%s", tp_mechanism_name(c->first));
}

static void add_pivot(tp_text *t, const tp_solution *s, const tp_case *c) {
  (void)s;
  if (c->has_governing) tp_text_add(t, "%zu", c->governing);
}

static void add_pivot_kind(tp_text *t, const tp_solution *s, const tp_case *c) {
  (void)s;
  if (c->has_governing) {
    tp_text_add(t, "%s", tp_pivot_kind_name(c->pivots[c->governing].kind));
  }
}

/* ---- columns -----------------------------------------------------------------------------------
 */

/* A number is called by its name and its unit, its bound by its name and _error. */
typedef struct column {
  const char *name, *suffix;
  number_of *number; /* or NULL: */
  add_words *words;
  bool is_count; /* the words are a whole number */
} column;

static const column verdict_columns[] = {
    {"towards", "", NULL, add_towards, false},
    {"tilt", "_deg", tilt, NULL, false},
    {"verdict", "", NULL, add_verdict, false},
    {"fos", "", fos, NULL, false},
    {"fos_mechanism", "", NULL, add_fos_mechanism, false},
    {"fos_definition", "", NULL, add_fos_definition, false},
    {"fos_moments", "", fos_moments, NULL, false},
    {"fos_sliding", "", fos_sliding, NULL, false},
    {"certain_to_stand", "_deg", onset, NULL, false},
    {"moments", "_deg", moments, NULL, false},
    {"sliding", "_deg", sliding, NULL, false},
    {"limit", "_deg", limit, NULL, false},
    {"limit_mechanism", "", NULL, add_limit_mechanism, false},
    {"can_begin", "", NULL, add_beginnings, false},
};

static const column pivot_columns[] = {
    {"first", "", NULL, add_first, false},   {"first", "_deg", first_angle, NULL, false},
    {"pivot", "", NULL, add_pivot, true},    {"pivot_kind", "", NULL, add_pivot_kind, false},
    {"pivot_x", "_m", pivot_x, NULL, false}, {"pivot_y", "_m", pivot_y, NULL, false},
};

typedef struct table {
  const column *columns;
  size_t count;
} table;

static const table tables[] = {
    [TP_ROW_VERDICT] = {verdict_columns, sizeof verdict_columns / sizeof verdict_columns[0]},
    [TP_ROW_PIVOT] = {pivot_columns, sizeof pivot_columns / sizeof pivot_columns[0]},
};

void tp_row_names(tp_text *t, tp_row_columns columns) {
  for (size_t k = 0; k < tables[columns].count; k++) {
    const column *own = tables[columns].columns + k;
    tp_text_add(t, ",%s%s", own->name, own->suffix);
    if (own->number != NULL) tp_text_add(t, ",%s_error", own->name);
  }
}

void tp_row_fields(tp_text *t, tp_row_columns columns, const tp_solution *s, const tp_case *c) {
  for (size_t k = 0; k < tables[columns].count; k++) {
    const column *own = tables[columns].columns + k;
    tp_bounded number = {0};
    tp_text_add(t, ",");
    if (own->words != NULL) {
      if (c != NULL) own->words(t, s, c);
    } else if (c != NULL && own->number(&number, s, c)) {
      tp_text_add(t, "%.17g,%.17g", number.value, number.error);
    } else {
      tp_text_add(t, ",");
    }
  }
}

static void add_member(tp_json *j, const column *own, const char *key, const tp_solution *s,
                       const tp_case *c) {
  tp_bounded number = {0};
  if (own->number != NULL) {
    const bool known = own->number(&number, s, c);
    tp_json_known(j, key, known, number);
    return;
  }
  tp_text words = {0};
  own->words(&words, s, c);
  if (own->is_count && words.data != NULL) {
    tp_json_printed(j, key, words.data);
  } else {
    tp_json_string(j, key, words.data);
  }
  j->text.failed = j->text.failed || words.failed;
  tp_text_drop(&words);
}

void tp_row_members(tp_json *j, tp_row_columns columns, const tp_solution *s, const tp_case *c) {
  for (size_t k = 0; k < tables[columns].count; k++) {
    const column *own = tables[columns].columns + k;
    char key[40];
    snprintf(key, sizeof key, "%s%s", own->name, own->suffix);
    add_member(j, own, key, s, c);
  }
}
