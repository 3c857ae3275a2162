/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From the windows in which motions can begin (docs/mechanics.md section 6a): the one that holds
 * the block's own tilt, or what it may steepen by until the first above it. */

#include "report/as_it_lies.h"

#include "report/first.h"
#include "report/onset.h"
#include "report/words.h"
#include "stability/steepening.h"

#include <math.h>
#include <stdio.h>

/* Angles that differ by less are one: the limit, and the onset that is it. */
#define ONE_ANGLE 1e-6 /* degrees */

bool tp_page_lies_known(const tp_solution *s, const tp_case *c) {
  return s->frame.world && s->has_tilt_angle && tp_onset_is_known(&c->onset) &&
         c->limit.kind != TP_LIMIT_NOWHERE && !c->falls_backwards;
}

bool tp_text_azimuth(char out[TP_NUMBER_SIZE + 8], const tp_frame_result *f, bool left) {
  static const char *const names[] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
  enum { POINTS = sizeof names / sizeof names[0] };
  char n[TP_NUMBER_SIZE];
  if (!f->has_dip_direction) return false;
  tp_bounded azimuth = f->dip_direction_deg;
  if (left != (f->dips_towards == TP_TOWARDS_LEFT)) {
    azimuth.value += azimuth.value < 180 ? 180 : -180;
    azimuth.digits = NULL;
  }
  const long point = lround(azimuth.value * POINTS / 360) % POINTS;
  snprintf(out, TP_NUMBER_SIZE + 8, "%s° %s", tp_page_degrees(n, azimuth), names[point]);
  return true;
}

/* Where the block's own tilt lies among the windows. */
typedef struct place {
  const tp_window *inside, *below; /* nearest to it; NULL: there is none */
} place;

static place find_place(const tp_solution *s, const tp_onset *o) {
  const double tilt = s->tilt_angle_deg.value;
  place found = {NULL, NULL};
  for (size_t k = 0; k < o->window_count; k++) {
    const tp_window *w = o->windows + k;
    if (!w->from_below && w->from_deg.value > tilt) break;
    if (!w->to_above && w->to_deg.value < tilt) {
      found.below = w;
    } else {
      found.inside = w;
    }
  }
  return found;
}

/* Is it the angle beyond which it is certain to move, too? */
static bool is_limit(const tp_case *c, tp_bounded angle) {
  const tp_bounded limit =
      c->slides_sooner ? c->sliding.critical_angle_deg : c->limit.critical_angle_deg;
  return c->limit.kind == TP_LIMIT_AT_ANGLE && fabs(limit.value - angle.value) <= ONE_ANGLE;
}

/* "there it topples about pivot 1, …", or what can begin, and from where it is certain. */
static void add_what_begins(tp_page *p, const tp_case *c, tp_bounded at, tp_mechanism begins) {
  char n[TP_NUMBER_SIZE];
  if (is_limit(c, at)) {
    tp_text_add(&p->text, "there it\n  ");
    tp_page_add_first(p, c);
    tp_text_add(&p->text, ".\n");
    return;
  }
  tp_text_add(&p->text, "there it\n  can begin to %s", tp_text_to_move(begins));
  if (c->onset.kind == TP_ONSET_AT_ANGLE && c->onset.has_centre &&
      fabs(c->onset.critical_angle_deg.value - at.value) <= ONE_ANGLE) {
    tp_page_add_centre(p, c, c->onset.centre_x_m, c->onset.centre_y_m);
  }
  tp_text_add(&p->text, ".\n");
  if (c->limit.kind == TP_LIMIT_AT_ANGLE && c->limit.critical_angle_deg.value > at.value) {
    tp_text_add(
        &p->text, "  Certain to move beyond %s°: it ",
        tp_text_fixed(
            n, c->slides_sooner ? c->sliding.critical_angle_deg : c->limit.critical_angle_deg, 3));
    tp_page_add_first(p, c);
    tp_text_add(&p->text,
                ".\n  Between these dips the result depends on loading history: friction on\n"
                "  contacts that carry no normal load could hold it.\n");
  }
}

