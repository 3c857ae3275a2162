/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene of many blocks as a page for a terminal, and as JSON: the verdict first, then numbers,
 * then how each block moves and what each contact bears. */

#include "block_system/governing_case.h"
#include "common/host.h"
#include "output/encode.h"
#include "report/column_page.h"
#include "report/notes.h"
#include "report/results.h"
#include "report/settings.h"
#include "report/system_page.h"
#include "report/system_words.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static size_t free_count(const tp_block_system *s) {
  size_t count = 0;
  for (size_t k = 0; k < s->block_count; k++) count += !s->blocks[k].ground;
  return count;
}

static void add_head(tp_text *t, const tp_block_system *s) {
  if (s->title != NULL) {
    tp_encode_plain(t, s->title);
    tp_text_add(t, "\n\n");
  }
  const size_t moves = free_count(s);
  tp_text_add(t, "Blocks   %zu, and %zu that %s ground; %zu contacts\n", moves,
              s->block_count - moves, s->block_count - moves == 1 ? "is" : "are", s->contact_count);
  tp_text_settings(t, &s->settings);
  tp_text_notes(t, &s->notes);
}

/* ---- the verdict -------------------------------------------------------------------------------
 */

static void add_verdict(tp_text *t, const tp_system_case *c) {
  switch (c->verdict) {
  case TP_SYSTEM_STANDS:
    tp_text_add(t, "  STANDS: no motion can begin.\n");
    break;
  case TP_SYSTEM_COLLAPSES:
    tp_text_add(t, "  COLLAPSES: no forces within the strength of the joints hold the blocks.\n");
    break;
  case TP_SYSTEM_CAN_HOLD:
    tp_text_add(t,
                "  CAN BE HELD: forces within the strength of the joints hold all blocks as\n"
                "  they lie. That a motion begins all the same is neither excluded nor proven.\n");
    break;
  case TP_SYSTEM_MAY_MOVE:
    tp_text_add(
        t, "  MAY MOVE: forces within the strength of the joints can hold all blocks as they\n"
           "  lie, but a motion can begin all the same, proven: which of both happens depends\n"
           "  on how they came to lie so.\n");
    break;
  case TP_SYSTEM_UNDECIDED:
    tp_text_add(t, "  UNDECIDED: the proofs do not tell whether forces hold the blocks.\n");
    break;
  }
}

/* Of the earthquake alone or of the blocks before it shakes. */
static void add_static(tp_text *t, const tp_system_case *c) {
  if (!c->has_static || c->static_verdict == TP_SYSTEM_STANDS) return;
  tp_text_system_label(t, "without the earthquake");
  tp_text_add(t, "%s\n", tp_system_verdict_name(c->static_verdict));
}

/* What forces can hold, and from where on a motion can begin all the same. */
static void add_acceleration(tp_text *t, const tp_system_case *c) {
  static const double fifth = 1e5;
  char n[TP_NUMBER_SIZE];
  if (!tp_system_case_has_critical_acceleration(c)) return;
  tp_text_system_label(t, "critical horizontal acceleration");
  tp_text_add(t, "%s g\n", tp_text_significant(n, c->critical_acceleration_g, 5));
  if (tp_system_case_shakes_sooner(c)) {
    tp_text_system_label(t, "  a motion can begin from");
    tp_text_add(t, "%.5f g\n", ceil(c->moving_acceleration_g * fifth) / fifth);
  } else if (!c->has_standing_acceleration) {
    tp_text_system_label(t, "  a motion can begin from");
    tp_text_add(t, "less, perhaps: that is not excluded\n");
  }
}

static void add_limit(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  tp_text_system_label(t, tp_text_system_limit_name(s));
  tp_text_system_limit(t, c);
  tp_text_add(t, "\n");
  add_acceleration(t, c);
}

/* The factor, and by each definition. */
static void add_safety(tp_text *t, const tp_system_case *c) {
  tp_text_system_label(t, "factor of safety");
  tp_text_system_safety(t, &c->governing_fos);
  tp_text_system_against(t, &c->governing_fos);
  tp_text_add(t, "\n");
  tp_text_system_label(t, "  on driving loads");
  tp_text_system_bounds(t, &c->fos_by_driving);
  tp_text_add(t, "\n");
  tp_text_system_label(t, "  by strength reduction");
  tp_text_system_bounds(t, &c->fos_by_strength);
  tp_text_add(t, "\n");
}

