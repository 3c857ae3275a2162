/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A step or a bench at the toe stops a block that friction alone would not hold: its factor is then
 * that of toppling over the step, 3.6 where the block on its base without the step has 1.3. The
 * step is often thin, weathered or excavated later, so the user sees both.
 *
 * On a profile the ground in front of the toe is the part of it that belongs to the first facets of
 * the contact, as far as these rise against the motion by more than 45 degrees from the mean plane;
 * the profile is cut off where they end. On a mated base it is what extends past the sole. */

#include "stability/front_ground.h"

#include "common/notes.h"
#include "problem/drawn.h"
#include "stability/solution.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Results that differ by less than this share are alike. */
static const double alike = 0.01;

/* ---- the ground in front -----------------------------------------------------------------------
 */

/* Does the facet rise against a motion to the left, or to the right, by more than 45 degrees? */
static bool stands_in_front(const tp_problem *problem, const tp_facet *f, bool left) {
  const tp_lattice *l = &problem->lattice;
  fmpz_t run, rise;
  fmpz_init(run);
  fmpz_init(rise);
  fmpz_sub(run, l->x + f->t1, l->x + f->t0);
  fmpz_sub(rise, l->y + f->t1, l->y + f->t0);
  if (left) fmpz_neg(rise, rise);
  const bool stands = f->t0 != f->t1 && fmpz_sgn(rise) > 0 && fmpz_cmp(rise, run) > 0;
  fmpz_clear(run);
  fmpz_clear(rise);
  return stands;
}

/* The points of the profile that are left without that ground: from `*first` on, `*count` of them.
 * False: there is none, or nothing else bears the block. */
static bool find_rest_of_profile(long *first, long *count, const tp_problem *problem, bool left) {
  const tp_contact *contact = &problem->contact;
  const long edges = problem->base.edge_count;
  long edge = -1, k = 0;
  *first = 0;
  *count = problem->scene->base.profile.count;
  if (*count != edges + 1) return false;
  for (; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + (left ? k : contact->facet_count - 1 - k);
    if (f->base_edge < 0 || f->base_edge >= edges || !stands_in_front(problem, f, left)) break;
    edge = f->base_edge;
  }
  if (edge < 0 || k == contact->facet_count) return false;
  if (left) {
    *first = edge + 1;
    *count -= edge + 1;
  } else {
    *count = edge + 1;
  }
  return *count >= 2;
}

/* Where the rest of the profile begins, in the coordinates of the scene. */
static void find_toe(double toe[2], const tp_problem *problem, long point) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_set(x, problem->scene->base.profile.x + point);
  fmpq_set(y, problem->scene->base.profile.y + point);
  tp_drawn_point(x, y, problem);
  toe[0] = fmpq_get_d(x);
  toe[1] = fmpq_get_d(y);
  fmpq_clear(x);
  fmpq_clear(y);
}

/* The scene without that ground; it borrows all that it holds. */
typedef struct without {
  bool found;
  tp_scene scene;
  bool has_toe;
  double toe[2];
} without;

static void cut_profile(without *w, const tp_problem *problem, bool left) {
  long first = 0, count = 0;
  w->found = find_rest_of_profile(&first, &count, problem, left);
  if (!w->found) return;
  tp_polyline *profile = &w->scene.base.profile;
  w->has_toe = true;
  find_toe(w->toe, problem, left ? first : count - 1);
  profile->x += first;
  profile->y += first;
  profile->marks += first;
  profile->count = profile->capacity = count;
  profile->users = NULL;
}

/* Its other kind of base is the less safe one (report/limit.c). */
static bool is_less_safe(const tp_limit *l, const tp_limit *than) {
  if (l->kind == TP_LIMIT_NOWHERE) return than->kind != TP_LIMIT_NOWHERE;
  if (l->kind != TP_LIMIT_AT_ANGLE) return false;
  return than->kind == TP_LIMIT_INTERLOCKED ||
         (than->kind == TP_LIMIT_AT_ANGLE &&
          l->critical_angle_deg.value < than->critical_angle_deg.value);
}

static void end_base(without *w, const tp_case *own) {
  tp_quantity *beyond =
      own->towards == TP_TOWARDS_LEFT ? &w->scene.base.beyond_left : &w->scene.base.beyond_right;
  w->found = own->base_matters && own->limit.base_beyond_toe &&
             is_less_safe(&own->limit_otherwise, &own->limit);
  if (!w->found) return;
  fmpq_init(beyond->value); /* the copy's: 0 */
  beyond->given = true;
}

