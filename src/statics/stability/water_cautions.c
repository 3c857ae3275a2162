/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Faces and uplift that a scene leaves open, water below the joint and above the top, pressures
 * that stay those at the scene's tilt (docs/loads.md, water as a site has it). */

#include "stability/water_cautions.h"

#include "problem/drawn.h"
#include "stability/earthquakes.h"

#include <math.h>
#include <stdio.h>

/* What is taken where the scene leaves it open. */
static tp_status note_open(tp_notes *notes, const tp_water_description *water,
                           tp_message *message) {
  const bool in_crack = water->cracked && !water->level.given && water->surface.count == 0;
  tp_status status = TP_OK;
  if (water->faces == TP_WATER_FACES_UNSTATED && !in_crack) {
    status = tp_notes_add(
        notes, message, TP_CAUTION, water->place,
        "the scene does not say which faces the water wets: it is put on those behind the block "
        "alone, where it pushes down-dip, and none in front, which would hold; say 'faces: "
        "behind', "
        "'front' or 'both'");
  }
  if (status != TP_OK || water->shape != TP_WATER_UPLIFT_UNSTATED) return status;
  return tp_notes_add(
      notes, message, TP_CAUTION, water->place,
      "the scene does not say how the water lifts the block: the full pressure of its level is "
      "taken "
      "at both ends of the base joint, as where the toe is blocked; say 'uplift: full', "
      "'triangular' (to nothing at a drained toe) or 'none'");
}

static tp_status note_stand(tp_notes *notes, const tp_wetted *wetted,
                            const tp_water_description *water, tp_message *message) {
  if (wetted->dry) {
    return tp_notes_add(notes, message, TP_NOTE, water->place,
                        "the water stands below the block and its base joint: it does not act");
  }
  if (!wetted->overtops) return TP_OK;
  return tp_notes_add(
      notes, message, TP_NOTE, water->place,
      "the water stands above the top of the block: it presses on the whole face, and down on "
      "the top");
}

/* ---- the joint ---------------------------------------------------------------------------------
 */

/* A wet line from its toe to its heel, in scene lengths of the problem, and the pressures there. */
typedef struct wet_line {
  fmpq_t x[2], y[2];
  double kpa[2];
} wet_line;

static void wet_line_init(wet_line *w) {
  for (int end = 0; end < 2; end++) {
    fmpq_init(w->x[end]);
    fmpq_init(w->y[end]);
    w->kpa[end] = 0;
  }
}

static void wet_line_clear(wet_line *w) {
  for (int end = 0; end < 2; end++) {
    fmpq_clear(w->x[end]);
    fmpq_clear(w->y[end]);
  }
}

/* Of sited water between the outermost contacts; its lines run from the left to the right. */
static void sited_line(wet_line *w, const tp_line_load *line, bool heel_right) {
  const int left = heel_right ? 0 : 1, right = 1 - left;
  fmpq_set(w->x[left], line->x0.value);
  fmpq_set(w->y[left], line->y0.value);
  fmpq_set(w->x[right], line->x1.value);
  fmpq_set(w->y[right], line->y1.value);
  w->kpa[left] = fmpq_get_d(line->first_kpa.value);
  w->kpa[right] = fmpq_get_d(line->last_kpa.value);
}

/* Of a height along the face: from end to end of the joint, at the scene's tilt. */
static void height_line(wet_line *w, const tp_problem *problem, bool heel_right) {
  const tp_scene *scene = problem->scene;
  const tp_water_description *water = &scene->loads.water;
  const double degree = acos(-1) / 180;
  for (int end = 0; end < 2; end++) {
    const int side = (end == 1) == heel_right ? 1 : 0;
    fmpq_div(w->x[end], problem->joint.x + side, scene->metres_per_unit);
    fmpq_div(w->y[end], problem->joint.y + side, scene->metres_per_unit);
  }
  w->kpa[1] = fmpq_get_d(water->unit_weight_kn_m3.value) * fmpq_get_d(water->height.value) *
              fmpq_get_d(scene->metres_per_unit);
  if (scene->tilt_angle_deg.given && !water->stays_level) {
    w->kpa[1] *= cos(fmpq_get_d(scene->tilt_angle_deg.value) * degree);
  }
}

static double length_of(const wet_line *w) {
  return hypot(fmpq_get_d(w->x[1]) - fmpq_get_d(w->x[0]),
               fmpq_get_d(w->y[1]) - fmpq_get_d(w->y[0]));
}