/* Limits of what forces can hold, upper bounds of the factor. */
static void add_upper_bounds(tp_text *t, const tp_system_case *c) {
  tp_text_system_label(t, "forces can hold, driving loads times");
  tp_text_system_driving(t, c);
  tp_text_add(t, "\n");
  tp_text_system_label(t, "forces can hold, strength divided by");
  tp_text_system_factor(t, c);
  tp_text_add(t, "\n");
}

static void add_factor(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  static const char *const met[] = {"met", "NOT MET",
                                    "undecided, as a motion is neither excluded nor proven"};
  char required[TP_NUMBER_SIZE];
  add_static(t, c);
  if (c->fos.state == TP_FOS_NOT_ASKED) return;
  add_safety(t, c);
  if (c->has_required_fos) {
    tp_text_system_label(t, "required factor of safety");
    tp_text_add(t, "%s: %s\n", tp_text_significant(required, s->required_fos, 5),
                met[c->meets_required]);
  }
  add_upper_bounds(t, c);
}

/* ---- tables ------------------------------------------------------------------------------------
 */

static int name_width(const tp_block_system *s) {
  enum { LEAST = 5, MOST = 16 };
  size_t width = LEAST;
  for (size_t k = 0; k < s->block_count; k++) {
    const size_t own = strlen(s->blocks[k].name);
    if (own > width) width = own;
  }
  return width < MOST ? (int)width : MOST;
}

/* Without the sign of what rounds to zero. */
static double to_fourth(double number) {
  return round(number * 1e4) / 1e4 + 0.0;
}

static void add_motions(tp_text *t, const tp_block_system *s, const tp_system_motion *motions,
                        size_t count, const char *heading, int width) {
  size_t row = 0;
  tp_text_add(t, "  %-*s  %-19s  %10s  %10s  %12s\n", width, "block", heading, "speed x", "speed y",
              "turns rad/m");
  for (size_t k = 0; k < count; k++) {
    const tp_system_motion *m = motions + k;
    if (s->blocks[k].ground || row++ >= TP_SYSTEM_ROWS) continue;
    tp_text_add(t, "  ");
    tp_text_system_name(t, s->blocks[k].name, width);
    tp_text_add(t, "  %-19s",
                m->mechanism == TP_STANDS ? "at rest" : tp_mechanism_name(m->mechanism));
    if (m->mechanism != TP_STANDS) {
      tp_text_add(t, "  %10.4f  %10.4f  %12.3g", to_fourth(m->velocity_x), to_fourth(m->velocity_y),
                  m->turn_per_m);
    }
    tp_text_add(t, "\n");
  }
  tp_text_more_rows(t, row);
}

/* Of the joints that are told. */
static bool one_opens_and_bears(const tp_system_case *c) {
  for (size_t k = 0; k < c->force_count && k < TP_SYSTEM_ROWS; k++) {
    const tp_system_force *f = c->forces + k;
    if (f->state == TP_JOINT_OPENS && tp_text_system_force_kn(f->normal_n_m, c) > 0) return true;
  }
  return false;
}

