/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes of toothed blocks in memory, solved for their angles and motions, and tan(alpha_crit) of
 * an even number of teeth in doubles with bounds (Eq. (15), and Eq. (16) with 12 for its 4;
 * docs/mechanics.md section 8). */

#include "paper/teeth.h"
#include "stability/tilts.h"

#include <float.h>
#include <math.h>

const char *const tp_toe_names[3] = {"planar", "peak", "valley"};

/* Of mean height 1 m, towards the left. */
static tp_status fill_scene(tp_scene *scene, const tp_toothed_question *q, tp_message *message) {
  const tp_toothed *b = &q->block;
  const tp_exact width = tp_exact_of(b->inverse_slenderness), one = tp_exact_of(1);
  tp_status status = TP_OK;
  if (q->toe == TP_TOE_PLANAR || b->amplitude == 0) {
    status = tp_scene_set_slab(scene, width, one, message);
  } else {
    status = tp_scene_set_teeth_over(
        scene, (long)b->sub_blocks, width, one, tp_exact_of(b->amplitude),
        q->toe == TP_TOE_VALLEY ? TP_LEFT_END_VALLEY : TP_LEFT_END_PEAK, message);
  }
  if (status == TP_OK && q->friction_deg > 0) {
    status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(q->friction_deg), message);
  }
  if (status == TP_OK && q->tilt_deg > 0) {
    status = tp_scene_set_tilt_angle_deg(scene, tp_exact_of(q->tilt_deg), message);
  }
  if (status == TP_OK) status = tp_scene_set_tilt_towards(scene, true, false, message);
  return status;
}

tp_status tp_toothed_solve(tp_solution **solution, const tp_toothed_question *q,
                           tp_message *message) {
  tp_scene *scene = NULL;
  tp_solve_options options = tp_solve_options_default();
  options.digits = 15;
  options.strength_reduction = false;
  options.motion_ranges = q->tilt_deg == 0;
  tp_status status = tp_scene_new(&scene, "m", message);
  if (status == TP_OK) status = fill_scene(scene, q, message);
  if (status == TP_OK) status = tp_solve_numbers(solution, scene, &options, message);
  tp_scene_free(scene);
  return status;
}

tp_status tp_toothed_critical_angle(tp_bounded *degrees, const tp_toothed *block, tp_toe_kind toe,
                                    tp_message *message) {
  const tp_toothed_question question = {.block = *block, .toe = toe};
  tp_solution *solution = NULL;
  const tp_status status = tp_toothed_solve(&solution, &question, message);
  /* the toe is the first contact point from the left, whether it is admissible or not */
  if (status == TP_OK) *degrees = solution->cases[0].pivots[0].critical_angle_deg;
  tp_solution_free(solution);
  return status;
}

tp_status tp_toothed_borders(tp_toothed_border *borders, size_t *count, size_t room,
                             const tp_toothed_question *question, tp_message *message) {
  tp_solution *solution = NULL;
  const tp_status status = tp_toothed_solve(&solution, question, message);
  if (status != TP_OK) return status;
  const tp_onset *onset = &solution->cases[0].onset;
  for (size_t k = 0; k + 1 < onset->range_count && *count < room; k++) {
    const tp_motion_range *own = onset->ranges + k, *next = own + 1;
    /* two that meet have one end */
    if (own->to_deg.value != next->from_deg.value || own->to_deg.value <= 0) continue;
    borders[(*count)++] = (tp_toothed_border){question->block.inverse_slenderness, own->to_deg,
                                              own->motions, next->motions};
  }
  tp_solution_free(solution);
  return TP_OK;
}

/* The denominator loses at most 4 roundings of numbers up to 1.5, the quotient one more. */
tp_bounded tp_toothed_tangent(const tp_toothed *block, tp_toe_kind toe) {
  const double x = block->inverse_slenderness, a = block->amplitude;
  const double sign = toe == TP_TOE_PEAK ? -1 : 1;
  const double below = toe == TP_TOE_PLANAR ? 1 : 1 + sign * a - a * a / 12;
  return tp_quotient((tp_bounded){.value = x},
                     (tp_bounded){.value = below, .error = 4 * DBL_EPSILON});
}

/* d tan / d angle = 1 + tan^2; the conversion to radians is off by at most two roundings, the
 * library's tan by less than one unit in the last place. */
tp_bounded tp_tangent_deg(tp_bounded degrees) {
  static const double radian = 0.017453292519943295;
  const double angle = degrees.value * radian;
  const double value = tan(angle), slope = 1 + value * value;
  const double moved = fabs(degrees.error * radian) + 2 * DBL_EPSILON * fabs(angle);
  /* over so small a move the slope at most doubles */
  return (tp_bounded){.value = value, .error = 2 * slope * moved + DBL_EPSILON * fabs(value)};
}

tp_bounded tp_quotient(tp_bounded n, tp_bounded d) {
  const double value = n.value / d.value, least = fabs(d.value) - d.error;
  return (tp_bounded){.value = value,
                      .error = 1.01 * (n.error + fabs(value) * d.error) / least +
                               DBL_EPSILON * fabs(value)};
}
