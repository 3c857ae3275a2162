/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Directions along each symbol and at random, steps that grow by a quarter, bisection of the
 * crossing, and a certified solve on both sides. */

#include "derive/checks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  MOST_VERTICES = 2000, /* so that a solve on each side is quick */
  MOST_TERMS = 100000,  /* of all conditions: likewise a look at them */
  DRAWN = 24            /* directions at random */
};

/* A number goes by 1 % first and then in 26 steps to e^3.3, some 27 times itself. */
enum { STEPS = 26 };
static const double first_step = 0.01, growth = 1.25;
static const double resolution = 1e-5; /* of a crossing, in logarithms of the numbers */
static const double margin = 1e-3;     /* from it, on either side */

void tp_checks_free(tp_derived_checks *checks) {
  for (size_t k = 0; k < checks->count; k++) {
    free(checks->items[k].inside);
    free(checks->items[k].outside);
  }
  free(checks->items);
}

/* What a run shares. */
typedef struct running {
  tp_walk walk;
  tp_derived_checks *out;
  bool *met; /* by condition */
  long left; /* conditions that are not */
  tp_walk_point inside, outside;
  tp_message *message;
} running;

/* Does a condition fail at the distance, or a number leave its range? */
static bool fails_at(running *r, const tp_walk_direction *direction, double distance) {
  return !tp_walk_go(&r->outside, &r->walk, direction, distance) ||
         tp_walk_fails(&r->walk, &r->outside, 0) >= 0;
}

/* The distance of the first crossing, within the resolution; none: 0. By halving: whether all
 * conditions hold is a yes or a no. */
static double find_crossing(running *r, const tp_walk_direction *direction) {
  double near = 0, far = first_step;
  for (int k = 0; !fails_at(r, direction, far); k++) {
    if (k == STEPS) return 0;
    near = far;
    far *= growth;
  }
  while (far - near > resolution) {
    const double middle = 0.5 * (near + far);
    *(fails_at(r, direction, middle) ? &far : &near) = middle;
  }
  return far;
}

/* Places just inside, where all hold, and just outside, where one does not; false where there are
 * none. */
static bool find_sides(running *r, const tp_walk_direction *direction, double crossing) {
  const double in = crossing > 2 * margin ? crossing - margin : 0.5 * crossing;
  return tp_walk_go(&r->inside, &r->walk, direction, in) && tp_walk_holds(&r->walk, &r->inside) &&
         tp_walk_go(&r->outside, &r->walk, direction, crossing + margin) &&
         tp_walk_fails(&r->walk, &r->outside, 0) >= 0;
}

/* Is one of those that fail outside not met yet? */
static bool is_new(const running *r) {
  long k = tp_walk_fails(&r->walk, &r->outside, 0);
  while (k >= 0 && r->met[k]) k = tp_walk_fails(&r->walk, &r->outside, k + 1);
  return k >= 0;
}

static tp_status keep(running *r, tp_check_verdict beyond) {
  for (long k = tp_walk_fails(&r->walk, &r->outside, 0); k >= 0;
       k = tp_walk_fails(&r->walk, &r->outside, k + 1)) {
    if (r->met[k]) continue;
    tp_derived_check *own = r->out->items + r->out->count++;
    own->condition = (size_t)k;
    own->beyond = beyond;
    own->inside = tp_walk_write(&r->walk, &r->inside);
    own->outside = tp_walk_write(&r->walk, &r->outside);
    if (own->inside == NULL || own->outside == NULL) {
      return tp_fail_memory(r->message, "the checks");
    }
    r->met[k] = true;
    r->left--;
  }
  return TP_OK;
}

static tp_status refute(const running *r) {
  const tp_scene *scene = r->walk.formula->model->problem.scene;
  char *inside = tp_walk_write(&r->walk, &r->inside);
  const tp_status status = tp_fail(
      r->message, TP_UNDECIDED, (tp_place){scene->path, 0, 0},
      "the formula of the %s and the solver differ at %s, where its conditions hold; please "
      "report this with the scene",
      r->walk.formula->onset ? "onset" : "limit", inside != NULL ? inside : "some values");
  free(inside);
  return status;
}

/* Where the scene has another contact inside, or no answer, nothing is checked. */
static tp_status check_sides(running *r) {
  tp_check_verdict inside, beyond;
  tp_status status = tp_walk_solve(&inside, &r->walk, &r->inside, r->message);
  if (status != TP_OK) return status;
  if (inside == TP_CHECK_OTHER || inside == TP_CHECK_NONE) return refute(r);
  if (inside != TP_CHECK_SAME) return TP_OK;
  status = tp_walk_solve(&beyond, &r->walk, &r->outside, r->message);
  return status == TP_OK ? keep(r, beyond) : status;
}

static tp_status follow(running *r, const tp_walk_direction *direction) {
  const double crossing = find_crossing(r, direction);
  if (crossing == 0 || !find_sides(r, direction, crossing) || !is_new(r)) return TP_OK;
  return check_sides(r);
}

/* Numbers between -1 and 1 by a linear congruence, the same on every machine. */
static double draw(unsigned *state) {
  *state = *state * 1664525U + 1013904223U;
  return (double)(*state >> 8) / 8388608.0 - 1;
}

static tp_status follow_all(running *r) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < r->walk.count && status == TP_OK; k++) {
    for (int sense = 1; sense >= -1 && status == TP_OK && r->left > 0; sense -= 2) {
      tp_walk_direction along = {{0}};
      along.of[k] = sense;
      status = follow(r, &along);
    }
  }
  unsigned state = 1;
  for (int k = 0; k < DRAWN && r->walk.count > 1 && status == TP_OK && r->left > 0; k++) {
    tp_walk_direction drawn = {{0}};
    for (size_t s = 0; s < r->walk.count; s++) drawn.of[s] = draw(&state);
    status = follow(r, &drawn);
  }
  return status;
}

static int by_condition(const void *left, const void *right) {
  const tp_derived_check *a = left, *b = right;
  return (a->condition > b->condition) - (a->condition < b->condition);
}

tp_status tp_checks_run(tp_derived_checks *checks, const tp_checked_formula *formula,
                        tp_message *message) {
  const tp_lattice *lattice = &formula->model->problem.lattice;
  const size_t conditions = (size_t)formula->conditions->count;
  if (conditions == 0 || tp_conditions_length(formula->conditions, 0) > MOST_TERMS ||
      lattice->start[formula->model->problem.section.ring_count] > MOST_VERTICES) {
    return TP_OK;
  }
  running r = {.out = checks, .left = (long)conditions, .message = message};
  tp_status status = tp_walk_init(&r.walk, formula, message);
  if (status != TP_OK) return status;
  tp_walk_point_init(&r.inside, &r.walk);
  tp_walk_point_init(&r.outside, &r.walk);
  r.met = calloc(conditions, sizeof *r.met);
  checks->items = calloc(conditions, sizeof *checks->items);
  if (r.met != NULL && checks->items != NULL) {
    checks->run = true;
    status = follow_all(&r);
    qsort(checks->items, checks->count, sizeof *checks->items, by_condition);
  } else {
    status = tp_fail_memory(message, "the checks");
  }
  free(r.met);
  tp_walk_point_clear(&r.inside, &r.walk);
  tp_walk_point_clear(&r.outside, &r.walk);
  return status;
}