/* By how much it may steepen. */
static void add_margin(tp_page *p, const tp_case *c) {
  const tp_solution *s = p->solution;
  const bool level = s->frame.level;
  char n[2][TP_NUMBER_SIZE];
  if (!c->may_steepen) {
    tp_text_add(&p->text, level
                              ? "  However it is turned up-dip, up to 90°, no motion can begin.\n"
                              : "  However the slope steepens, up to 90°, no motion can begin.\n");
    return;
  }
  tp_text_fixed(n[0], c->steepen_by_deg, 3);
  tp_text_fixed(n[1], c->steepen_to_deg, 3);
  if (level) {
    tp_text_add(&p->text, "  It may turn up-dip by %s°: ", n[0]);
  } else {
    tp_text_add(&p->text, "  It may steepen by %s°, to a dip of %s°: ", n[0], n[1]);
  }
  add_what_begins(p, c, c->steepen_to_deg, tp_steepening_window(s, c)->begins);
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

/* A block that moves, or may: where it would stand. */
static void add_flatter(tp_page *p, const tp_window *inside) {
  const tp_solution *s = p->solution;
  char n[2][TP_NUMBER_SIZE];
  if (inside == NULL) return;
  if (inside->from_below) {
    tp_text_add(&p->text, s->frame.level ? "  A motion can begin however it is turned back.\n"
                                         : "  A motion can begin at every lesser dip too.\n");
    return;
  }
  tp_text_fixed(n[0], tp_text_less(s->tilt_angle_deg, inside->from_deg), 3);
  tp_text_fixed(n[1], inside->from_deg, 3);
  if (s->frame.level) {
    tp_text_add(&p->text, "  Certain to stand only if turned down-dip by more than %s°.\n", n[0]);
  } else {
    tp_text_add(&p->text, "  Certain to stand only if it lay flatter by %s°, at a dip below %s°.\n",
                n[0], n[1]);
  }
}

/* Lesser tilts, which it will not see unless it is laid flatter. */
static void add_below(tp_page *p, const tp_window *below) {
  char n[TP_NUMBER_SIZE];
  if (below == NULL || p->solution->frame.level) return;
  if (!(below->to_deg.value > 0)) return;
  tp_text_add(&p->text, "  (Laid flatter, to %s° or less, it could begin to %s.)\n",
              tp_text_fixed(n, below->to_deg, 3), tp_text_to_move(below->begins));
}

void tp_page_add_as_it_lies(tp_page *p, const tp_case *c) {
  const tp_solution *s = p->solution;
  const place found = find_place(s, &c->onset);
  const bool stands = c->mechanism == TP_STANDS || c->mechanism == TP_INTERLOCKED;
  char where[TP_NUMBER_SIZE + 24] = "as it lies", n[TP_NUMBER_SIZE];
  if (!s->frame.level) {
    snprintf(where, sizeof where, "as it lies, at %s°", tp_page_degrees(n, s->tilt_angle_deg));
  }
  switch (c->mechanism) {
  case TP_STANDS:
  case TP_INTERLOCKED:
    tp_text_add(&p->text, "  Stands %s: no motion can begin.\n", where);
    break;
  case TP_MAY_MOVE:
    tp_text_add(&p->text, "  May move %s, or stand: the result depends on loading\n  history. It ",
                where);
    add_begun(p, c);
    tp_text_add(&p->text, ".\n");
    break;
  case TP_MECHANISM_UNDECIDED:
    tp_text_add(&p->text, "  Whether it stands %s is undecided at the\n  precision allowed.\n",
                where);
    break;
  case TP_SLIDES:
  case TP_TOPPLES:
  case TP_SLIDES_AND_TOPPLES:
  case TP_LEAVES_BASE:
    tp_text_add(&p->text, "  Does not stand %s: it ", where);
    add_begun(p, c);
    tp_text_add(&p->text, ".\n");
    break;
  }
  if (stands) {
    add_margin(p, c);
    add_below(p, found.below);
  } else {
    add_flatter(p, found.inside);
  }
  if (c->onset.paradox) {
    tp_text_add(&p->text,
                "  Caution: friction would press a slipping contact harder (Painlevé's paradox):\n"
                "  rigid bodies with Coulomb friction have no unique motion as it lies.\n");
  }
}
