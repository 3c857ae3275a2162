/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The parts of a tilt test's report as text (report/tilt_page.c puts them together): settings, the
 * angle with as many decimals as its bracket allows, events and ending (docs/tilt.md). */

#include "report/tilt_text.h"

#include "output/encode.h"
#include "report/words.h"

#include <math.h>

static const double standard_gravity = 9.80665;

/* ---- what was run ------------------------------------------------------------------------------
 */

static void add_engine(tp_text *t, const tp_tilt_settings *s) {
  static const char *const what[] = {
      [TP_TILT_PATH] = "path, quasi-static from event to event",
      [TP_TILT_RIGID] = "dynamics of a rigid block on rigid contacts, by events",
      [TP_TILT_SPRINGS] = "dynamics by explicit time steps on contact springs"};
  tp_text_add(t, "Test     %s\n         ", what[s->engine]);
  if (s->protocol == TP_TILT_RELEASE) {
    tp_text_add(t, "released at %.6g°", s->release_deg);
  } else if (s->protocol == TP_TILT_STEPS) {
    tp_text_add(t, "a fresh start at each tilt, %s, up to %.6g°",
                s->set_down ? "set down there" : "from level", s->until_deg);
  } else if (s->set_down) {
    tp_text_add(t, "set down at %.6g°, tilted up to %.6g°", s->from_deg, s->until_deg);
  } else {
    tp_text_add(t, "placed level, tilted up to %.6g°", s->until_deg);
  }
  if (s->speed_deg_min > 0) tp_text_add(t, " at %.6g°/min", s->speed_deg_min);
  if (s->tolerance_deg > 0) tp_text_add(t, ", to %.3g°", s->tolerance_deg);
  tp_text_add(t, "\n");
}

static void add_contact(tp_text *t, const tp_tilt_settings *s) {
  if (s->engine == TP_TILT_RIGID) {
    tp_text_add(t, "         impacts with a restitution of %.6g\n", s->restitution);
    return;
  }
  tp_text_add(t, "         contact %.6g GPa/m normal, %.6g GPa/m shear\n",
              s->normal_stiffness_pa_m / 1e9, s->shear_stiffness_pa_m / 1e9);
  if (s->traction_count > 0) {
    tp_text_add(t, "         stress locked in on %zu %s before the start\n", s->traction_count,
                s->traction_count == 1 ? "facet" : "facets");
  }
  if (s->engine != TP_TILT_SPRINGS) return;
  tp_text_add(t, "         local damping %.6g, corners rounded by %.3g m, time step ", s->damping,
              s->rounding_m);
  if (s->time_step_s > 0) {
    tp_text_add(t, "%.3g s\n", s->time_step_s);
  } else {
    tp_text_add(t, "chosen\n");
  }
}

static void add_shaking(tp_text *t, const tp_tilt_test *test) {
  static const char *const names[] = {"horizontal", "vertical"};
  const char *head = "Shaking";
  for (int axis = 0; axis < 2; axis++) {
    const tp_tilt_shaking *own = test->shaking + axis;
    if (!own->given) continue;
    tp_text_add(t, "%-9s%s: PGA %.4g g, PGV %.4g m/s, over %.4g s\n", head, names[axis],
                own->peak_m_s2 / standard_gravity, own->peak_velocity_m_s, own->duration_s);
    head = "";
  }
}

/* ---- what it came to ---------------------------------------------------------------------------
 */

static double length(const tp_tilt_test *test, double metres) {
  return metres / test->metres_per_unit;
}

/* A length that the block is as large as. */
static double size_of(const tp_tilt_case *c) {
  return c->outline_count == 0
             ? 0
             : hypot(c->outline[0].x_m - c->centroid_x_m, c->outline[0].y_m - c->centroid_y_m);
}

/* What is next to the size nothing but rounding is 0. */
static double cleared(double value, double size) {
  return fabs(value) < 1e-9 * size ? 0 : value;
}

/* A point in the scene's unit, to a ten thousandth of the block, be it far from the origin. */
static void add_point(tp_text *t, const tp_tilt_test *test, const tp_tilt_case *c, double x_m,
                      double y_m) {
  enum { OWN = 5, MOST = 15 };
  const double size = size_of(c), metres[] = {cleared(x_m, size), cleared(y_m, size)};
  int digits[2];
  for (int k = 0; k < 2; k++) {
    const double over = fabs(metres[k]) > size && size > 0 ? log10(fabs(metres[k]) / size) : 0;
    digits[k] = OWN + (int)fmin(ceil(over), MOST - OWN);
  }
  tp_text_add(t, "(%.*g, %.*g)", digits[0], length(test, metres[0]), digits[1],
              length(test, metres[1]));
}

