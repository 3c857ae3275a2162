/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ways of a scene. Rounded corners are three questions: the sharp block, and both models. */

#include "accuracy/ways.h"
#include "common/host.h"
#include "common/message.h"
#include "scene/check_tilt_test.h"
#include "stability/solve.h"
#include "stability/tilts.h"

#include <string.h>

static void subject_clear(tp_accuracy_subject *s) {
  tp_problem_clear(&s->problem);
  tp_solution_free(s->noted);
}

/* The scene, its corners rounded as they are, sharp, or by the other model. */
typedef enum corners { CORNERS_SHARP, CORNERS_PAPER, CORNERS_EXACT, CORNERS_AS_THEY_ARE } corners;

static tp_status subject_init(tp_accuracy_subject *s, const tp_scene *scene, corners as,
                              tp_message *message) {
  tp_solve_options options = tp_solve_options_default();
  options.limit = false;
  *s = (tp_accuracy_subject){.scene = *scene};
  tp_rounded_description *rounded = &s->scene.block.rounded;
  s->scene.base.all_poses = false;
  if (as == CORNERS_SHARP) rounded->count = 0;
  if (as != CORNERS_AS_THEY_ARE) rounded->keeps_mass = as == CORNERS_PAPER;
  tp_status status = tp_solve_numbers(&s->noted, &s->scene, &options, message);
  if (s->noted == NULL) return status; /* outputs of a call that fails stay untouched */
  s->towards = s->noted->cases[0].towards;
  status = tp_problem_init(&s->problem, &s->scene, &options, s->noted, message);
  if (status != TP_OK) {
    tp_solution_free(s->noted);
    return status;
  }
  const tp_case *own = s->noted->cases;
  s->has_pivot = own->has_toppling_pivot;
  if (s->has_pivot) s->point = (long)own->pivots[own->toppling_pivot].index;
  return TP_OK;
}

/* A method of a scene: how its corners are, and what evaluates it. */
typedef struct asked {
  tp_accuracy_method method;
  corners as;
  tp_priced evaluate;
  tp_level truth_level;
} asked;

static const asked ways[TP_ACCURACY_METHODS] = {
    {TP_ACCURACY_BOUNDARY, CORNERS_SHARP, tp_accuracy_by_boundary, TP_LEVEL_EXACT},
    {TP_ACCURACY_TRIANGLES, CORNERS_SHARP, tp_accuracy_by_triangles, TP_LEVEL_EXACT},
    {TP_ACCURACY_ROUNDED_PAPER, CORNERS_PAPER, tp_accuracy_by_rounding, TP_LEVEL_BALL},
    {TP_ACCURACY_ROUNDED_EXACT, CORNERS_EXACT, tp_accuracy_by_rounding, TP_LEVEL_BALL},
    {TP_ACCURACY_LIMIT, CORNERS_AS_THEY_ARE, tp_accuracy_by_limit, TP_LEVEL_BALL},
    {TP_ACCURACY_ONSET, CORNERS_AS_THEY_ARE, tp_accuracy_by_onset, TP_LEVEL_BALL}};

/* Only what the scene calls for: curves have no triangles, sharp blocks no rounding. */
static bool is_called_for(const asked *way, const tp_scene *scene) {
  const tp_block_description *block = &scene->block;
  switch (way->method) {
  case TP_ACCURACY_BOUNDARY:
    return true;
  case TP_ACCURACY_TRIANGLES:
    return block->form != TP_OUTLINE_ELLIPSE && block->arc_count == 0;
  case TP_ACCURACY_ROUNDED_PAPER:
    return block->rounded.count > 0;
  case TP_ACCURACY_ROUNDED_EXACT: /* which part a tip belongs to is not known */
    return block->rounded.count > 0 && block->part_count == 0;
  case TP_ACCURACY_LIMIT:
  case TP_ACCURACY_ONSET:
    return scene->friction_angle_deg.given;
  }
  return false;
}

