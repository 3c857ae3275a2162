/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* For each frequency, PGA raised by eighths of an octave to the first overturning and two octaves
 * beyond, with changes bisected; frequencies are spaced geometrically. */

#include "tilt/overturning_spectrum.h"

#include "common/message.h"
#include "problem/problem.h"
#include "stability/solution.h"
#include "stability/solve.h"
#include "tilt/cost.h"
#include "tilt/engines.h"
#include "tilt/overturning.h"
#include "tilt/settings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* PGA, octaves of g, and the step. */
static const double weakest = -6, strongest = 6, beyond = 2;
static const double octave = 0.125;

/* What a direction is searched with. */
typedef struct stage {
  const tp_overturning_options *options;
  const tp_problem *problem;
  tp_base_shaking *shaking;
  tp_tilt_settings settings;
  tp_tilt_options runs; /* that the runs ask whether to stop */
  tp_place place;
  tp_message *message;
} stage;

/* ---- one frequency -----------------------------------------------------------------------------
 */

typedef struct climb {
  tp_overturning own;
  tp_overturning_point *point;
  double unit_m_s2; /* PGA of the scene, which factors multiply */
  double tolerance;
} climb;

static tp_pga_bracket bracket_of(const climb *c, const double between[2]) {
  return (tp_pga_bracket){between[0] * c->unit_m_s2, between[1] * c->unit_m_s2};
}

/* Another octave or part of it. `*changed`: not as it was, with the bracket. */
static tp_status step(tp_tilt_verdict *verdict, tp_pga_bracket *bracket, bool *changed, climb *c,
                      double from_m_s2, double to_m_s2) {
  const tp_tilt_verdict before = *verdict;
  double between[2] = {from_m_s2 / c->unit_m_s2, to_m_s2 / c->unit_m_s2};
  tp_status status = tp_overturning_look(verdict, &c->own, between[1]);
  if (status != TP_OK || !c->own.tilting->own->converged) return status;
  c->point->strongest_m_s2 = to_m_s2;
  *changed = *verdict != before;
  if (*changed) status = tp_overturning_narrow(between, &c->own, *verdict, c->tolerance);
  *bracket = bracket_of(c, between);
  return status;
}

static tp_status find_least(climb *c, tp_tilt_verdict *verdict) {
  tp_status status = TP_OK;
  double from = 0;
  for (double k = weakest; k <= strongest && status == TP_OK; k += octave) {
    const double to = TP_GRAVITY_M_S2 * exp2(k);
    tp_pga_bracket bracket;
    bool changed = false;
    status = step(verdict, &bracket, &changed, c, from, to);
    if (status != TP_OK || !c->own.tilting->own->converged) return status;
    if (changed) {
      c->point->overturns = true;
      c->point->least = bracket;
      return TP_OK;
    }
    from = to;
  }
  return status;
}

static void take_change(tp_overturning_point *p, tp_tilt_verdict verdict, tp_pga_bracket at) {
  if (verdict == TP_VERDICT_STANDS && p->island_count < TP_ISLANDS_MAX) {
    p->islands[p->island_count++] = (tp_spared_island){.from = at, .open = true};
  } else if (p->island_count > 0) {
    p->islands[p->island_count - 1].to = at;
    p->islands[p->island_count - 1].open = false;
  }
}

static tp_status find_islands(climb *c, tp_tilt_verdict *verdict) {
  tp_overturning_point *p = c->point;
  const double first = p->strongest_m_s2;
  double from = first;
  tp_status status = TP_OK;
  for (double k = octave; k <= beyond && status == TP_OK; k += octave) {
    const double to = first * exp2(k);
    tp_pga_bracket bracket;
    bool changed = false;
    status = step(verdict, &bracket, &changed, c, from, to);
    if (status != TP_OK || !c->own.tilting->own->converged) break;
    if (changed) take_change(p, *verdict, bracket);
    from = to;
  }
  if (p->island_count > 0 && p->islands[p->island_count - 1].open) {
    p->islands[p->island_count - 1].to = (tp_pga_bracket){p->strongest_m_s2, p->strongest_m_s2};
  }
  return status;
}

