/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words above and below a panel: tilt, limit, moments, onset, reactions and loads in one sentence
 * each. */

#include "figure/figure.h"
#include "report/governing.h"
#include "report/onset.h"
#include "report/words.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>

/* An angle to two decimals. */
static const char *degrees(char out[TP_NUMBER_SIZE], tp_bounded angle) {
  return tp_text_fixed(out, angle, 2);
}

/* "topples about pivot 1 at 35.20°" */
static void add_limit(tp_text *t, const tp_figure *figure, const tp_state *state,
                      const tp_limit *limit) {
  char n[TP_NUMBER_SIZE];
  switch (limit->kind) {
  case TP_LIMIT_AT_ANGLE:
    tp_text_add(t, "%s", tp_mechanism_name(limit->mechanism));
    if (limit->mechanism == TP_TOPPLES && limit->has_centre) {
      const tp_spot at = tp_shape_of_metres(&figure->shape, limit->centre_x_m, limit->centre_y_m);
      const size_t pivot = tp_state_pivot_at(figure, state, at);
      if (pivot > 0) {
        tp_text_add(t, " about pivot %zu", state->own->pivots[pivot - 1].index + 1);
      }
    }
    if (limit->turns_up_dip) tp_text_add(t, ", turning up-dip,");
    if (limit->tie) tp_text_add(t, ", or %s (a tie),", tp_mechanism_name(limit->tied_with));
    tp_text_add(t, " at %s°", degrees(n, limit->critical_angle_deg));
    return;
  case TP_LIMIT_INTERLOCKED:
    tp_text_add(t, "interlocked: it holds at every tilt up to 90°");
    return;
  case TP_LIMIT_NOWHERE:
    tp_text_add(t, "no forces of the base hold it at any tilt");
    return;
  case TP_LIMIT_UNDECIDED:
    tp_text_add(t, "the static limit is undecided");
    return;
  case TP_LIMIT_NOT_ASKED:
    return;
  }
}

static void add_base(tp_text *t, const tp_figure *figure, const tp_state *state) {
  const tp_limit *limit = &state->own->limit;
  if (limit->kind == TP_LIMIT_NOT_ASKED) return;
  const bool beyond = limit->base_beyond_toe;
  tp_text_add(t, "; the base %s the toe.", beyond ? "extends past" : "ends at");
  if (!state->own->base_matters) return;
  tp_text_add(t, " If it %s: ", beyond ? "ended there" : "went on");
  add_limit(t, figure, state, &state->own->limit_otherwise);
  tp_text_add(t, ".");
}

static void add_moments(tp_text *t, const tp_figure *figure, const tp_state *state) {
  const tp_case *own = state->own;
  char n[TP_NUMBER_SIZE];
  if (own->limit.kind == TP_LIMIT_NOWHERE) return; /* no pivot carries it */
  if (!own->has_toppling_pivot) {
    tp_text_add(t, " By moments: turning is blocked about every pivot.");
    return;
  }
  const tp_pivot *pivot = own->pivots + own->toppling_pivot;
  const double angle = pivot->critical_angle_deg.value;
  tp_text_add(t, " By moments%s: ", figure->solution->has_friction ? " alone" : "");
  if (pivot->always) {
    tp_text_add(t, "its loads topple it at any tilt.");
  } else if (pivot->never || angle > 90) {
    tp_text_add(t, "does not topple at any tilt up to 90°.");
  } else {
    tp_text_add(t, "topples about pivot %zu at %s°.", pivot->index + 1,
                degrees(n, pivot->critical_angle_deg));
  }
}

/* "Certain to stand up to 26.22° and to move beyond 30.25°; between these tilts it depends on
 * history." */