/* The exact program of many facets is left out: it takes minutes. */
static tp_accuracy_prices affordable(const asked *way, const tp_accuracy_subject *s, bool few) {
  enum { MOST_EXACT_FACETS = 10000 };
  tp_accuracy_prices prices = tp_accuracy_prices_of(way->method, few);
  const bool large =
      way->method == TP_ACCURACY_LIMIT && s->problem.contact.facet_count > MOST_EXACT_FACETS;
  while (large && prices.rungs[prices.count - 1].level == TP_LEVEL_EXACT) prices.count--;
  return prices;
}

static tp_status add_way(tp_accuracy *accuracy, const asked *way, const tp_scene *scene, bool few,
                         tp_message *message) {
  tp_accuracy_subject s;
  tp_status status = subject_init(&s, scene, way->as, message);
  if (status != TP_OK) return status;
  if (s.has_pivot || way->as == CORNERS_AS_THEY_ARE) { /* by contacts, which need no pivot */
    const tp_accuracy_way measured = {.method = way->method,
                                      .evaluate = way->evaluate,
                                      .subject = &s,
                                      .truth_level = way->truth_level,
                                      .vertices = (size_t)tp_problem_vertex_count(&s.problem),
                                      .prices = affordable(way, &s, few)};
    accuracy->towards = s.towards;
    status = tp_accuracy_measure(accuracy, &measured);
    if (status != TP_OK)
      (void)tp_fail(message, status, (tp_place){0}, "%s: %s", tp_accuracy_method_name(way->method),
                    tp_status_meaning(status));
  }
  subject_clear(&s);
  return status;
}

tp_status tp_accuracy_add_scene(tp_accuracy *accuracy, const tp_scene *scene, unsigned methods,
                                bool few, tp_message *message) {
  tp_status status = TP_OK;
  for (int k = 0; k < TP_ACCURACY_METHODS && status == TP_OK; k++) {
    if ((methods >> k & 1) == 0 || !is_called_for(ways + k, scene)) continue;
    status = add_way(accuracy, ways + k, scene, few, message);
  }
  return status;
}

/* The test over its settings, where the scene calls for one that has a critical angle, or a least
 * shaking. */
static tp_status add_simulated(tp_accuracy *accuracy, const tp_scene *scene, tp_message *message) {
  const tp_tilt_options options = tp_tilt_options_default();
  const bool released = tp_scene_tilt_protocol(scene) == TP_TILT_RELEASE;
  if (!tp_scene_is_simulated(scene) || !scene->friction_angle_deg.given) return TP_OK;
  if (released && !tp_scene_is_shaken(scene)) return TP_OK;
  return tp_tilt_converge(&accuracy->simulated, scene, &options, message);
}

tp_status tp_accuracy_of_scene(tp_accuracy **accuracy, const tp_scene *scene, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, accuracy);
  TP_REFUSE_NULL(message, scene);
  tp_accuracy *own = tp_accuracy_new();
  if (own == NULL) return tp_fail_memory(message, "the account of accuracy");
  tp_status status = tp_scene_copy_sources(&own->sources, &own->source_count, scene, message);
  if (status == TP_OK) status = tp_accuracy_add_scene(own, scene, ~0U, false, message);
  if (status == TP_OK) status = add_simulated(own, scene, message);
  if (status == TP_OK && scene->title != NULL) {
    own->title = strdup(scene->title);
    if (own->title == NULL) status = tp_fail_memory(message, "the title");
  }
  if (status == TP_OK && own->run_count == 0 && own->simulated == NULL) {
    status = tp_fail(message, TP_NO_ANSWER, (tp_place){scene->path, 0, 0},
                     "no pivot is admissible, and there is neither a static limit nor an onset of "
                     "motion: there is no angle "
                     "whose accuracy could be measured");
  }
  if (status == TP_OK) {
    *accuracy = own;
  } else {
    tp_accuracy_free(own);
  }
  return status;
}
