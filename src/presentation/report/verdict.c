/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The verdict as a sentence: up-dip motion, motion at level, the first mechanism, and what the
 * onset leaves possible at the tilt (docs/mechanics.md section 6a). */

#include "report/verdict.h"

#include "report/as_it_lies.h"
#include "report/first.h"
#include "report/onset.h"
#include "report/words.h"

#include <stdio.h>

/* "at 20°", "on level ground", or where angles count from the block's own place "as it lies" */
static void write_where(char where[TP_NUMBER_SIZE + 8], const tp_solution *s) {
  char n[TP_NUMBER_SIZE];
  if (s->frame.level) {
    snprintf(where, TP_NUMBER_SIZE + 8, "as it lies");
  } else if (s->has_tilt_angle) {
    snprintf(where, TP_NUMBER_SIZE + 8, "at %s°", tp_page_degrees(n, s->tilt_angle_deg));
  } else {
    snprintf(where, TP_NUMBER_SIZE + 8, "on level ground");
  }
}

static bool add_up_dip(tp_page *p, const tp_case *c, const char *where) {
  char n[TP_NUMBER_SIZE];
  if (!c->falls_backwards) return false;
  if (c->limit_holds_from.kind == TP_LIMIT_AT_ANGLE) {
    const tp_bounded from = tp_text_less((tp_bounded){0}, c->limit_holds_from.critical_angle_deg);
    tp_text_add(&p->text, "  Fails up-dip already %s: below %s° it %s.\n", where,
                tp_text_fixed(n, from, 3), tp_mechanism_name(c->limit_holds_from.mechanism));
    return true;
  }
  tp_text_add(&p->text,
              "  Topples up-dip already %s: its centroid lies past the up-dip end of\n"
              "  the contact.\n",
              where);
  return true;
}

/* Where there is no tilt to speak of. */
static bool add_without_tilt(tp_page *p, const tp_case *c, const char *where) {
  const char *said = NULL;
  if (c->limit.kind == TP_LIMIT_NOWHERE) {
    const bool open = c->mechanism == TP_MECHANISM_UNDECIDED;
    tp_text_add(&p->text,
                "  Does not stand: no forces of the base hold it at any tilt, and %s\n  %s%s.\n",
                open ? "how it moves is" : "it", tp_mechanism_name(c->mechanism),
                p->solution->contact.corner_points > 0
                    ? "; its contacts of a corner on a corner are not counted as support"
                    : "");
    return true;
  }
  if (add_up_dip(p, c, where)) {
    tp_page_add_windows(p, &c->onset);
    return true;
  }
  if (tp_onset_is_known(&c->onset)) return false;
  if (c->limit.kind == TP_LIMIT_UNDECIDED) {
    said = "Whether it stands is undecided at the precision allowed.";
  } else if (c->has_toppling_pivot && c->pivots[c->toppling_pivot].always) {
    said = "Its loads topple it at any tilt.";
  } else if (c->slides_sooner && !c->has_first_angle) {
    said = "Its loads slide it at any tilt.";
  } else if (c->first == TP_INTERLOCKED) {
    said = "Interlocked: it neither slides nor topples at any tilt up to 90°.";
  } else if (c->first == TP_STANDS) {
    said = "Does not topple at any tilt up to 90°; without friction_angle_deg sliding is\n"
           "  not judged.";
  }
  if (said != NULL) tp_text_add(&p->text, "  %s\n", said);
  return said != NULL;
}