static void add_onset(tp_text *t, const tp_case *own) {
  const tp_onset *o = &own->onset;
  char n[2][TP_NUMBER_SIZE];
  degrees(n[0], o->critical_angle_deg);
  degrees(n[1],
          own->slides_sooner ? own->sliding.critical_angle_deg : own->limit.critical_angle_deg);
  const bool limited = own->limit.kind == TP_LIMIT_AT_ANGLE;
  switch (o->kind) {
  case TP_ONSET_AT_ANGLE:
    tp_text_add(t, " Certain to stand up to α_s = %s°", n[0]);
    if (tp_onset_leaves_window(own)) {
      tp_text_add(t, ", where it can begin to %s", tp_text_to_move(o->mechanism));
      tp_text_add(
          t,
          limited
              ? ", and to move beyond α_w = %s°; between these tilts it depends on loading history."
              : ".",
          n[1]);
    } else {
      tp_text_add(t, ", and to move beyond.");
    }
    return;
  case TP_ONSET_NEVER:
    tp_text_add(t, " Certain to stand at every tilt up to 90°.");
    return;
  case TP_ONSET_NOWHERE:
    tp_text_add(t, " Not certain to stand at any tilt.");
    return;
  case TP_ONSET_UNDECIDED:
    tp_text_add(t, " The tilt up to which it is certain to stand is undecided.");
    return;
  case TP_ONSET_NOT_ASKED:
    return;
  }
}

static void add_scene_tilt(tp_text *t, const tp_figure *figure, const tp_state *state) {
  const tp_solution *solution = figure->solution;
  const tp_case *own = state->own;
  char n[2][TP_NUMBER_SIZE];
  if (own->falls_backwards) {
    tp_text_add(t, " At %s° it begins to move the other way, up-dip.",
                solution->has_tilt_angle ? tp_page_degrees(n[0], solution->tilt_angle_deg) : "0");
    return;
  }
  if (!solution->has_tilt_angle) return;
  const bool moves = own->mechanism == TP_SLIDES || own->mechanism == TP_TOPPLES ||
                     own->mechanism == TP_SLIDES_AND_TOPPLES;
  tp_text_add(
      t, solution->frame.world ? " As it lies, at %s°, it %s" : " At the scene's tilt of %s° it %s",
      tp_page_degrees(n[0], solution->tilt_angle_deg),
      own->mechanism == TP_INTERLOCKED          ? "stands"
      : moves && tp_onset_is_known(&own->onset) ? "does not stand"
                                                : tp_mechanism_name(own->mechanism));
  const bool passed = own->mechanism == TP_STANDS && own->margin_deg.value < 0; /* a window */
  if (own->has_margin && own->mechanism != TP_MAY_MOVE && !passed) {
    degrees(n[1], own->margin_deg);
    if (solution->frame.world) {
      tp_text_add(t, "; it may %s by %s°", tp_text_steepen(solution), n[1]);
    } else {
      tp_text_add(t, ", a margin of %s°", n[1]);
    }
  }
  tp_text_add(t, ".");
}

static void add_reactions(tp_text *t, const tp_figure *figure, const tp_state *state) {
  char n[TP_NUMBER_SIZE];
  if (state->reaction_count == 0) return;
  tp_text_add(t, state->reaction_count == 1 ? " Reaction " : " Reactions ");
  for (size_t k = 0; k < state->reaction_count; k++) {
    const tp_force *r = state->reactions + k;
    const size_t pivot = tp_state_pivot_at(figure, state, r->at);
    tp_text_add(t, "%sR%s\u00a0=\u00a0%s\u00a0W", k > 0 ? ", " : "",
                state->reaction_count == 1 ? ""
                : k == 0                   ? "₁"
                                           : "₂",
                tp_text_fixed(n, r->size, 3));
    if (pivot > 0) {
      tp_text_add(t, " in pivot\u00a0%zu", state->own->pivots[pivot - 1].index + 1);
    }
  }
  tp_text_add(t, ".");
}