/* ---- what it holds -----------------------------------------------------------------------------
 */

static bool moves(const tp_case *own) {
  return own->mechanism != TP_STANDS && own->mechanism != TP_INTERLOCKED;
}

static bool is_lower(const tp_case *own, const tp_case *than) {
  const tp_fos *fos = &own->governing_fos.fos, *other = &than->governing_fos.fos;
  if (moves(own) && !moves(than)) return true;
  if (fos->state != TP_FOS_NUMBER) return false;
  return other->state == TP_FOS_NO_OVERTURNING ||
         (other->state == TP_FOS_NUMBER && fos->value.value < (1 - alike) * other->value.value);
}

static tp_status note(tp_solution *solution, const tp_case *own, const char *result,
                      const without *w, const tp_scene *scene, tp_message *message) {
  char where[96] = "";
  if (w->has_toe) {
    snprintf(where, sizeof where, ", which begins at (%.6g, %.6g),", w->toe[0], w->toe[1]);
  }
  return tp_notes_add(&solution->notes, message, TP_CAUTION, scene->base.place,
                      "towards the %s the ground in front of the toe%s holds the block: without it "
                      "%s; make sure that this ground is sound and stays",
                      own->towards == TP_TOWARDS_LEFT ? "left" : "right", where, result);
}

static tp_status compare(tp_solution *solution, size_t k, const tp_solution *other,
                         const without *w, const tp_scene *scene, tp_message *message) {
  const tp_case *own = solution->cases + k, *free = other->cases + k;
  char n[2][TP_NUMBER_SIZE], result[160];
  if (k >= other->case_count || free->towards != own->towards || !is_lower(free, own)) return TP_OK;
  if (own->governing_fos.fos.state == TP_FOS_NO_TILT) return TP_OK;
  snprintf(result, sizeof result, "the factor of safety is %s, and not %s",
           tp_caution_fos(n[0], free), tp_caution_fos(n[1], own));
  return note(solution, own, result, w, scene, message);
}

static tp_status check(tp_solution *solution, size_t k, const tp_scene *scene,
                       const tp_problem *problem, const tp_solve_options *options,
                       tp_half_tolerance_solve *solve, tp_message *message) {
  const tp_case *own = solution->cases + k;
  without w = {.scene = *scene};
  w.scene.base.all_poses = false;
  if (scene->base.mated) {
    end_base(&w, own);
  } else {
    cut_profile(&w, problem, own->towards == TP_TOWARDS_LEFT);
  }
  if (!w.found) return TP_OK;
  tp_solution *other = NULL;
  tp_message why = {.text = ""};
  tp_status status = solve(&other, &w.scene, options, &why);
  if (status == TP_OK) {
    status = compare(solution, k, other, &w, scene, message);
    tp_solution_free(other);
  } else if (status == TP_OUT_OF_MEMORY) {
    if (message != NULL) *message = why;
  } else {
    status = note(solution, own, "the block does not rest on its base", &w, scene, message);
  }
  return status;
}

static bool is_asked(const tp_solution *solution, const tp_scene *scene) {
  if (!solution->has_tilt_angle || !solution->has_friction) return false;
  if (!scene->base.mated) return solution->contact.steep && scene->base.profile.count > 2;
  bool matters = false;
  for (size_t k = 0; k < solution->case_count; k++) {
    matters = matters || solution->cases[k].base_matters;
  }
  return matters;
}

tp_status tp_front_ground_check(tp_solution *solution, const tp_scene *scene,
                                const tp_solve_options *options, tp_half_tolerance_solve *solve,
                                tp_message *message) {
  if (!is_asked(solution, scene)) return TP_OK;
  tp_solution *described = tp_solution_new();
  tp_problem problem;
  if (described == NULL) return tp_fail_memory(message, "the ground in front of the toe");
  tp_status status = tp_problem_init(&problem, scene, options, described, message);
  if (status == TP_OK) {
    for (size_t k = 0; k < solution->case_count && status == TP_OK; k++) {
      status = check(solution, k, scene, &problem, options, solve, message);
    }
    tp_problem_clear(&problem);
  }
  tp_solution_free(described);
  return status;
}