/* By moments, or by the static limit alone. */
static void add_by_first(tp_page *p, const tp_case *c, const char *where) {
  char n[2][TP_NUMBER_SIZE];
  tp_text_fixed(n[0], c->first_angle_deg, 3);
  if (!c->has_margin_to_first && c->first_angle_deg.value < 0) {
    tp_text_add(&p->text, "  Does not stand even %s: it\n  ", tp_text_level(p->solution));
    tp_page_add_first(p, c);
    tp_text_add(&p->text, " at %s°.\n", n[0]);
    return;
  }
  if (!c->has_margin_to_first || c->mechanism == TP_MECHANISM_UNDECIDED) {
    tp_text_add(&p->text, "  ");
    if (c->mechanism == TP_MECHANISM_UNDECIDED) {
      tp_text_add(&p->text, "Whether it stands %s is undecided. ", where);
    }
    tp_text_add(&p->text, "As %s is %s, it\n  ", p->solution->frame.world ? "it" : "the table",
                tp_text_tilted(p->solution));
    tp_page_add_first(p, c);
    tp_text_add(&p->text, " at %s°.\n", n[0]);
    return;
  }
  if (c->mechanism == TP_STANDS) {
    tp_text_add(&p->text, "  Stands %s%s. %s, it\n  ", where,
                c->limit.kind == TP_LIMIT_NOT_ASKED ? " by its moments" : "",
                p->solution->frame.level   ? "Turned"
                : p->solution->frame.world ? "Steepened"
                                           : "Tilted further");
  } else {
    tp_text_add(&p->text, "  Does not stand %s: it\n  ", where);
  }
  tp_page_add_first(p, c);
  tp_text_fixed(n[1], c->margin_to_first_deg, 3);
  if (p->solution->frame.world && c->mechanism == TP_STANDS) {
    tp_text_add(&p->text, "\n  at %s°: it may %s by %s°.\n", n[0], tp_text_steepen(p->solution),
                n[1]);
  } else {
    tp_text_add(&p->text, "\n  at %s°, a margin of %s°.\n", n[0], n[1]);
  }
}

/* "can begin to slide, or to topple"; where none is known what is by limit analysis. */
static void add_begun(tp_page *p, const tp_case *c) {
  const tp_onset *o = &c->onset;
  for (size_t k = 0; k < o->beginning_count; k++) {
    tp_text_add(&p->text, "%s%s", k > 0 ? ", or to " : "can begin to ",
                tp_text_to_move(o->beginnings[k]));
  }
  if (o->beginning_count == 0) tp_text_add(&p->text, "%s", tp_mechanism_name(c->mechanism));
}

/* What holds at the scene's tilt, in the light of the onset. */
static void add_at_tilt(tp_page *p, const tp_case *c, const char *where) {
  switch (c->mechanism) {
  case TP_STANDS:
  case TP_INTERLOCKED:
    tp_text_add(&p->text, "  Stands %s.\n", where);
    return;
  case TP_MAY_MOVE:
    tp_text_add(&p->text, "  May move %s or stand: the result depends on loading history", where);
    if (c->onset.beginning_count > 0) {
      tp_text_add(&p->text, ".\n  It ");
      add_begun(p, c);
    }
    tp_text_add(&p->text, ".\n");
    return;
  case TP_MECHANISM_UNDECIDED:
    tp_text_add(&p->text, "  Whether it stands %s is undecided at the precision allowed.\n", where);
    return;
  case TP_SLIDES:
  case TP_TOPPLES:
  case TP_SLIDES_AND_TOPPLES:
  case TP_LEAVES_BASE:
    tp_text_add(&p->text, "  Does not stand %s: it ", where);
    add_begun(p, c);
    tp_text_add(&p->text, ".\n");
    return;
  }
}

void tp_page_add_verdict(tp_page *p, const tp_case *c) {
  char where[TP_NUMBER_SIZE + 8];
  write_where(where, p->solution);
  if (add_without_tilt(p, c, where)) return;
  if (tp_page_lies_known(p->solution, c)) {
    tp_page_add_as_it_lies(p, c);
    return;
  }
  if (!tp_onset_is_known(&c->onset)) {
    add_by_first(p, c, where);
    if (c->onset.kind == TP_ONSET_UNDECIDED) {
      tp_text_add(&p->text, "  The tilt up to which it is certain to stand is undecided%s.\n",
                  c->onset.too_dear ? ": its proof\n  exceeds the work allowed" : "");
    }
    return;
  }
  if (p->solution->has_tilt_angle) add_at_tilt(p, c, where);
  tp_page_add_onset(p, c);
}
