/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A second solve, without the earthquake; of each direction the more severe case stays
 * (verdict/safety.h). */

#include "stability/static_state.h"

#include "common/notes.h"
#include "stability/governing.h"

#include <math.h>
#include <stdlib.h>

static bool acts(const tp_quantity *share) {
  return share->given && !fmpq_is_zero(share->value);
}

bool tp_static_state_exists(const tp_scene *scene) {
  return acts(&scene->loads.horizontal) || acts(&scene->loads.vertical);
}

bool tp_static_state_counts(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  const bool down_dip = tp_scene_lies_in_place(scene)
                            ? loads->direction_given && loads->direction == TP_SEISMIC_DOWN_DIP
                            : true;
  const bool held = loads->anchor_count > 0 || loads->support_count > 0 ||
                    loads->pressure_count > 0 || acts(&loads->water.ice_kpa) ||
                    (tp_water_is_sited(&loads->water) && loads->water.faces != TP_WATER_BEHIND);
  if (!tp_static_state_exists(scene)) return false;
  return held || !down_dip || acts(&loads->vertical) || fmpq_sgn(loads->horizontal.value) < 0;
}

/* ---- a block that its weight alone drives ------------------------------------------------------
 */

/* A facet that dips up-dip as the block lies, its side to the left or to the right down-dip. */
static bool dips_up_dip(const tp_lattice *l, const tp_facet *f, bool left, double tilt_tangent) {
  static const double nearly = 1 - 1e-9;
  fmpz_t run, rise;
  fmpz_init(run);
  fmpz_init(rise);
  fmpz_sub(run, l->x + f->t1, l->x + f->t0);
  fmpz_sub(rise, l->y + f->t1, l->y + f->t0);
  const double over = fmpz_get_d(run), up = left ? fmpz_get_d(rise) : -fmpz_get_d(rise);
  fmpz_clear(run);
  fmpz_clear(rise);
  return !(up >= -tilt_tangent * nearly * over);
}

/* Without an earthquake of k the tilts at which a motion can begin are greater by arctan k, where
 * weights alone act. A margin allows for cohesion. */
static bool may_move_up_dip(const tp_case *shaken, double tilt_deg, double horizontal) {
  static const double margin_deg = 2, degrees = 57.29577951308232;
  const tp_onset *onset = &shaken->onset;
  if (onset->kind == TP_ONSET_NOT_ASKED || onset->window_count == 0) return true;
  const tp_window *lowest = onset->windows;
  if (!lowest->from_below) return onset->window_count > 1;
  return onset->window_count > 2 || lowest->to_above ||
         !(lowest->to_deg.value + atan(horizontal) * degrees + margin_deg < tilt_deg);
}

/* ---- a motion that the earthquake works against ------------------------------------------------
 */

/* A velocity with the centroid going down by 1 and u along the horizontal to the down-dip side, and
 * a turn: how far the bounds on u of all contacts are from leaving one that is not above 0. */
static double gap_at(const tp_contact_row *rows, long count, double sine, double cosine,
                     double turn) {
  double least = -INFINITY, most = 0, gap = -INFINITY;
  for (long k = 0; k < count; k++) {
    const tp_contact_row *r = rows + k;
    const double along = r->ny * sine - r->nx * cosine, up = r->nx * sine + r->ny * cosine;
    const double rest = up - turn * (r->ny * r->x - r->nx * r->y);
    if (along > 0)
      least = fmax(least, rest / along);
    else if (along < 0)
      most = fmin(most, rest / along);
    else
      gap = fmax(gap, rest);
  }
  return fmax(gap, least - most);
}

/* The gap is convex in the turn, so that it falls and rises once as that goes from one infinity to
 * the other. */
bool tp_may_move_against(const tp_contact_row *rows, long count, double tilt_tangent) {
  enum { STEPS = 60 };
  static const double right = 1.5707, little = 1e-6, golden = 0.6180339887498949;
  const double cosine = 1 / hypot(1, tilt_tangent), sine = tilt_tangent * cosine;
  double size = 0, low = -right, high = right;
  for (long k = 0; k < count; k++) size = fmax(size, hypot(rows[k].x, rows[k].y));
  if (!(size > 0)) return true;
  double one = high - golden * (high - low), other = low + golden * (high - low);
  double at_one = gap_at(rows, count, sine, cosine, tan(one) / size);
  double at_other = gap_at(rows, count, sine, cosine, tan(other) / size);
  for (int k = 0; k < STEPS && fmin(at_one, at_other) > little; k++) {
    if (at_one < at_other) {
      high = other;
      other = one;
      at_other = at_one;
      one = high - golden * (high - low);
      at_one = gap_at(rows, count, sine, cosine, tan(one) / size);
    } else {
      low = one;
      one = other;
      at_one = at_other;
      other = low + golden * (high - low);
      at_other = gap_at(rows, count, sine, cosine, tan(other) / size);
    }
  }
  return !(fmin(at_one, at_other) > little);
}

static double metres_between(const tp_lattice *l, const fmpz_t at, bool is_y, double from) {
  fmpq_t metres;
  fmpq_init(metres);
  if (is_y)
    tp_lattice_metres_y(metres, l, at);
  else
    tp_lattice_metres_x(metres, l, at);
  const double length = fmpq_get_d(metres) - from;
  fmpq_clear(metres);
  return length;
}