static void add_loads(tp_text *t, const tp_figure *figure) {
  const tp_loads_description *l = &figure->problem->scene->loads;
  const struct {
    bool acts;
    const char *name;
  } kinds[] = {{l->horizontal.given || l->vertical.given, "earthquake"},
               {l->water.given, l->water.lifts_alone && l->water.faces < TP_WATER_IN_FRONT
                                    ? "uplift of water"
                                : l->water.uplift ? "water and uplift"
                                                  : "water"},
               {!fmpq_is_zero(l->water.ice_kpa.value), "ice"},
               {l->pressure_count > 0, "pressure"},
               {l->surcharge_count > 0, "surcharge"},
               {l->support_count > 0, "support pressure"},
               {l->anchor_count > 0, l->anchor_count > 1 ? "anchors" : "anchor"},
               {l->bond_kpa.given, "bond"},
               {l->cohesion_kpa.given, "cohesion"}};
  if (!figure->solution->loaded) return;
  bool first = true;
  tp_text_add(t, " Loads act besides the weight: ");
  for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    if (!kinds[k].acts) continue;
    tp_text_add(t, "%s%s", first ? "" : ", ", kinds[k].name);
    first = false;
  }
  tp_text_add(t, ".");
}

bool tp_figure_heading(double *y, cairo_t *cr, const tp_figure *figure, const tp_state *state,
                       double x, double width) {
  static const char *const states[] = {[TP_STATE_LIMIT] = "drawn at the static limit",
                                       [TP_STATE_MOMENTS] =
                                           "drawn where the weight passes the pivot",
                                       [TP_STATE_SCENE] = "drawn at the scene's tilt",
                                       [TP_STATE_LEVEL] = "drawn level"};
  char n[TP_NUMBER_SIZE];
  tp_text t = {0};
  const bool lies = state->kind == TP_STATE_LIES;
  if (lies) {
    tp_figure_lies_heading(&t, figure, state);
  } else {
    tp_text_add(&t, "%s: %s", tp_text_stance(figure->solution, state->own), states[state->kind]);
  }
  if (state->kind == TP_STATE_LIMIT && figure->solution->has_friction) {
    tp_text_add(&t, ", φ = %s°%s", tp_page_degrees(n, figure->solution->friction_angle_deg),
                figure->solution->friction_facet_count > 0 ? " but on some facets" : "");
  }
  tp_figure_tell(figure, &t);
  const bool done = !t.failed;
  if (done) {
    tp_figure_ink(cr, TP_INK_BLACK);
    *y = tp_figure_paragraph(cr, x, *y, width, TP_HEAD_SIZE, false, t.data);
    if (lies) *y = tp_figure_sides(cr, figure, x, *y, width);
  }
  free(t.data);
  return done;
}

/* At the static limit, or by moments. */
static void add_at_limit(tp_text *verdict, tp_text *more, const tp_figure *figure,
                         const tp_state *state) {
  if (state->kind == TP_STATE_LIMIT && state->tilt_deg.value < 0) {
    tp_text_add(verdict, "Does not stand even %s: ", tp_text_level(figure->solution));
  }
  add_limit(verdict, figure, state, &state->own->limit);
  add_base(verdict, figure, state);
  if (state->own->limit.kind == TP_LIMIT_NOT_ASKED) {
    tp_text_add(verdict, "Without a friction angle only moments are judged.");
  }
  add_onset(more, state->own);
  add_moments(more, figure, state);
  add_scene_tilt(more, figure, state);
}

bool tp_figure_verdict(double *y, cairo_t *cr, const tp_figure *figure, const tp_state *state,
                       double x, double width) {
  tp_text verdict = {0}, more = {0};
  tp_text_governing(&verdict, state->own, " ");
  if (verdict.length > 0) tp_text_add(&verdict, ". ");
  const size_t begin = verdict.length;
  if (!tp_figure_lies_verdict(&verdict, &more, figure, state)) {
    add_at_limit(&verdict, &more, figure, state);
  }
  add_reactions(&more, figure, state);
  add_loads(&more, figure);
  const bool done = !verdict.failed && !more.failed;
  if (done) {
    verdict.data[begin] = (char)toupper((unsigned char)verdict.data[begin]);
    tp_figure_ink(cr, TP_INK_BLACK);
    *y = tp_figure_paragraph(cr, x, *y, width, TP_BODY_SIZE, true, verdict.data);
    if (more.data != NULL) {
      *y = tp_figure_paragraph(cr, x, *y + 1, width, TP_BODY_SIZE, false, more.data);
    }
  }
  free(verdict.data);
  free(more.data);
  return done;
}
