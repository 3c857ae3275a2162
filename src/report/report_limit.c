/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/report_limit.h"

#include <math.h>

/* "slides and topples about (-21.6, -57.7)", "slides on the facet from … to …" */
static void add_motion(tp_page *p, const tp_limit *l) {
  char n[4][TP_NUMBER_SIZE];
  tp_text_add(&p->text, "%s", tp_text_mechanism(l->mechanism));
  if (l->has_centre) {
    tp_text_add(&p->text, "%s about (%s, %s)", l->turns_up_dip ? " turning up-dip" : "",
                tp_page_coordinate(p, n[0], l->centre_x_m),
                tp_page_coordinate(p, n[1], l->centre_y_m));
  }
}

static const char *base_text(const tp_limit *l) {
  return l->base_beyond_toe ? "goes on past the toe" : "ends at the toe";
}

/* What the limit says, as an end of the sentence "On such a base …". */
static void add_outcome(tp_page *p, const tp_limit *l) {
  char n[TP_NUMBER_SIZE];
  switch (l->kind) {
  case TP_LIMIT_AT_ANGLE:
    tp_text_add(&p->text, "it ");
    add_motion(p, l);
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

static bool overlap(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

/* Does it topple about the pivot that governs its moments? */
static bool topples_about_governing(const tp_case *c) {
  if (c->first != TP_TOPPLES || !c->has_governing) return false;
  if (c->limit.kind != TP_LIMIT_AT_ANGLE) return true;
  const tp_pivot *pivot = c->pivots + c->governing;
  return overlap(c->limit.centre_x_m, pivot->x_m) && overlap(c->limit.centre_y_m, pivot->y_m);
}

void tp_page_add_first(tp_page *p, const tp_case *c) {
  if (!topples_about_governing(c)) {
    if (c->limit.kind == TP_LIMIT_AT_ANGLE && !c->slides_sooner) {
      add_motion(p, &c->limit);
    } else {
      tp_text_add(&p->text, "%s", tp_text_mechanism(c->first));
    }
    return;
  }
  tp_text_add(&p->text, "%s", tp_text_mechanism(c->first));
  tp_text_add(&p->text, " about ");
  tp_page_add_pivot(p, c);
}

/* Where moments and contact forces disagree. */
static void add_moments(tp_page *p, const tp_case *c) {
  char n[2][TP_NUMBER_SIZE];
  if (!c->has_governing || c->limit.kind != TP_LIMIT_AT_ANGLE) return;
  const tp_pivot *pivot = c->pivots + c->governing;
  if (pivot->never || pivot->always) {
    tp_text_add(&p->text, "  Moments alone say that it %s, about the toe.\n",
                pivot->never ? "never topples" : "topples at every tilt");
    return;
  }
  const tp_bounded toppling = pivot->critical_angle_deg;
  const tp_bounded limit = c->limit.critical_angle_deg;
  if (limit.value - limit.error > toppling.value + toppling.error) {
    tp_text_add(&p->text,
                "  Moments alone say %s°, about the toe: friction on the other contacts\n"
                "  can hold it beyond, if it is mobilised.\n",
                tp_text_fixed(n[0], toppling, 3));
  } else if (c->toe.known && !c->toe.holds && c->limit.mechanism != TP_SLIDES) {
    tp_text_add(&p->text,
                "  Moments alone say %s°, where all its weight would rest on the toe; but\n"
                "  friction ends there at φ_b + i = %s°.\n",
                tp_text_fixed(n[0], toppling, 3), tp_text_fixed(n[1], c->toe.limit_angle_deg, 3));
  }
}

static void add_fos(tp_page *p, tp_fos fos) {
  char n[TP_NUMBER_SIZE];
  switch (fos.state) {
  case TP_FOS_NUMBER:
    tp_text_add(&p->text, ",\n  FoS %s by strength reduction", tp_text_fixed(n, fos.value, 3));
    break;
  case TP_FOS_NO_OVERTURNING:
    tp_text_add(&p->text, ",\n  and at this tilt it would hold without any strength");
    break;
  case TP_FOS_UNDEFINED:
    tp_text_add(&p->text, ",\n  and at this tilt no strength would hold it");
    break;
  case TP_FOS_UNDECIDED:
    tp_text_add(&p->text, ",\n  FoS by strength reduction undecided");
    break;
  case TP_FOS_NO_TILT:
  case TP_FOS_NOT_ASKED:
    break;
  }
}

void tp_page_add_limit(tp_page *p, const tp_case *c) {
  const tp_limit *l = &c->limit;
  char n[TP_NUMBER_SIZE];
  if (l->kind == TP_LIMIT_NOT_ASKED) return;
  tp_text_add(&p->text, "  By contact forces, on a base that %s: ", base_text(l));
  if (l->kind == TP_LIMIT_AT_ANGLE) {
    tp_text_add(&p->text, "%s°", tp_text_fixed(n, l->critical_angle_deg, 3));
    if (p->solution->friction_is_residual) {
      tp_text_add(&p->text, ",\n  with φ = %s° at its normal stress there (Eq. 8)",
                  tp_text_fixed(n, l->friction_angle_deg, 3));
    }
    add_fos(p, l->fos);
  } else {
    tp_text_add(&p->text, "\n  ");
    add_outcome(p, l);
  }
  tp_text_add(&p->text, ".\n");
  if (l->kind == TP_LIMIT_AT_ANGLE &&
      l->critical_angle_deg.value + l->critical_angle_deg.error < 0) {
    tp_text_add(&p->text, "  Below 0: on level ground nothing holds it, nor at any tilt above.\n");
  }
  if (l->tie) {
    tp_text_add(&p->text, "  Tie: it %s and it %s at the same limit.\n",
                tp_text_mechanism(l->mechanism), tp_text_mechanism(l->tied_with));
  }
  if (c->base_matters) {
    tp_text_add(&p->text, "  Caution: on a base that %s,\n  ", base_text(&c->limit_otherwise));
    add_outcome(p, &c->limit_otherwise);
    tp_text_add(&p->text, ".\n");
  }
  if (c->slides_sooner) {
    tp_text_add(&p->text,
                "  Caution: these forces let the bond press the contact together, which adds\n"
                "  friction. Without that it slides sooner: see sliding.\n");
  }
  add_moments(p, c);
}