/* Decimals of an angle that a bracket of that width leaves sense to. */
static int decimals_of(const tp_tilt_case *c) {
  const double width = c->lets_go_at_deg - c->stands_at_deg;
  return width > 0 ? (int)fmin(6, fmax(2, 1 - floor(log10(width)))) : 6;
}

static void add_path(tp_text *t, const tp_tilt_case *c) {
  if (c->has_softening) {
    tp_text_add(t,
                "  This is the limit of stiff contacts; on the given springs it begins to move\n"
                "  %.2g° earlier, as its weight moves when they deform.\n",
                c->softening_deg);
  }
  if (c->jumps == 1) {
    tp_text_add(t, "  At %.4g° it moved, and came to rest at the same tilt.\n", c->first_jump_deg);
  } else if (c->jumps > 1) {
    tp_text_add(t, "  It moved %zu times and came to rest at the same tilt, first at %.4g°.\n",
                c->jumps, c->first_jump_deg);
  }
}

static void add_bracket(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  if (test->settings.protocol == TP_TILT_RELEASE) return;
  if (isnan(c->stands_at_deg) && test->settings.from_deg > 0) {
    tp_text_add(t, "  No forces hold it where it is set down: it begins to move there.\n");
    return;
  }
  if (isnan(c->stands_at_deg)) {
    tp_text_add(t,
                "  No run is known to stand: the tilt at which it begins to move is not known.\n");
    return;
  }
  if (!c->has_bracket) {
    tp_text_add(t,
                c->converged ? "  Stands up to %.6g°, the last tilt tried.\n"
                             : "  Stands up to %.6g°; beyond that the result is undecided.\n",
                c->stands_at_deg);
    return;
  }
  const int d = decimals_of(c);
  if (c->lets_go_at_deg > c->stands_at_deg) {
    tp_text_add(t, "  Stands at %.*f°, begins to move at %.*f°", d, c->stands_at_deg, d,
                c->lets_go_at_deg);
  } else {
    tp_text_add(t, "  Begins to move as it is set down, at %.4g°", c->lets_go_at_deg);
  }
  if (c->has_mechanism) {
    tp_text_add(t, ":\n  it %s",
                c->mechanism == TP_MECHANISM_UNDECIDED ? "moves" : tp_mechanism_name(c->mechanism));
    if (c->has_centre) {
      tp_text_add(t, " about ");
      add_point(t, test, c, c->centre_x_m, c->centre_y_m);
    }
  }
  tp_text_add(t, ".\n");
  add_path(t, c);
  if (!c->converged) tp_text_add(t, "  The bracket is wider than requested.\n");
}

static void add_window(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  if (!c->has_onset || !c->has_limit) {
    tp_text_add(t, "  Statics gives no window of tilts to compare with.\n");
    return;
  }
  tp_text_add(t, "  Statics: certain to stand up to α_s = %.3f°, to move beyond α_w = %.3f°.\n",
              c->onset_deg, c->limit_deg);
  if (test->settings.protocol == TP_TILT_RELEASE) return;
  const bool wide = c->limit_deg - c->onset_deg > 1e-6;
  const bool locked = test->settings.traction_count > 0;
  if (c->place == TP_PLACE_WITHIN && wide) {
    tp_text_add(t,
                "  Between these tilts the result depends on loading history: here on how the\n"
                "  block reached the tilt, %sthe ratio of the contact stiffnesses,\n"
                "  if it has any.\n",
                locked ? "the stress locked in on its contact,\n  and " : "and ");
  } else if (c->place == TP_PLACE_BELOW) {
    tp_text_add(t, "  It moved below α_s, where rigid contacts allow no motion: an effect\n  of "
                   "springs, damping, time step or speed of the table; vary them.\n");
  } else if (c->place == TP_PLACE_BEYOND) {
    tp_text_add(t, "  It moved beyond α_w, where no forces hold it: detected late, or affected by\n"
                   "  the settings; vary them.\n");
  }
}

/* ---- what happened -----------------------------------------------------------------------------
 */

static bool is_of_contact(const tp_tilt_event *e) {
  return e->what < TP_EVENT_COLLAPSES || e->what == TP_EVENT_ACCUMULATES;
}

void tp_tilt_add_event_words(tp_text *t, const tp_tilt_event *e, const tp_tilt_case *c,
                             const tp_tilt_test *test) {
  if (!is_of_contact(e)) {
    tp_text_add(t, "the block %s", tp_tilt_event_name(e->what));
  } else {
    if (e->facet > 0) {
      tp_text_add(t, "facet %ld", e->facet);
    } else {
      tp_text_add(t, "the end face");
    }
    tp_text_add(t, " %s at ", tp_tilt_event_name(e->what));
    add_point(t, test, c, e->x_m, e->y_m);
  }
  if (e->what == TP_EVENT_CLOSES && e->speed_m_s > 0) {
    tp_text_add(t, ", %.3g m/s", e->speed_m_s);
  }
}