/* The length of open gaps that press; in scene lengths. */
static double gap_length(const tp_wetted *wetted) {
  double length = 0;
  for (long k = wetted->joint.count - wetted->gap_lines; k < wetted->joint.count; k++) {
    const tp_line_load *line = wetted->joint.items + k;
    length += hypot(fmpq_get_d(line->x1.value) - fmpq_get_d(line->x0.value),
                    fmpq_get_d(line->y1.value) - fmpq_get_d(line->y0.value));
  }
  return length;
}

/* In the coordinates of the scene. */
static tp_status note_line(tp_notes *notes, const tp_problem *problem, wet_line *w, double gap,
                           bool left, tp_message *message) {
  const tp_scene *scene = problem->scene;
  const char *unit = scene->length_unit;
  const double length = length_of(w);
  const bool both = scene->towards_left && scene->towards_right;
  char beyond[160] = "";
  for (int end = 0; end < 2; end++) tp_drawn_point(w->x[end], w->y[end], problem);
  if (gap > 0) {
    snprintf(beyond, sizeof beyond,
             "; in the open gap before its outermost contact, %.5g %s long, the water has the full "
             "pressure of its depth",
             gap, unit);
  }
  return tp_notes_add(notes, message, TP_NOTE, scene->loads.water.place,
                      "uplift%s: heel (%.6g, %.6g) %s with %.5g kPa, toe (%.6g, %.6g) %s with %.5g "
                      "kPa, %.5g %s long%s",
                      !both  ? ""
                      : left ? " towards the left"
                             : " towards the right",
                      fmpq_get_d(w->x[1]), fmpq_get_d(w->y[1]), unit, w->kpa[1],
                      fmpq_get_d(w->x[0]), fmpq_get_d(w->y[0]), unit, w->kpa[0], length, unit,
                      beyond);
}

tp_status tp_water_note_joint(tp_notes *notes, const tp_problem *problem, bool left,
                              tp_message *message) {
  const tp_water_description *water = &problem->scene->loads.water;
  const bool sited = tp_problem_has_wetted(problem);
  const tp_wetted *wetted = problem->wetted + (left ? 0 : 1);
  const bool heel_right = left != water->lifts_alone;
  if (!water->uplift) return TP_OK;
  if (sited && wetted->joint.count == 0) return TP_OK;
  if (sited && wetted->joint.count == wetted->gap_lines) return TP_OK; /* only the gap is wet */
  wet_line w;
  wet_line_init(&w);
  if (sited) {
    sited_line(&w, wetted->joint.items, heel_right);
  } else {
    height_line(&w, problem, heel_right);
  }
  tp_status status = note_line(notes, problem, &w, sited ? gap_length(wetted) : 0, left, message);
  wet_line_clear(&w);
  if (status != TP_OK || sited || !tp_base_joint_gapes(&problem->joint, heel_right ? 1 : 0)) {
    return status;
  }
  return tp_notes_add(notes, message, TP_CAUTION, water->place,
                      "the base joint begins with an open gap at its up-dip end: a 'height' lets "
                      "the pressure fall over that gap, which carries its full pressure; give the "
                      "water by its 'level'");
}

tp_status tp_water_cautions(tp_notes *notes, const tp_problem *problem, tp_message *message) {
  const tp_scene *scene = problem->scene;
  const tp_water_description *water = &scene->loads.water;
  const bool way[2] = {scene->towards_left, scene->towards_right};
  tp_status status = note_open(notes, water, message);
  for (int k = 0; k < 2 && status == TP_OK; k++) {
    if (way[k]) status = note_stand(notes, problem->wetted + k, water, message);
    if (way[k] && status == TP_OK) {
      status = tp_water_note_joint(notes, problem, k == 0, message);
    }
  }
  if (status == TP_OK && water->lifts_alone && water->faces != TP_WATER_IN_FRONT) {
    status = tp_earthquake_note_water(notes, water, message);
  }
  if (status != TP_OK) return status;
  const char *at = problem->placement.world != NULL ? "as the block lies"
                   : scene->tilt_angle_deg.given    ? "at the tilt of the scene"
                                                    : "with the base level, as no tilt is given";
  return tp_notes_add(
      notes, message, TP_NOTE, water->place,
      "the pressures of the water are taken %s, and stay the same at other tilts, such "
      "as the critical one; where its level is held, vary the %s of the scene instead",
      at, problem->placement.world != NULL ? "dip" : "tilt");
}
