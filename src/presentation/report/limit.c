/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Outcome of the static limit, toe friction, comparison with moments, and the limit on the other
 * kind of base with a caution where that is less safe (docs/mechanics.md section 6). */

#include "report/limit.h"

#include "report/first.h"
#include "report/onset.h"
#include "report/words.h"

static const char *base_text(const tp_limit *l) {
  return l->base_beyond_toe ? "extends past the toe" : "ends at the toe";
}

/* What the limit says, as an end of the sentence "On such a base …". */
static void add_outcome(tp_page *p, const tp_case *c, const tp_limit *l) {
  char n[TP_NUMBER_SIZE];
  switch (l->kind) {
  case TP_LIMIT_AT_ANGLE:
    tp_text_add(&p->text, "it ");
    tp_page_add_limit_motion(p, c, l);
    tp_text_add(&p->text, " at %s°", tp_text_fixed(n, l->critical_angle_deg, 3));
    break;
  case TP_LIMIT_INTERLOCKED:
    tp_text_add(&p->text, "forces hold it at every tilt up to 90°");
    break;
  case TP_LIMIT_NOWHERE:
    tp_text_add(&p->text, "no forces hold it at any tilt");
    break;
  case TP_LIMIT_NOT_ASKED:
  case TP_LIMIT_UNDECIDED:
    tp_text_add(&p->text, "the limit is undecided at the precision allowed");
    break;
  }
}

/* "φ - 9.462° = 20.538°" */
static void add_toe_friction(tp_page *p, const tp_toe *toe) {
  const tp_solution *s = p->solution;
  char n[2][TP_NUMBER_SIZE];
  tp_text_fixed(n[0], toe->limit_angle_deg, 3);
  if (s->friction_is_residual || s->friction_facet_count > 0) {
    tp_text_add(&p->text, "%s°", n[0]);
    return;
  }
  tp_bounded i = tp_text_less(toe->limit_angle_deg, s->friction_angle_deg);
  const bool climbs = i.value >= 0;
  if (!climbs) i.value = -i.value;
  tp_text_add(&p->text, "φ %s %s° = %s°", climbs ? "+" : "−", tp_page_degrees(n[1], i), n[0]);
}

/* Where moments and contact forces disagree. */
static void add_moments(tp_page *p, const tp_case *c) {
  char n[TP_NUMBER_SIZE];
  if (!c->has_toppling_pivot || c->limit.kind != TP_LIMIT_AT_ANGLE) return;
  const tp_pivot *pivot = c->pivots + c->toppling_pivot;
  if (pivot->never || pivot->always) {
    tp_text_add(&p->text, "  By moments alone it %s, about pivot %zu.\n",
                pivot->never ? "never topples" : "topples at every tilt", pivot->index + 1);
    return;
  }
  const tp_bounded toppling = pivot->critical_angle_deg;
  const tp_bounded limit = c->limit.critical_angle_deg;
  tp_text_fixed(n, toppling, 3);
  if (limit.value - limit.error > toppling.value + toppling.error) {
    if (tp_onset_leaves_window(c)) return; /* said of the onset */
    tp_text_add(&p->text,
                "  Moments alone give %s°, about pivot %zu: friction on the other contacts\n"
                "  can hold it beyond, if it is mobilised.\n",
                n, pivot->index + 1);
  } else if (c->toe.known && !c->toe.holds && c->limit.mechanism != TP_SLIDES) {
    tp_text_add(&p->text,
                "  Moments alone give %s°, where all the weight would act on pivot %zu; but\n"
                "  friction is exhausted there at ",
                n, pivot->index + 1);
    add_toe_friction(p, &c->toe);
    tp_text_add(&p->text, ".\n");
  }
}

/* From the least safe on; what is undecided may be anything. */
static int safety(const tp_limit *l) {
  switch (l->kind) {
  case TP_LIMIT_NOWHERE:
    return 0;
  case TP_LIMIT_AT_ANGLE:
    return 1;
  case TP_LIMIT_INTERLOCKED:
    return 2;
  case TP_LIMIT_NOT_ASKED:
  case TP_LIMIT_UNDECIDED:
    break;
  }
  return -1;
}

static bool may_be_less_safe(const tp_limit *l, const tp_limit *than) {
  const int own = safety(l), other = safety(than);
  if (own != 1 || other != 1) return own < other;
  const tp_bounded a = l->critical_angle_deg, b = than->critical_angle_deg;
  return a.value + a.error < b.value - b.error;
}

/* A caution where the other kind of base would be the less safe one. */
static void add_otherwise(tp_page *p, const tp_case *c) {
  const tp_limit *other = &c->limit_otherwise;
  if (!c->base_matters) return;
  tp_text_add(&p->text, "  %s a base that %s%s",
              may_be_less_safe(other, &c->limit) ? "Caution: on" : "On", base_text(other),
              other->kind == TP_LIMIT_AT_ANGLE ? "\n  " : ", ");
  add_outcome(p, c, other);
  tp_text_add(&p->text, ".\n");
}

void tp_page_add_limit(tp_page *p, const tp_case *c) {
  const tp_limit *l = &c->limit;
  char n[TP_NUMBER_SIZE];
  if (l->kind == TP_LIMIT_NOT_ASKED) return;
  tp_text_add(&p->text, "  By contact forces, on a base that %s", base_text(l));
  if (l->kind == TP_LIMIT_AT_ANGLE) {
    tp_text_add(&p->text, ": %s°", tp_text_fixed(n, l->critical_angle_deg, 3));
    if (p->solution->friction_is_residual) {
      tp_text_add(&p->text, ",\n  with φ = %s° at its normal stress there (Eq. 8)",
                  tp_text_fixed(n, l->friction_angle_deg, 3));
    }
  } else {
    tp_text_add(&p->text, ",\n  ");
    add_outcome(p, c, l);
  }
  tp_text_add(&p->text, ".\n");
  if (l->kind == TP_LIMIT_AT_ANGLE &&
      l->critical_angle_deg.value + l->critical_angle_deg.error < 0) {
    tp_text_add(&p->text, "  Below 0: %s no forces hold it%s.\n", tp_text_level(p->solution),
                p->solution->frame.level ? "" : ", nor at any tilt above");
  }
  if (l->tie) {
    tp_text_add(&p->text, "  Tie: it %s and it %s at the same limit",
                tp_mechanism_name(l->mechanism), tp_mechanism_name(l->tied_with));
    tp_page_add_tie(p, l->tie_bits);
  }
  add_otherwise(p, c);
  if (c->slides_sooner) {
    tp_text_add(&p->text,
                "  Caution: these forces let the bond press the contact together, which adds\n"
                "  friction. Without that it slides sooner: see sliding.\n");
  }
  add_moments(p, c);
}
