/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* For a direction the force is the least at which, doubled from a small one on, the result reaches
 * the wanted value, narrowed by Brent's method (number/root.h). Of forces at every 5 degrees the
 * least has its neighbours beside it, and the direction is narrowed between these by Brent's
 * minimiser (number/minimum.h) to 1e-5 degrees, then rounded to 1e-4, so that it is printed as it
 * is. All of that is in doubles and proves nothing. A result that is unbounded is above any value.
 * A direction along which the scene has no answer, as a bolt that would not reach the rock, is
 * none. */

#include "back_analysis/find_least.h"

#include "number/minimum.h"
#include "number/root.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { STEP_DEG = 5, DOUBLINGS = 20, ROOT_SAMPLES = 60, MINIMUM_STEPS = 60 };

static const double unbounded = 1e6, no_force = 1e300;

typedef struct least {
  tp_search *search;
  double direction, first; /* the least force that is tried */
} least;

/* The result less the wanted one; false where the scene has none. */
static bool gap_at(double *gap, void *context, double force) {
  least *l = context;
  tp_search *s = l->search;
  tp_solution *solution = NULL;
  const double values[2] = {force, l->direction};
  const tp_status status = tp_varied_solve(&solution, &s->varied, values, &s->why);
  bool known = false;
  if (status == TP_OK && solution->case_count > 0) {
    tp_bounded value;
    known = tp_search_value(&value, solution->cases, s->options->target);
    *gap = value.value - s->options->value;
    if (!known && solution->cases[0].governing_fos.fos.state == TP_FOS_NO_OVERTURNING) {
      *gap = unbounded;
      known = true;
    }
  }
  if (status == TP_OUT_OF_MEMORY || status == TP_SYSTEM_FAILED) {
    s->status = tp_fail(s->message, status, (tp_place){0}, "%s", s->why.text);
  }
  tp_solution_free(solution);
  return known && s->status == TP_OK;
}

/* The force along a direction; no_force where none does. */
static double needed(double direction, void *context) {
  least *l = context;
  l->direction = direction;
  tp_root_end low = {0, 0}, high = {l->first, 0};
  if (l->search->status != TP_OK || !gap_at(&low.value, l, 0)) return no_force;
  if (low.value >= 0) return 0;
  for (int k = 0; k < DOUBLINGS; k++) {
    if (!gap_at(&high.value, l, high.x)) return no_force;
    if (high.value >= 0) break;
    low = high;
    high.x *= 2;
  }
  tp_root root;
  const tp_root_search search = {gap_at, l, 0, high.x * 1e-10, ROOT_SAMPLES};
  return high.value >= 0 && tp_root_find(&root, &search, low, high) ? root.high : no_force;
}

/* Both keys are of one anchor: the lengths of their beginnings are the same. */
static bool are_of_one(const tp_find_options *o) {
  const char *force = strrchr(o->key, '.'), *way = strrchr(o->least_over, '.');
  if (force == NULL || way == NULL || strcmp(force, ".force_kn") != 0) return false;
  if (strcmp(way, ".dip_deg") != 0 && strcmp(way, ".direction_deg") != 0) return false;
  const size_t length = (size_t)(force - o->key);
  return length == (size_t)(way - o->least_over) && strncmp(o->key, o->least_over, length) == 0 &&
         strncmp(o->key, "loads.anchors.", strlen("loads.anchors.")) == 0;
}

static tp_status check(const tp_search *s) {
  const tp_find_options *o = s->options;
  const tp_place place = {s->varied.scene->path, 0, 0};
  if (!are_of_one(o)) {
    return tp_refuse(s->message, TP_FAULT_ARGUMENT, place,
                     "the least force is that of one anchor or bolt over its direction: find "
                     "loads.anchors.N.force_kn, of a scene that gives it 'dip_deg' or "
                     "'direction_deg'");
  }
  const tp_find_target t = o->target;
  if (t == TP_FIND_GOVERNING_FOS || t == TP_FIND_FOS || t == TP_FIND_SLIDING_FOS ||
      t == TP_FIND_LIMIT_FOS) {
    return TP_OK;
  }
  return tp_refuse(s->message, TP_FAULT_ARGUMENT, place,
                   "the least force is found for a factor of safety, as governing_fos=1.3");
}

static double round_direction(double degrees) {
  const double parts = 1e4;
  return round(degrees * parts) / parts;
}

tp_status tp_search_least(double *direction_deg, double *force_kn, tp_search *s) {
  tp_status status = check(s);
  if (status == TP_OK) {
    status =
        tp_scene_key_find(s->varied.keys + 1, s->varied.scene, s->options->least_over, s->message);
  }
  if (status != TP_OK) return status;
  const bool dips = strstr(s->options->least_over, ".dip_deg") != NULL;
  const int low = dips ? -90 : -180, high = dips ? 90 : 180;
  const double small = 0x1p-6, own = s->own > 0 ? s->own : 1;
  least l = {.search = s, .first = own * small};
  s->varied.count = 2;
  double values[360 / STEP_DEG + 1];
  const int count = (high - low) / STEP_DEG + 1;
  int best = 0;
  for (int k = 0; k < count; k++) {
    values[k] = needed(low + STEP_DEG * k, &l);
    if (values[k] < values[best]) best = k;
  }
  tp_minimum m = {.x = low + STEP_DEG * best, .value = values[best]};
  m.low = m.x - STEP_DEG;
  m.high = m.x + STEP_DEG;
  m.low_value = best > 0 ? values[best - 1] : no_force;
  m.high_value = best + 1 < count ? values[best + 1] : no_force;
  const bool inside = !dips || (best > 0 && best + 1 < count);
  if (m.value < no_force && m.value > 0 && inside) {
    (void)tp_minimum_narrow(&m, needed, &l, 1e-5, MINIMUM_STEPS);
  }
  s->varied.count = 1;
  if (s->status != TP_OK) return s->status;
  if (!(m.value < no_force)) {
    return tp_fail(s->message, TP_NO_ANSWER, (tp_place){s->varied.scene->path, 0, 0},
                   "no force along any direction that was tried gives %s = %.15g",
                   tp_find_target_name(s->options->target), s->options->value);
  }
  if (!(m.value > 0)) {
    return tp_fail(s->message, TP_NO_ANSWER, (tp_place){s->varied.scene->path, 0, 0},
                   "the block has %s = %.15g or more without this force",
                   tp_find_target_name(s->options->target), s->options->value);
  }
  *direction_deg = round_direction(m.x);
  *force_kn = m.value;
  return TP_OK;
}