static tp_status find_point(tp_overturning_point *point, tp_tilting *tilting, const stage *g) {
  const tp_shaking_peaks peaks =
      tp_base_acceleration_peaks(g->shaking->axes + TP_SHAKING_HORIZONTAL);
  climb c = {.own = {tilting, g->shaking},
             .point = point,
             .unit_m_s2 = peaks.acceleration_m_s2,
             .tolerance = g->options->tolerance};
  tp_tilt_verdict verdict = TP_VERDICT_STANDS;
  point->velocity_s = peaks.velocity_m_s / peaks.acceleration_m_s2;
  tilting->shaking_s = tp_base_shaking_duration(g->shaking);
  tilting->own->converged = true;
  tilting->spent = 0;
  tilting->search = tp_tilting_search_budgets(0);
  tp_status status = find_least(&c, &verdict);
  if (status == TP_OK && point->overturns && tilting->own->converged) {
    status = find_islands(&c, &verdict);
  }
  point->converged = tilting->own->converged;
  g->shaking->factor = 1;
  return status;
}

/* ---- one direction -----------------------------------------------------------------------------
 */

static double frequency_of(const stage *g, size_t k) {
  const tp_overturning_options *o = g->options;
  if (k + 1 == o->count) return o->to;
  return o->from * pow(o->to / o->from, (double)k / (double)(o->count - 1));
}

/* What the frequency is counted in: that of the scene, or the speed of its record. */
static double scene_frequency(const tp_base_shaking *shaking) {
  const tp_base_acceleration *axis = shaking->axes + TP_SHAKING_HORIZONTAL;
  return axis->form == TP_SHAKING_RECORD ? 1 : axis->frequency_hz;
}

/* What takes too long is refused by the frequency, which the caller chose. */
static tp_status check_cost(tp_tilting *tilting, const stage *g, double frequency) {
  tp_message why = {.text = ""};
  tilting->message = &why;
  tilting->shaking_s = tp_base_shaking_duration(g->shaking);
  const tp_status status = tp_tilting_check_cost(
      tilting, tp_tilt_duration(tilting->settings, tilting->body) + tilting->shaking_s);
  tilting->message = g->message;
  if (status == TP_OK) return TP_OK;
  return tp_fail(g->message, status, (tp_place){0}, "at a frequency of %g in the spectrum: %s",
                 frequency, why.text);
}

static tp_status find_points(tp_overturning_case *own, tp_tilting *tilting, const stage *g,
                             size_t before, size_t all) {
  const double begun = scene_frequency(g->shaking);
  double now = begun;
  tp_status status = TP_OK;
  for (size_t k = 0; k < g->options->count && status == TP_OK; k++) {
    tp_overturning_point *point = own->points + own->count;
    if (tp_tilting_stopped(tilting)) break;
    *point = (tp_overturning_point){.frequency = frequency_of(g, k)};
    tp_base_shaking_hasten(g->shaking, point->frequency / now);
    now = point->frequency;
    status = check_cost(tilting, g, now);
    if (status != TP_OK) break;
    status = find_point(point, tilting, g);
    if (tp_tilting_stopped(tilting)) break; /* what it came to is in the midst of a search */
    own->count++;
    if (g->options->progress != NULL) {
      g->options->progress(g->options->context, before + own->count, all);
    }
  }
  tp_base_shaking_hasten(g->shaking, begun / now);
  return status;
}

/* By its weight alone on level ground a held acceleration a is a tilt of atan(a / g). */
static void set_static(tp_overturning_case *own, const tp_case *statics, const tp_rigid_body *body,
                       const stage *g) {
  own->has_static = g->settings.release_deg == 0 && !body->loads.given &&
                    g->shaking->axes[TP_SHAKING_VERTICAL].form == TP_SHAKING_NONE &&
                    statics->limit.kind == TP_LIMIT_AT_ANGLE;
  if (!own->has_static) return;
  own->static_m_s2 =
      TP_GRAVITY_M_S2 * tan(tp_tilt_radians(statics->limit.critical_angle_deg.value));
}

