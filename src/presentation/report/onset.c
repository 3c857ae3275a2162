/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sentences on the tilts of certain standing and certain motion, windows of motion, and the motions
 * at the scene's tilt with contact states and forces (docs/mechanics.md section 6a). */

#include "report/onset.h"

#include "report/first.h"
#include "report/words.h"
#include "terms/names.h"

bool tp_onset_is_known(const tp_onset *o) {
  return o->kind == TP_ONSET_AT_ANGLE || o->kind == TP_ONSET_NEVER || o->kind == TP_ONSET_NOWHERE;
}

bool tp_onset_leaves_window(const tp_case *c) {
  if (c->onset.kind == TP_ONSET_AT_ANGLE) return c->onset.below_limit;
  return c->onset.kind == TP_ONSET_NOWHERE && c->limit.kind != TP_LIMIT_NOWHERE;
}

/* By how much the scene's tilt is short of the angle. */
static void add_margin(tp_page *p, tp_bounded angle) {
  char n[TP_NUMBER_SIZE];
  const tp_bounded margin = tp_text_less(angle, p->solution->tilt_angle_deg);
  if (!p->solution->has_tilt_angle || margin.value <= margin.error) return;
  tp_text_fixed(n, margin, 3);
  if (p->solution->frame.world) {
    tp_text_add(&p->text, ", %s by %s°", tp_text_tilted(p->solution), n);
  } else {
    tp_text_add(&p->text, ", a margin of %s°", n);
  }
}

/* ". From that tilt toppling is possible about pivot 1, the peak at (0, 0)" */
static void add_beginning(tp_page *p, const tp_case *c) {
  const tp_onset *o = &c->onset;
  tp_text_add(&p->text, ".\n  From that tilt %s is possible", tp_text_motion(o->mechanism));
  if (o->has_centre) tp_page_add_centre(p, c, o->centre_x_m, o->centre_y_m);
  if (!o->tie) {
    tp_text_add(&p->text, ".\n");
    return;
  }
  tp_text_add(&p->text, ",\n  or %s, a tie", tp_text_motion(o->tied_with));
  tp_page_add_tie(p, o->tie_bits);
}

/* Up to which tilt it is certain to stand. */
static void add_stands(tp_page *p, const tp_case *c) {
  const tp_onset *o = &c->onset;
  char n[TP_NUMBER_SIZE];
  if (o->kind == TP_ONSET_NEVER) {
    tp_text_add(&p->text, "  Certain to stand at every tilt up to 90°: no motion can begin.\n");
    return;
  }
  if (o->kind == TP_ONSET_NOWHERE && p->solution->frame.level) {
    tp_text_add(&p->text, "  Not certain to stand as it lies");
    add_beginning(p, c);
    return;
  }
  if (o->kind == TP_ONSET_NOWHERE) {
    if (o->window_count > 1) {
      tp_text_add(&p->text, "  Not certain to stand %s, however it is %s back",
                  tp_text_level(p->solution), p->solution->frame.world ? "turned" : "tilted");
    } else {
      tp_text_add(&p->text, "  Not certain to stand at any tilt");
    }
    add_beginning(p, c);
    return;
  }
  tp_text_fixed(n, o->critical_angle_deg, 3);
  if (o->critical_angle_deg.value < 0) {
    if (p->solution->frame.level) {
      tp_text_add(&p->text, "  Not certain to stand as it lies, only if turned by %s°", n);
    } else {
      tp_text_add(&p->text, "  Not certain to stand even %s, only below %s°",
                  tp_text_level(p->solution), n);
    }
    add_beginning(p, c);
    return;
  }
  tp_text_add(&p->text, "  Certain to stand up to α_s = %s°", n);
  add_margin(p, o->critical_angle_deg);
  if (o->below_limit || c->limit.kind != TP_LIMIT_AT_ANGLE) {
    add_beginning(p, c);
  } else {
    tp_text_add(&p->text, ",\n  and to move beyond:\n  it ");
    tp_page_add_first(p, c);
    tp_text_add(&p->text, ".\n");
  }
}