static void add_event(tp_text *t, const tp_tilt_event *e, const tp_tilt_case *c,
                      const tp_tilt_test *test) {
  tp_text_add(t, "  %9.4f° ", e->angle_deg);
  if (test->settings.engine != TP_TILT_PATH) tp_text_add(t, "%10.4f s  ", e->time_s);
  tp_tilt_add_event_words(t, e, c, test);
  tp_text_add(t, "\n");
}

size_t tp_tilt_chatter_length(const tp_tilt_case *c, size_t first) {
  const tp_tilt_event *e = c->events + first;
  size_t k = first + 1;
  if (!is_of_contact(e)) return 1;
  while (k < c->event_count && c->events[k].facet == e->facet && is_of_contact(c->events + k)) k++;
  return k - first;
}

void tp_tilt_add_facets(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  enum { LISTED = 8 };
  size_t differing = 0, listed = 0;
  for (size_t k = 0; k < c->facet_count; k++) {
    const tp_tilt_facet *f = c->facets + k;
    if (f->contact == 0 || f->contact == (size_t)f->facet) continue;
    differing++;
    if (listed == LISTED) continue;
    listed++;
    tp_text_add(t, "  facet %ld, ", f->facet);
    add_point(t, test, c, f->x0_m, f->y0_m);
    tp_text_add(t, " to ");
    add_point(t, test, c, f->x1_m, f->y1_m);
    tp_text_add(t, ": facet %zu of the contact\n", f->contact);
  }
  if (differing > listed) {
    tp_text_add(t, "  and %zu more (listed by --json)\n", differing - listed);
  }
}

void tp_tilt_add_events(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  size_t k = 0;
  if (c->event_count == 0) return;
  tp_text_add(t, "\n  Events (facets of the base from left to right)\n");
  tp_tilt_add_facets(t, c, test);
  for (size_t lines = 0; k < c->event_count && lines < TP_TILT_EVENTS_TOLD; lines++) {
    const size_t length = tp_tilt_chatter_length(c, k);
    add_event(t, c->events + k, c, test);
    if (length < TP_TILT_CHATTER) {
      k++;
      continue;
    }
    tp_text_add(t, "             alternating, %zu times in all, until it\n", length);
    add_event(t, c->events + k + length - 1, c, test);
    k += length;
  }
  if (k < c->event_count) {
    tp_text_add(t, "  and %zu more (listed by --json)\n", c->event_count - k);
  }
}

static void add_end(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  static const char *const what[] = {
      [TP_TILT_STANDS] = "It stands where it began",
      [TP_TILT_COLLAPSES] = "What follows is a motion, which the path does not simulate",
      [TP_TILT_RESTS] = "It moved, and came to rest again",
      [TP_TILT_MOVES] = "It was still in motion when the run ended",
      [TP_TILT_OVERTURNED] = "It overturned",
      [TP_TILT_LEFT_BASE] = "It left its base",
      [TP_TILT_OPEN] = "Its end is undecided: a limit on steps or events was reached",
      [TP_TILT_STOPPED] = "The test was interrupted; results up to that point"};
  tp_text_add(t, "\n  %s", what[c->end]);
  if (test->settings.engine == TP_TILT_PATH || c->end == TP_TILT_STANDS) {
    tp_text_add(t, ".\n");
    return;
  }
  tp_text_add(t, "; followed to %.4g s.\n", c->ended_s);
  tp_tilt_add_peak(t, c);
  tp_text_add(t, "  Run-out %.4g %s down-dip, turned by %.4g° at its end.\n",
              length(test, cleared(c->run_out_m, size_of(c))), test->length_unit,
              cleared(c->turned_deg, 180));
  const double balance = c->energy_scale_j > 0 ? c->energy_balance_j / c->energy_scale_j : 0;
  tp_text_add(t, "  Kinetic energy at most %.3g J; energy balanced within %.1e of\n",
              c->kinetic_energy_j, balance);
  tp_text_add(t, "  weight times extent.\n");
}

void tp_tilt_add_settings(tp_text *t, const tp_tilt_test *test) {
  add_engine(t, &test->settings);
  add_contact(t, &test->settings);
  add_shaking(t, test);
}

void tp_tilt_add_verdict(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  add_bracket(t, c, test);
  add_window(t, c, test);
}

void tp_tilt_add_ending(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  add_end(t, c, test);
  tp_tilt_add_overturning(t, c, test);
}