static tp_status find_case(tp_overturning_case *own, const tp_case *statics, const stage *g,
                           size_t before, size_t all) {
  tp_rigid_body body;
  tp_status status = tp_rigid_body_init(&body, g->problem, statics->towards, g->message);
  if (status != TP_OK) return status;
  tp_tilt_case found = {.towards = statics->towards};
  tp_tilt_engines engines;
  tp_tilting tilting = {.body = &body,
                        .settings = &g->settings,
                        .options = &g->runs,
                        .shaking = &g->shaking->motion,
                        .own = &found,
                        .message = g->message};
  own->towards = statics->towards;
  set_static(own, statics, &body, g);
  own->points = calloc(g->options->count, sizeof *own->points);
  if (own->points == NULL) status = tp_fail_memory(g->message, "the spectrum");
  if (status == TP_OK) {
    status =
        tp_tilt_dynamics_of(&tilting.engine, &engines, &g->settings, &body, g->place, g->message);
  }
  if (status == TP_OK) status = find_points(own, &tilting, g, before, all);
  tp_rigid_body_clear(&body);
  return status;
}

/* ---- the scene ---------------------------------------------------------------------------------
 */

static tp_status find_all(tp_overturning_spectrum *spectrum, stage *g, const tp_solution *statics,
                          tp_overturning_options *own) {
  const double begun = scene_frequency(g->shaking);
  static const double wide = 8;
  if (own->from == 0 && own->to == 0) {
    own->from = begun / wide;
    own->to = begun * wide;
  }
  const bool level = g->settings.release_deg == 0;
  spectrum->of_record = g->shaking->axes[TP_SHAKING_HORIZONTAL].form == TP_SHAKING_RECORD;
  const size_t count = level && statics->case_count > 1 ? 1 : statics->case_count;
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    spectrum->case_count++;
    status =
        find_case(spectrum->cases + k, statics->cases + k, g, k * own->count, count * own->count);
  }
  return status;
}

static tp_status find(tp_overturning_spectrum *spectrum, const tp_scene *scene,
                      tp_overturning_options *own, tp_solution *statics, tp_message *message) {
  const tp_solve_options solve = {.size = sizeof solve,
                                  .limit = true,
                                  .digits = 9,
                                  .level = TP_LEVEL_EXACT,
                                  .pivots = TP_PIVOTS_GOVERNING};
  tp_problem problem;
  tp_base_shaking shaking = {.motion = {NULL, NULL, NULL}};
  tp_status status = tp_problem_init(&problem, scene, &solve, statics, message);
  if (status != TP_OK) return status;
  status = tp_base_shaking_init(&shaking, scene, message);
  if (status == TP_OK) status = tp_solve_problem(statics, &problem, &solve, message);
  stage g = {.options = own,
             .problem = &problem,
             .shaking = &shaking,
             .settings = tp_tilt_settings_of(scene, problem.scene),
             .runs = {.size = sizeof g.runs, .stop = own->stop, .context = own->context},
             .place = scene->shaking_place,
             .message = message};
  if (status == TP_OK) status = find_all(spectrum, &g, statics, own);
  tp_base_shaking_clear(&shaking);
  tp_problem_clear(&problem);
  return status;
}

tp_status tp_overturning_spectrum_init(tp_overturning_spectrum *spectrum, const tp_scene *scene,
                                       const tp_overturning_options *options, tp_message *message) {
  tp_overturning_options own = *options;
  tp_solution *statics = tp_solution_new();
  memset(spectrum, 0, sizeof *spectrum);
  if (statics == NULL) return tp_fail_memory(message, "the solution");
  const tp_status status = find(spectrum, scene, &own, statics, message);
  tp_solution_free(statics);
  if (status != TP_OK) tp_overturning_spectrum_clear(spectrum);
  return status;
}

void tp_overturning_spectrum_clear(tp_overturning_spectrum *spectrum) {
  for (size_t k = 0; k < spectrum->case_count; k++) free(spectrum->cases[k].points);
  memset(spectrum, 0, sizeof *spectrum);
}