/* Beyond which tilt it is certain to move. */
static void add_moves(tp_page *p, const tp_case *c) {
  char n[TP_NUMBER_SIZE];
  switch (c->limit.kind) {
  case TP_LIMIT_AT_ANGLE:
    if (!tp_onset_leaves_window(c)) return;
    tp_text_add(
        &p->text, "  Certain to move beyond α_w = %s°:\n  by limit analysis it ",
        tp_text_fixed(
            n, c->slides_sooner ? c->sliding.critical_angle_deg : c->limit.critical_angle_deg, 3));
    tp_page_add_first(p, c);
    tp_text_add(&p->text, ".\n");
    return;
  case TP_LIMIT_INTERLOCKED:
    if (c->onset.kind != TP_ONSET_NEVER) {
      tp_text_add(&p->text,
                  "  Not certain to move at any tilt up to 90°: some forces would hold it.\n");
    }
    return;
  case TP_LIMIT_UNDECIDED:
    tp_text_add(&p->text, "  The tilt beyond which it is certain to move is undecided.\n");
    return;
  case TP_LIMIT_NOWHERE:
  case TP_LIMIT_NOT_ASKED:
    return;
  }
}

/* Does it reach above level? What happens when it is tilted back is no question here. */
static bool is_above_level(const tp_window *w) {
  return w->to_above || w->to_deg.value > 0;
}

static void add_window(tp_page *p, const tp_window *w) {
  char n[2][TP_NUMBER_SIZE];
  tp_text_fixed(n[0], w->from_deg, 3);
  tp_text_fixed(n[1], w->to_deg, 3);
  if (w->from_below && w->to_above) {
    tp_text_add(&p->text, "at every tilt");
  } else if (w->from_below) {
    tp_text_add(&p->text, "up to %s°", n[1]);
  } else if (w->to_above) {
    tp_text_add(&p->text, "from %s° on", n[0]);
  } else {
    tp_text_add(&p->text, "from %s° to %s°", n[0], n[1]);
  }
}

/* Where one tilt does not tell all of it. */
void tp_page_add_windows(tp_page *p, const tp_onset *o) {
  enum { SHOWN = 8 };
  size_t count = 0, shown = 0;
  bool ends = false;
  for (size_t k = 0; k < o->window_count; k++) {
    count += is_above_level(o->windows + k);
    ends = ends || (is_above_level(o->windows + k) && !o->windows[k].to_above);
  }
  if (!ends) return;
  tp_text_add(&p->text, "  Motions can begin ");
  for (size_t k = 0; k < o->window_count && shown < SHOWN; k++) {
    const tp_window *w = o->windows + k;
    if (!is_above_level(w)) continue;
    tp_text_add(&p->text, "%s", shown > 0 ? ",\n    " : "");
    add_window(p, w);
    tp_text_add(&p->text, " (first to %s)", tp_text_to_move(w->begins));
    shown++;
  }
  if (count > shown) {
    tp_text_add(&p->text, ",\n    and in %zu more windows (--json lists them)", count - shown);
  }
  tp_text_add(&p->text, "\n  and at no other tilt up to 90°.\n");
}

void tp_page_add_onset(tp_page *p, const tp_case *c) {
  add_stands(p, c);
  add_moves(p, c);
  if (tp_onset_leaves_window(c)) {
    tp_text_add(&p->text,
                "  %s the result depends on loading history: friction on\n"
                "  contacts that carry no normal load could hold it. Knowledge of that history%s\n",
                c->limit.kind == TP_LIMIT_AT_ANGLE   ? "Between these tilts"
                : c->onset.kind == TP_ONSET_AT_ANGLE ? "Beyond α_s"
                                                     : "Beyond that tilt",
                p->solution->frame.world ? "\n  would decide."
                                         : ",\n  a tilt test or the tilting table would decide.");
  }
  tp_page_add_windows(p, &c->onset);
  if (c->onset.paradox) {
    tp_text_add(&p->text,
                "  Caution: friction would press a slipping contact harder (Painlevé's paradox):\n"
                "  rigid bodies with Coulomb friction have no unique motion at this tilt.\n");
  }
}

