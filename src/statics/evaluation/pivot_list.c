/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The list of a case's pivots, in the order of the contact: those asked for from the beginning,
 * others found by their places, told apart in doubles first. */

#include "evaluation/pivot_list.h"

#include "evaluation/certainty.h"
#include "load/roots.h"
#include "problem/bearing.h"
#include "problem/drawn.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

bool tp_pivots_list_all(tp_pivots_listed asked, size_t count) {
  return asked == TP_PIVOTS_ALL || (asked == TP_PIVOTS_BY_COUNT && count <= TP_PIVOTS_MANY);
}

/* Admissible, or near the toe; a rounded corner's axis lies elsewhere than its point. */
bool tp_pivots_list_from_start(const tp_case *own, const tp_problem *problem,
                               tp_pivots_listed asked, size_t point) {
  if (tp_pivots_list_all(asked, own->candidate_count)) return true;
  const bool left = own->towards == TP_TOWARDS_LEFT;
  const size_t from_toe = left ? point : own->candidate_count - 1 - point;
  return problem->admissible[own->towards][point] || problem->contact.points[point].cut != NULL ||
         from_toe < TP_PIVOTS_NEAR_TOE;
}

static void describe(tp_pivot *pivot, const tp_problem *problem, size_t point) {
  const tp_contact_point *p = problem->contact.points + point;
  *pivot = (tp_pivot){.index = point, .kind = p->kind};
  tp_result_lattice_point(&pivot->x_m, &pivot->y_m, problem, p->point);
}

/* Room for the tilts of each, under loads. */
static bool make_room(tp_case *own, const tp_problem *problem, size_t count) {
  tp_pivot *pivots = realloc(own->pivots, (count + 1) * sizeof *pivots);
  if (pivots == NULL) return false;
  own->pivots = pivots;
  if (!problem->loaded) return true;
  tp_bounded *limits = realloc(own->limits, (count + 1) * TP_ROOTS_MAX * sizeof *limits);
  if (limits != NULL) own->limits = limits;
  return limits != NULL;
}

static void share_out_limits(tp_case *own, const tp_problem *problem) {
  for (size_t k = 0; k < own->pivot_count && problem->loaded; k++) {
    own->pivots[k].limits_deg = own->limits + k * TP_ROOTS_MAX;
  }
}

bool tp_pivots_list(tp_case *own, const tp_problem *problem, tp_pivots_listed asked) {
  own->candidate_count = (size_t)problem->contact.point_count;
  size_t count = 0;
  for (size_t k = 0; k < own->candidate_count; k++) {
    count += tp_pivots_list_from_start(own, problem, asked, k);
  }
  if (!make_room(own, problem, count)) return false;
  for (size_t k = 0; k < own->candidate_count; k++) {
    if (!tp_pivots_list_from_start(own, problem, asked, k)) continue;
    describe(own->pivots + own->pivot_count++, problem, k);
  }
  share_out_limits(own, problem);
  return true;
}

size_t tp_pivots_place(const tp_case *own, size_t point) {
  size_t low = 0, high = own->pivot_count;
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (own->pivots[middle].index < point) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

static bool insert(tp_case *own, const tp_problem *problem, const tp_pivot *pivot, size_t at) {
  if (!make_room(own, problem, own->pivot_count + 1)) return false;
  const size_t behind = own->pivot_count - at;
  memmove(own->pivots + at + 1, own->pivots + at, behind * sizeof *own->pivots);
  if (problem->loaded) {
    tp_bounded *limits = own->limits + at * TP_ROOTS_MAX;
    memmove(limits + TP_ROOTS_MAX, limits, behind * TP_ROOTS_MAX * sizeof *limits);
  }
  own->pivots[at] = *pivot;
  own->pivot_count++;
  if (own->has_toppling_pivot && own->toppling_pivot >= at) own->toppling_pivot++;
  share_out_limits(own, problem);
  return true;
}

/* Places that are printed as those of a pivot, if one is there. */
enum { MOST_SPOTS = 4 };
typedef struct spots {
  int count;
  tp_bounded x_m[MOST_SPOTS], y_m[MOST_SPOTS];
} spots;

static void add_spot(spots *s, bool given, tp_bounded x_m, tp_bounded y_m) {
  if (!given) return;
  s->x_m[s->count] = x_m;
  s->y_m[s->count++] = y_m;
}

static spots centres_of(const tp_case *own) {
  const tp_limit *limits[] = {&own->limit, &own->limit_otherwise, &own->limit_holds_from};
  spots s = {0};
  for (int k = 0; k < 3; k++) {
    add_spot(&s, limits[k]->has_centre, limits[k]->centre_x_m, limits[k]->centre_y_m);
  }
  add_spot(&s, own->onset.has_centre, own->onset.centre_x_m, own->onset.centre_y_m);
  return s;
}

static bool meet(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

static bool is_centre(const spots *s, const tp_pivot *pivot) {
  for (int k = 0; k < s->count; k++) {
    if (meet(s->x_m[k], pivot->x_m) && meet(s->y_m[k], pivot->y_m)) return true;
  }
  return false;
}

/* By x in doubles, before any place is computed: most points lie far from all that is sought. */
static bool may_meet(double x_m, double slack, tp_bounded at) {
  return !(fabs(x_m - at.value) > at.error + slack);
}

static bool may_be_sought(const tp_case *own, const spots *s, double x_m, double slack) {
  for (size_t k = 0; k < own->limit.reaction_count; k++) {
    if (may_meet(x_m, slack, own->limit.reactions[k].x_m)) return true;
  }
  for (int k = 0; k < s->count; k++) {
    if (may_meet(x_m, slack, s->x_m[k])) return true;
  }
  return false;
}

bool tp_pivots_list_more(tp_case *own, const tp_problem *problem) {
  if (own->pivot_count == own->candidate_count) return true;
  const tp_lattice *l = &problem->lattice;
  const double step = fmpq_get_d(l->step_m), origin = fmpz_get_d(l->origin_x);
  const bool drawn = tp_drawn_is_same(problem); /* else places are not those of the lattice */
  const spots centres = centres_of(own);
  for (size_t k = 0; k < own->candidate_count; k++) {
    const double x = ldexp(l->u[problem->contact.points[k].point], (int)l->exponent_u);
    const double slack = 1e-14 * step * (fabs(origin) + fabs(x)) + DBL_MIN; /* some roundings */
    if (drawn && !may_be_sought(own, &centres, step * (origin + x), slack)) continue;
    const size_t at = tp_pivots_place(own, k);
    if (at < own->pivot_count && own->pivots[at].index == k) continue;
    tp_pivot pivot;
    describe(&pivot, problem, k);
    if (!tp_pivot_bears(&pivot, &own->limit) && !is_centre(&centres, &pivot)) continue;
    if (!insert(own, problem, &pivot, at)) return false;
  }
  return true;
}