/* From the centroid, the down-dip side to the left. */
static tp_contact_row row_of(const tp_problem *problem, const tp_solution *solution, long point,
                             const double normal[2], bool left) {
  const tp_lattice *l = &problem->lattice;
  const double x = metres_between(l, l->x + point, false, solution->block.centroid_x_m.value);
  const double y = metres_between(l, l->y + point, true, solution->block.centroid_y_m.value);
  return (tp_contact_row){left ? x : -x, y, left ? normal[0] : -normal[0], normal[1]};
}

/* Of a block whose coordinates are those of its frame. */
static bool may_move_against(const tp_problem *problem, const tp_solution *solution, bool left,
                             double tangent) {
  const tp_placement *placed = &problem->placement;
  const tp_contact *contact = &problem->contact;
  const bool is_turned = placed->world != NULL && !placed->world->unturned;
  if (is_turned || placed->rested != NULL || placed->jointed != NULL) return true;
  tp_contact_row *rows = calloc(2 * (size_t)contact->facet_count + 1, sizeof *rows);
  if (rows == NULL) return true;
  long count = 0;
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    const tp_lattice *l = &problem->lattice;
    const double run =
        metres_between(l, l->x + f->t1, false, 0) - metres_between(l, l->x + f->t0, false, 0);
    const double rise =
        metres_between(l, l->y + f->t1, true, 0) - metres_between(l, l->y + f->t0, true, 0);
    const double length = hypot(run, rise), normal[2] = {-rise / length, run / length};
    if (!(length > 0)) continue; /* it restrains nothing */
    rows[count++] = row_of(problem, solution, f->q0, normal, left);
    rows[count++] = row_of(problem, solution, f->q1, normal, left);
  }
  const bool may = tp_may_move_against(rows, count, tangent);
  free(rows);
  return may;
}

bool tp_static_state_may_govern(const tp_problem *problem, const tp_solution *solution) {
  const tp_scene *scene = problem->scene;
  if (!tp_static_state_exists(scene) || !solution->has_tilt_angle) return false;
  const double tilt_deg = solution->tilt_angle_deg.value;
  const double tangent = tan(tilt_deg / 57.29577951308232);
  const double horizontal = fmpq_get_d(scene->loads.horizontal.value);
  for (size_t k = 0; k < solution->case_count; k++) {
    const tp_case *own = solution->cases + k;
    if (may_move_up_dip(own, tilt_deg, horizontal)) return true;
    if (may_move_against(problem, solution, own->towards == TP_TOWARDS_LEFT, tangent)) return true;
    for (long j = 0; j < problem->contact.facet_count; j++) {
      if (dips_up_dip(&problem->lattice, problem->contact.facets + j,
                      own->towards == TP_TOWARDS_LEFT, tangent)) {
        return true;
      }
    }
  }
  return false;
}

/* ---- with and without --------------------------------------------------------------------------
 */

/* The scene without its earthquake, sharing all else. */
static void still(tp_scene *at_rest, const tp_scene *scene) {
  *at_rest = *scene;
  fmpq_init(at_rest->loads.horizontal.value); /* zeros, which own nothing */
  fmpq_init(at_rest->loads.vertical.value);
  at_rest->loads.horizontal.given = at_rest->loads.vertical.given = false;
  at_rest->loads.direction_given = false;
}

/* A case in which a motion can begin fails already. */
static bool may_give_way(const tp_case *shaken) {
  return tp_case_safety(shaken).verdict >= TP_VERDICT_OPEN;
}

static tp_status note(tp_solution *solution, const tp_scene *scene, tp_direction towards,
                      tp_message *message) {
  return tp_notes_add(
      &solution->notes, message, TP_CAUTION, scene->loads.seismic_place,
      "towards the %s the state without the earthquake governs: it is the less safe "
      "one, and the results are those without the earthquake",
      towards == TP_TOWARDS_LEFT ? "left" : "right");
}

/* In place of a case, or, where a block at rest goes the other way, which the whole solution is of,
 * of that. */
static tp_status take(tp_solution **solution, tp_solution **at_rest, size_t k,
                      const tp_scene *scene, tp_message *message) {
  const tp_direction towards = (*at_rest)->cases[k].towards;
  if ((*solution)->cases[k].towards != towards) {
    tp_solution *shaken = *solution;
    *solution = *at_rest;
    *at_rest = shaken;
  } else {
    const tp_case shaken = (*solution)->cases[k];
    (*solution)->cases[k] = (*at_rest)->cases[k];
    (*at_rest)->cases[k] = shaken;
  }
  return note(*solution, scene, towards, message);
}

tp_status tp_static_state_join(tp_solution **solution, const tp_scene *scene,
                               const tp_solve_options *options, tp_static_state_solve *solve,
                               tp_message *message) {
  const size_t count = (*solution)->case_count;
  tp_scene at_rest;
  tp_solution *other = NULL;
  bool any = false;
  for (size_t k = 0; (*solution)->has_tilt_angle && k < count; k++)
    any = any || may_give_way((*solution)->cases + k);
  if (!any) return TP_OK;
  still(&at_rest, scene);
  tp_status status = solve(&other, &at_rest, options, message);
  for (size_t k = 0; status == TP_OK && k < count && k < other->case_count; k++) {
    const tp_case *shaken = (*solution)->cases + k, *resting = other->cases + k;
    const tp_safety of_shaken = tp_case_safety(shaken), of_resting = tp_case_safety(resting);
    if (!may_give_way(shaken) || (count > 1 && shaken->towards != resting->towards)) continue;
    const bool rests = tp_safety_compare(&of_resting, &of_shaken) < 0;
    if (rests) status = take(solution, &other, k, scene, message);
    tp_case_add_state((*solution)->cases + k, rests ? &of_shaken : &of_resting);
  }
  tp_solution_free(other);
  return status;
}