/* "facet 1, left end: sticks" */
static void add_contacts(tp_page *p, const tp_motion *m) {
  enum { SHOWN = 6 };
  char n[2][TP_NUMBER_SIZE];
  if (m->contact_count == 0) tp_text_add(&p->text, "      every contact opens\n");
  for (size_t k = 0; k < m->contact_count && k < SHOWN; k++) {
    const tp_motion_contact *own = m->contacts + k;
    if (own->of_facet) {
      tp_text_add(&p->text, "      facet %zu, %s end: %s", own->facet + 1,
                  own->at_right_end ? "right" : "left", tp_contact_state_name(own->state));
    } else {
      tp_text_add(&p->text, "      pivot %zu, on the facet beside it: %s", own->pivot + 1,
                  tp_contact_state_name(own->state));
    }
    if (own->has_force) {
      tp_text_add(&p->text, ", force (%s, %s) W", tp_text_significant(n[0], own->share_x, 4),
                  tp_text_significant(n[1], own->share_y, 4));
    }
    tp_text_add(&p->text, "\n");
  }
  if (m->contact_count > SHOWN) {
    tp_text_add(&p->text, "      and %zu more\n", m->contact_count - SHOWN);
  }
}

static bool is_none(const tp_motion_resistance *r) {
  return r->share_x.value == 0 && r->share_y.value == 0;
}

static void add_share(tp_page *p, const char *what, const tp_motion_resistance *r) {
  char n[2][TP_NUMBER_SIZE];
  tp_text_add(&p->text, "%s (%s, %s) W", what, tp_text_fixed(n[0], r->share_x, 4),
              tp_text_fixed(n[1], r->share_y, 4));
}

/* "      overcomes cohesion (0.1, 0.05) W and bonds (0, -0.2) W" */
static void add_resistance(tp_page *p, const tp_motion *m) {
  const bool cohesion = m->has_strength && !is_none(&m->cohesion);
  const bool bond = m->has_strength && !is_none(&m->bond);
  if (!cohesion && !bond) return;
  tp_text_add(&p->text, "      overcomes ");
  if (cohesion) add_share(p, "cohesion", &m->cohesion);
  if (bond) add_share(p, cohesion ? " and bonds" : "bonds", &m->bond);
  tp_text_add(&p->text, "\n");
}

void tp_page_add_motions(tp_page *p, const tp_case *c) {
  const tp_onset *o = &c->onset;
  char n[3][TP_NUMBER_SIZE];
  if (!o->has_motions || o->motion_count == 0) return;
  tp_text_add(&p->text, "\n  Motions that can begin at %s°, with accelerations of the centroid\n",
              tp_page_degrees(n[0], p->solution->tilt_angle_deg));
  for (size_t k = 0; k < o->motion_count; k++) {
    const tp_motion *m = o->motions + k;
    tp_text_add(&p->text, "    %s", tp_mechanism_name(m->mechanism));
    if (m->has_centre) {
      tp_text_add(&p->text, " about (%s, %s)", tp_page_coordinate(p, n[0], m->centre_x_m),
                  tp_page_coordinate(p, n[1], m->centre_y_m));
    }
    tp_text_add(&p->text, ":\n      %sx %s g, y %s g, turning %s g/m\n",
                m->accelerations_fixed ? ""
                : m->greatest          ? "at most "
                                       : "at least ",
                tp_text_significant(n[0], m->acceleration_x_g, 4),
                tp_text_significant(n[1], m->acceleration_y_g, 4),
                tp_text_significant(n[2], m->angular_g_per_m, 4));
    add_resistance(p, m);
    add_contacts(p, m);
  }
}

void tp_text_beginnings(tp_text *t, const tp_case *c) {
  const tp_onset *o = &c->onset;
  for (size_t k = 0; k < o->beginning_count; k++) {
    tp_text_add(t, "%s%s", k > 0 ? " or " : "", tp_mechanism_name(o->beginnings[k]));
  }
}

void tp_text_verdict(tp_text *t, const tp_case *c) {
  const tp_onset *o = &c->onset;
  const tp_mechanism m = c->mechanism;
  const bool moves =
      m == TP_SLIDES || m == TP_TOPPLES || m == TP_SLIDES_AND_TOPPLES || m == TP_LEAVES_BASE;
  if (m == TP_MAY_MOVE && o->beginning_count > 0) tp_text_add(t, "may move: ");
  if ((moves || m == TP_MAY_MOVE) && o->beginning_count > 0) {
    tp_text_beginnings(t, c);
  } else {
    tp_text_add(t, "%s", tp_mechanism_name(m));
  }
}
