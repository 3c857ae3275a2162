/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solves the scene at its numbers, builds section and sums in symbols, and gives pivots and arms,
 * mirrored for a tilt towards the right. */

#include "derive/model.h"

#include "common/notes.h"
#include "derive/field_work.h"
#include "load/loads.h"
#include "stability/cautions.h"
#include "stability/solution.h"
#include "stability/solve.h"

#include <stdlib.h>
#include <string.h>

/* Formulas of more coordinates are longer than anyone reads. */
enum { MOST_VERTICES = 20000 };

void tp_model_clear(tp_model *model) {
  tp_formulas_clear(&model->formulas, &model->symbols.field);
  tp_symbols_clear(&model->symbols);
  tp_problem_clear(&model->problem);
  tp_solution_free(model->solution);
  memset(model, 0, sizeof *model);
}

static tp_status solve(tp_model *model, const tp_scene *scene, tp_message *message) {
  const tp_solve_options options = tp_solve_options_default(); /* needs no account in numbers */
  const tp_status status = tp_solve_problem(model->solution, &model->problem, &options, message);
  if (status != TP_OK) return status;
  if (model->problem.lattice.start[model->problem.section.ring_count] <= MOST_VERTICES)
    return TP_OK;
  return tp_fail(message, TP_NO_ANSWER, scene->block.place,
                 "more than %d vertices; formulas are derived for fewer", MOST_VERTICES);
}

tp_status tp_model_check_named(const tp_scene *scene, tp_message *message) {
  if (scene->source != NULL) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                   "formulas are derived in the names of a scene file's parameters, which a scene "
                   "built in memory has not; read one by tp_scene_read_text");
}

tp_status tp_model_init(tp_model *model, const tp_scene *scene, bool elements,
                        const tp_symbol_names *more, tp_message *message) {
  memset(model, 0, sizeof *model);
  const tp_status named = tp_model_check_named(scene, message);
  if (named != TP_OK) return named;
  if (scene->block.rounded.count > 0) {
    return tp_refuse(
        message, TP_FAULT_KEY, scene->block.rounded.place,
        "formulas are derived for the sharp block; leave out 'rounded' and derive with "
        "--rounded");
  }
  if (scene->block.form == TP_OUTLINE_ELLIPSE || scene->block.arc_count > 0) {
    return tp_refuse(message, TP_FAULT_KEY, scene->block.place,
                     "formulas are derived for outlines of straight edges, not for curves");
  }
  if (scene->block.repair) {
    return tp_refuse(message, TP_FAULT_KEY, scene->block.repair_place,
                     "formulas are derived for the outline as it is given; leave out 'repair'");
  }
  if (tp_loads_are_called_for(&scene->loads)) {
    return tp_refuse(message, TP_FAULT_KEY, scene->loads.place,
                     "formulas are derived for the weight alone; leave out 'loads'");
  }
  if (scene->base.rests) {
    return tp_refuse(
        message, TP_FAULT_KEY, scene->base.rests_place,
        "where a block comes to rest has no formula in its parameters; derive it where "
        "it rests, 'place: as_given'");
  }
  if (tp_scene_is_shifted(scene)) {
    return tp_refuse(
        message, TP_FAULT_KEY, tp_scene_shift_place(scene),
        "where a shifted block comes to rest has no formula in its parameters; derive it "
        "where it fits, and leave out 'joint'");
  }
  if (scene->base.within.given) {
    return tp_refuse(message, TP_FAULT_KEY, scene->base.within.place,
                     "where vertices are moved to their contacts has no formula in the parameters; "
                     "give them where they touch, and leave out 'contact'");
  }
  if (tp_smoothed_is_asked(scene)) {
    return tp_refuse(message, TP_FAULT_KEY,
                     scene->base.smooth.given ? scene->base.smooth.place : scene->friction_is_place,
                     "formulas are derived for the sole as it is drawn; leave out 'smooth' and "
                     "'friction_is: apparent'");
  }
  if (scene->frame == TP_FRAME_WORLD) {
    return tp_refuse(
        message, TP_FAULT_KEY, scene->frame_place,
        "formulas are derived along the mean plane of the base; give coordinates along "
        "it, and leave out 'frame'");
  }
  model->solution = tp_solution_new();
  if (model->solution == NULL) return tp_fail_memory(message, "the derivation");
  tp_solve_options options = tp_solve_options_default();
  options.elements = elements;
  tp_status status = tp_scene_notes(&model->solution->notes, scene, message);
  if (status == TP_OK) {
    status = tp_problem_init(&model->problem, scene, &options, model->solution, message);
  }
  if (status == TP_OK) {
    status = tp_problem_cautions(&model->solution->notes, &model->problem, message);
    if (status == TP_OK) status = solve(model, scene, message);
    if (status == TP_OK) {
      status = tp_symbols_init(&model->symbols, scene, &model->problem.section, more, message);
    }
    if (status != TP_OK) tp_problem_clear(&model->problem);
  }
  if (status != TP_OK) {
    tp_solution_free(model->solution);
    return status;
  }
  tp_formulas_init(&model->formulas, &model->symbols.field);
  tp_formulas_sum(&model->formulas, &model->symbols, &model->problem.section);
  status = tp_field_check(&model->symbols.field, scene->block.place, message);
  if (status != TP_OK) tp_model_clear(model);
  return status;
}

tp_status tp_model_pivot(tp_symbolic_point *pivot, const tp_model *model, size_t k,
                         tp_message *message) {
  const tp_problem *problem = &model->problem;
  if (tp_formulas_point(pivot, &model->symbols, problem, problem->contact.points[k].point)) {
    return TP_OK;
  }
  return tp_fail(message, TP_NO_ANSWER, problem->scene->base.place,
                 "a pivot lies on the base past the block, where the base has no formula; give "
                 "the base as a profile");
}

void tp_model_arms(fmpz_mpoly_q_t x_arm, fmpz_mpoly_q_t y_arm, const tp_model *model,
                   const tp_symbolic_point *pivot, tp_direction towards) {
  const tp_formulas *f = &model->formulas;
  const tp_field *field = &model->symbols.field;
  tp_formulas_arm(x_arm, f->x6, f->weighted2, pivot->x, field);
  tp_formulas_arm(y_arm, f->y6, f->weighted2, pivot->y, field);
  tp_symbol_mirror(x_arm, towards, field);
}
