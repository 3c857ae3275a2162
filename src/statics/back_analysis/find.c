/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis: the numbers of a scene for which a result has a wanted value.
 *
 * Method: the scene is solved with the number replaced, at 512 points of the range; where the scene
 * has no answer at one of two neighbours the edge of its domain is bisected. Between neighbours on
 * different sides of the wanted value the solution is bisected until the sides are no longer told
 * apart, or the bracket is narrower than 1e-14 of the number. Every side is certain: the result's
 * bound does not reach the wanted value. A bracket over which the result jumps is no solution.
 * Where of three points in a row on one side the middle one is nearest to the wanted value, the
 * nearest between them is looked for: it may lie beyond the value, which gives two solutions, or
 * come so close that the bound does not tell whether it touches it: a double solution, or none.
 * Where the result stays at the value, the ends of that stretch are bisected (find_level.c). */

#include "back_analysis/find_blocks.h"
#include "back_analysis/find_least.h"
#include "back_analysis/find_search.h"
#include "back_analysis/find_stretches.h"
#include "back_analysis/find_support.h"
#include "back_analysis/find_system.h"
#include "common/host.h"
#include "common/options.h"
#include "common/outside.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

TP_OPTIONS_END(tp_find_options, least_over);

void tp_find_options_init(tp_find_options *options, size_t size) {
  const tp_find_options defaults = {.size = sizeof defaults, .target = TP_FIND_CRITICAL_ANGLE};
  tp_options_fill(options, size, &defaults);
}

void tp_found_free(tp_found *found) {
  if (found == NULL) return;
  free(found->key);
  free(found->solutions);
  free(found->touching);
  free(found->intervals);
  free(found->governing);
  free(found->blocks);
  free(found->per_metre_kn);
  free(found->least_over);
  free(found->at_least);
  free(found);
}

static tp_place number_place(const tp_search *s) {
  return tp_scene_key_place(s->varied.keys, s->varied.scene);
}

/* The range to look in: as asked, or about the scene's own number. */
static tp_status set_range(tp_search *s, tp_found *found) {
  const tp_find_options *o = s->options;
  const tp_status status = tp_varied_check(&s->own, &s->varied, s->message);
  if (status != TP_OK) return status;
  found->low = o->has_low ? o->low : s->own < 0 ? 10 * s->own : 0;
  found->high = o->has_high ? o->high : s->own < 0 ? 0 : 10 * s->own;
  if (found->low < found->high) return TP_OK;
  if (found->low == found->high) {
    return tp_refuse(
        s->message, TP_FAULT_RANGE, number_place(s),
        "give the range to look in, as in --from 0 --to 10; this one has no width: both "
        "its ends are %.15g",
        found->low);
  }
  return tp_refuse(
      s->message, TP_FAULT_RANGE, number_place(s),
      "the range is reversed: it begins at %.15g%s and ends at %.15g%s; write the lesser "
      "end as --from, the greater as --to",
      found->low, o->has_low ? "" : " (where no --from is given)", found->high,
      o->has_high ? "" : " (where no --to is given)");
}

/* What a result cannot depend on: moments about a pivot on what holds against sliding, an angle at
 * which the block begins to move on the tilt at which the scene has it. */
static tp_status check_reach(const tp_search *s) {
  const tp_find_target target = s->options->target;
  tp_reach reach;
  const tp_status status = tp_scene_key_reach(&reach, s->varied.keys, s->varied.scene, s->message);
  if (status != TP_OK || reach.other) return status;
  if (s->of_many && (reach.friction || reach.tilt)) return TP_OK;
  const tp_quote key = tp_quote_all(s->options->key);
  if (!reach.friction && !reach.tilt) {
    return tp_fail(s->message, TP_NO_ANSWER, number_place(s),
                   "nothing in the scene depends on '%s': no number names it", key.text);
  }
  const bool moments = target == TP_FIND_CRITICAL_ANGLE || target == TP_FIND_FOS;
  const bool angle = target == TP_FIND_CRITICAL_ANGLE || target == TP_FIND_SLIDING_ANGLE ||
                     target == TP_FIND_LIMIT_ANGLE || target == TP_FIND_ONSET_ANGLE;
  if (reach.friction && (!moments || (reach.tilt && !angle))) return TP_OK;
  if (reach.tilt && !angle) return TP_OK;
  return tp_fail(s->message, TP_NO_ANSWER, number_place(s), "%s cannot depend on '%s': %s",
                 tp_find_target_name(target), key.text,
                 reach.friction
                     ? "it is a balance of moments about a pivot, which the friction and "
                       "the cohesion of the contact do not enter; limit_angle, limit_fos, "
                       "onset_angle and governing_fos depend on them"
                     : "it is a tilt at which the block begins to move, whatever the "
                       "tilt that the scene gives; a factor of safety depends on that");
}

/* What the target cannot be without. */
static tp_status check_target(const tp_search *s) {
  const tp_find_target target = s->options->target;
  const tp_scene *scene = s->varied.scene;
  const tp_place place = {scene->path, 0, 0};
  if (s->of_many) return tp_search_check_system(s);
  if (target > TP_FIND_GOVERNING_FOS) {
    return tp_refuse(s->message, TP_FAULT_ARGUMENT, place,
                     "%s is of scenes of many blocks, and this one has one block",
                     tp_find_target_name(target));
  }
  if (target >= TP_FIND_SLIDING_ANGLE && !scene->friction_angle_deg.given) {
    return tp_refuse(s->message, TP_FAULT_KEY, place,
                     "%s needs friction; give the scene its 'friction_angle_deg: …'",
                     tp_find_target_name(target));
  }
  const bool needs_tilt = tp_find_target_is_factor(target);
  /* one that it gives, or that of a slope */
  if (!needs_tilt || scene->tilt_angle_deg.given || tp_scene_lies_in_place(scene)) return TP_OK;
  return tp_refuse(s->message, TP_FAULT_KEY, place,
                   "%s needs a tilt; give the scene its 'tilt: {towards: left, angle_deg: …}'",
                   tp_find_target_name(target));
}