static void add_forces(tp_text *t, const tp_block_system *s, const tp_system_case *c, int width) {
  enum { UNIT_ROOM = 16 };
  const bool wet = c->has_forces && tp_system_case_is_wet(c);
  const int digits = tp_text_system_digits(s);
  tp_text_add(t, "  %-*s  %-*s  %-6s", width, "between", width, "and", "joint");
  if (c->has_forces) tp_text_add(t, "  %10s  %10s", "N kN/m", "T kN/m");
  char at_x[UNIT_ROOM], y[UNIT_ROOM];
  snprintf(at_x, sizeof at_x, "at x %s", s->length_unit);
  snprintf(y, sizeof y, "y %s", s->length_unit);
  tp_text_add(t, "  %10s  %10s", at_x, y);
  if (wet) tp_text_add(t, "  %10s", "water kN/m");
  tp_text_add(t, "\n");
  for (size_t k = 0; k < c->force_count && k < TP_SYSTEM_ROWS; k++) {
    const tp_system_force *f = c->forces + k;
    const tp_system_contact *contact = s->contacts + k;
    tp_text_add(t, "  ");
    tp_text_system_name(t, s->blocks[contact->first].name, width);
    tp_text_add(t, "  ");
    tp_text_system_name(t, s->blocks[contact->second].name, width);
    tp_text_add(t, "  %-6s", tp_joint_state_name(f->state));
    if (c->has_forces) {
      tp_text_add(t, "  %10.4g  %10.4g", tp_text_system_force_kn(f->normal_n_m, c),
                  tp_text_system_force_kn(f->shear_n_m, c));
    }
    tp_text_add(t, "  %10.*g  %10.*g", digits, f->x_m / s->metres_per_unit, digits,
                f->y_m / s->metres_per_unit);
    if (wet) tp_text_add(t, "  %10.4g", f->water_n_m.value / 1e3);
    tp_text_add(t, "\n");
  }
  tp_text_more_rows(t, c->force_count);
  if (one_opens_and_bears(c))
    tp_text_add(t, "  A joint that opens at one end bears at the other.\n");
}

static void add_case(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  const int width = name_width(s);
  tp_text_add(t, "\n");
  tp_text_system_stance(t, s, c);
  tp_text_add(t, "\n");
  add_verdict(t, c);
  add_factor(t, s, c);
  add_limit(t, s, c);
  tp_text_system_beginnings(t, s, c);
  tp_text_system_support(t, s, c);
  tp_text_system_loads(t, s, c, width);
  tp_text_goodman_bray(t, s, c, width);
  if (c->has_start) {
    tp_text_system_start(t, c);
    add_motions(t, s, c->start.motions, c->start.motion_count, "as it begins", width);
  }
  if (c->motion_count == 0) return;
  tp_text_add(t, "\n  Collapse %s: %s.\n", tp_text_system_collapse(s, c),
              tp_mechanism_name(tp_system_case_mechanism(c)));
  if (c->without_vertical) {
    tp_text_add(t, "  This is without the vertical part of the earthquake, the less safe here.\n");
  }
  tp_text_add(t, "  Velocities at its beginning:\n");
  add_motions(t, s, c->motions, c->motion_count, "in the collapse", width);
  tp_text_add(t, "\n  Forces that hold the blocks just before it, one distribution of many:\n");
  add_forces(t, s, c, width);
}

/* Of two directions the one that is less safe, before the page of either. */
static void add_worst(tp_text *t, const tp_block_system *s) {
  const tp_system_case *worst = tp_system_governing(s);
  bool differ = false;
  for (size_t k = 0; k < s->case_count; k++) {
    differ = differ || tp_system_case_is_worse(worst, s->cases + k) ||
             tp_system_case_is_worse(s->cases + k, worst);
  }
  if (!differ) return;
  tp_text_add(t, "Governs  towards the %s: ", tp_direction_name(worst->towards));
  const tp_system_verdict verdict = tp_system_case_worst_verdict(worst);
  if (verdict == TP_SYSTEM_COLLAPSES) {
    tp_text_add(t, "it collapses%s\n", verdict == worst->verdict ? "" : " without the earthquake");
    return;
  }
  if (verdict == TP_SYSTEM_MAY_MOVE) tp_text_add(t, "a motion can begin, ");
  tp_text_add(t, "factor of safety ");
  tp_text_system_safety(t, &s->governing_fos);
  tp_text_system_against(t, &worst->governing_fos);
  tp_text_add(t, "\n");
}

tp_status tp_report_block_system(char **text, const tp_block_system *system) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, system);
  tp_text t = {0};
  add_head(&t, system);
  add_worst(&t, system);
  for (size_t k = 0; k < system->case_count; k++) add_case(&t, system, system->cases + k);
  return tp_text_finish(&t, text);
}

tp_status tp_report_block_system_json(char **text, const tp_block_system *system) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, system);
  tp_json_subject x = {.system = system};
  return tp_json_document_of_block_system(text, system, &x);
}