/* Many blocks take longer to solve, and are told less closely (block_system/): to 1e-6. */
static void set_search(tp_search *s) {
  enum { POINTS_OF_MANY = 64 };
  static const double some_doubles = 1e-14, of_many = 1e-9;
  s->points = s->of_many ? POINTS_OF_MANY : TP_SEARCH_POINTS;
  s->close = s->of_many ? of_many : some_doubles;
}

/* All that the target does not take is left out. */
static void set_options(tp_solve_options *solve, tp_find_target target, bool of_many) {
  *solve = tp_solve_options_default();
  solve->digits = 15;
  solve->strength_reduction = target == TP_FIND_LIMIT_FOS || target == TP_FIND_GOVERNING_FOS ||
                              (of_many && target == TP_FIND_FOS);
  solve->limit =
      target == TP_FIND_LIMIT_ANGLE || target == TP_FIND_ONSET_ANGLE || solve->strength_reduction;
}

/* Without texts, which its solution keeps. */
static void take_governing(tp_governing_fos *governing, const tp_solution *solution) {
  *governing = solution->cases[0].governing_fos;
  governing->fos.value.digits = NULL;
  for (size_t k = 0; k < governing->factor_count; k++) {
    governing->factors[k].fos.value.digits = NULL;
  }
}

/* Which factor governs at what was found. */
static void tell_governing(tp_search *s) {
  tp_found *found = s->found;
  if (s->of_many) tp_search_tell_blocks(s);
  if (found->count == 0) return;
  if (s->of_many || !tp_find_target_is_factor(s->options->target)) return;
  found->governing = calloc(found->count, sizeof *found->governing);
  if (found->governing == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  s->varied.options.limit = s->varied.options.strength_reduction = true;
  for (size_t k = 0; k < found->count && s->status == TP_OK; k++) {
    tp_solution *solution = NULL;
    const double x = found->solutions[k].value;
    found->governing[k].fos.state = TP_FOS_UNDECIDED;
    const tp_status status = tp_varied_solve(&solution, &s->varied, &x, &s->why);
    if (status == TP_OK && solution->case_count > 0) {
      take_governing(found->governing + k, solution);
    }
    if (status == TP_OUT_OF_MEMORY || status == TP_SYSTEM_FAILED) {
      s->status = tp_fail(s->message, status, (tp_place){0}, "%s", s->why.text);
    }
    tp_solution_free(solution);
  }
}

/* The scene with the direction of the least force; unless a range is given, the force is looked for
 * up to twice what the search came to. */
static void turn_to_least(tp_search *s, tp_scene **turned) {
  const tp_find_options *o = s->options;
  tp_found *found = s->found;
  double force = 0;
  found->least_over = strdup(o->least_over);
  s->status = found->least_over != NULL ? tp_search_least(&found->direction_deg, &force, s)
                                        : tp_fail_memory(s->message, "the solutions");
  if (s->status == TP_OK) {
    s->status = tp_scene_with(turned, s->varied.scene, o->least_over,
                              tp_exact_of(found->direction_deg), s->message);
  }
  if (s->status == TP_OK) {
    s->varied.scene = *turned;
    s->status = tp_scene_key_find(s->varied.keys, *turned, o->key, s->message);
  }
  if (s->status == TP_OK && !o->has_high) found->high = 2 * force;
  found->least.value = INFINITY;
  found->greatest.value = -INFINITY;
}

tp_status tp_find(tp_found **found, const tp_scene *scene, const tp_find_options *options,
                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, found);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_find_options taken = tp_find_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  TP_REFUSE_NULL(message, options->key);
  if ((int)options->target < 0 || options->target > TP_FIND_ACCELERATION) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                     "there is no such result to find for");
  }
  if (!isfinite(options->value) ||
      !isfinite((options->has_high ? options->high : 0) - (options->has_low ? options->low : 0))) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "the value to find for and the range to look in must be finite numbers");
  }
  tp_search s = {.options = options,
                 .varied = {.scene = scene, .count = 1},
                 .of_many = tp_scene_block_count(scene) > 0,
                 .message = message};
  set_search(&s);
  set_options(&s.varied.options, options->target, s.of_many);
  tp_found *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the solutions");
  own->size = sizeof *own;
  own->key = strdup(options->key);
  own->least.value = INFINITY; /* none yet */
  own->greatest.value = -INFINITY;
  s.status = own->key != NULL ? tp_scene_key_find(s.varied.keys, scene, options->key, message)
                              : tp_fail_memory(message, "the solutions");
  if (s.status == TP_OK) s.status = check_target(&s);
  if (s.status == TP_OK) s.status = check_reach(&s);
  if (s.status == TP_OK) s.status = set_range(&s, own);
  s.found = own;
  tp_scene *turned = NULL;
  if (s.status == TP_OK && options->least_over != NULL) turn_to_least(&s, &turned);
  if (s.status == TP_OK) tp_search_scan(&s);
  if (s.status == TP_OK) tell_governing(&s);
  if (s.status == TP_OK) tp_search_stretches(&s);
  if (s.status == TP_OK) tp_search_per_metre(&s);
  if (s.status == TP_OK) tp_search_design(&s);
  free(s.tried);
  tp_scene_free(turned);
  if (s.status == TP_OK) {
    *found = own;
  } else {
    tp_found_free(own);
  }
  return s.status;
}
