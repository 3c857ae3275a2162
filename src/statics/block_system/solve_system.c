/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public calls that solve a scene of many blocks: the limits to both sides once, and for each
 * direction verdict, factor of safety, and the collapse. */

#include "block_system/collapse.h"
#include "block_system/resultant.h"
#include "block_system/system.h"
#include "block_system/system_strength.h"
#include "common/host.h"

#include <math.h>
#include <string.h>

typedef struct solving {
  const tp_built_system *s;
  const tp_solve_options *options;
  tp_block_system *system;
  tp_load_bracket limits[2]; /* to the left and to the right */
} solving;

static bool is_exceeded(const tp_load_bracket *b, double tangent) {
  return b->is_bounded && b->bound < tangent;
}

static bool is_held(const tp_load_bracket *b, double tangent) {
  return b->is_held && b->held >= tangent;
}

/* By the limits to the side and to the other. */
static tp_system_verdict judge(const tp_resultant *r, const tp_load_bracket *side,
                               const tp_load_bracket *other) {
  const double t = r->tangent.value, e = r->tangent.error;
  if (r->beyond) return TP_SYSTEM_UNDECIDED;
  if (is_exceeded(side, t - e) || is_exceeded(other, -t - e)) return TP_SYSTEM_COLLAPSES;
  return is_held(side, t + e) && is_held(other, -t + e) ? TP_SYSTEM_CAN_HOLD : TP_SYSTEM_UNDECIDED;
}

static void set_limit(tp_system_case *own, const tp_load_bracket *b, const tp_resultant *r) {
  if (!b->is_held && !b->is_bounded) {
    own->limit = TP_SYSTEM_LIMIT_UNDECIDED;
  } else if (!b->is_bounded) {
    own->limit = b->held > TP_MOST_LOAD ? TP_SYSTEM_INTERLOCKED : TP_SYSTEM_LIMIT_UNDECIDED;
  } else if (!b->is_held) {
    own->limit = TP_SYSTEM_LIMIT_UNDECIDED;
  } else {
    own->limit = TP_SYSTEM_LIMIT_NUMBER;
    own->critical_angle_deg = tp_resultant_tilt_deg(r, b->held, b->bound);
    own->has_acceleration =
        tp_resultant_acceleration(&own->critical_acceleration_g, r, b->held, b->bound) &&
        own->critical_acceleration_g.value >= 0;
  }
}

static void set_factor(tp_system_case *own, const tp_system_strength *strength) {
  own->fos.state = TP_FOS_UNDECIDED;
  if (!strength->is_held) return;
  own->fos.state = TP_FOS_NUMBER;
  if (strength->is_bounded) {
    own->fos.value.value = strength->held + (strength->bound - strength->held) / 2;
    own->fos.value.error =
        nextafter((strength->bound - strength->held) / 2 * (1 + 1e-15), INFINITY);
  } else {
    own->fos_is_least = true;
    own->fos.value.value = strength->held;
  }
}

/* The collapse with less strength where there is a factor; else the one at the limit. */
static tp_status set_collapse(tp_system_case *own, const solving *x,
                              const tp_system_strength *strength, const tp_load_bracket *limit,
                              const tp_resultant *r, tp_message *message) {
  const bool reduced = strength->is_bounded;
  const tp_load_bracket *b = reduced ? &strength->collapse : limit;
  if (!b->is_held || !b->is_bounded) return TP_OK;
  own->motion_count = x->system->block_count;
  own->force_count = x->system->contact_count;
  own->has_forces = tp_system_is_weighed(x->system);
  const double scale = reduced ? r->along_normal : cos(atan(b->held));
  return tp_collapse_describe(own, x->s, b, reduced ? strength->bound : 1, scale, message);
}

static tp_status solve_case(const solving *x, bool left, tp_message *message) {
  tp_system_case *own = NULL;
  tp_resultant r;
  tp_system_strength strength = {.is_held = false};
  tp_status status = tp_system_case_add(x->system, &own, message);
  if (status == TP_OK) status = tp_resultant_init(&r, x->s->scene, left, message);
  if (status != TP_OK) return status;
  const tp_load_bracket *side = x->limits + (left ? 0 : 1), *other = x->limits + (left ? 1 : 0);
  own->towards = left ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
  own->tilt_angle_deg = tp_ball_bounded(r.tilt_deg);
  own->verdict = judge(&r, side, other);
  set_limit(own, side, &r);
  own->fos.state = TP_FOS_NOT_ASKED;
  if (x->options->strength_reduction && !r.beyond) {
    status = tp_system_strength_find(&strength, x->s, left, &r.tangent, message);
    if (status == TP_OK) set_factor(own, &strength);
  }
  if (status == TP_OK) status = set_collapse(own, x, &strength, side, &r, message);
  own->has_required_fos = x->system->has_required_fos;
  if (own->has_required_fos) {
    own->meets_required = tp_system_case_meets(own, x->system->required_fos.value);
  }
  tp_system_strength_clear(&strength);
  tp_resultant_clear(&r);
  return status;
}

/* On a slope up-dip too where an earthquake may act that way. */
static bool is_asked(const tp_scene *scene, bool left) {
  if (scene->frame != TP_FRAME_SLOPE) return left ? scene->towards_left : scene->towards_right;
  const tp_loads_description *loads = &scene->loads;
  const bool down_dip = scene->slope.left == left;
  const bool only = loads->direction_given && loads->direction != TP_SEISMIC_BOTH;
  if (!loads->horizontal.given) return down_dip;
  return !only || (loads->direction == TP_SEISMIC_DOWN_DIP) == down_dip;
}

static tp_status solve_cases(solving *x, tp_message *message) {
  const tp_scene *scene = x->s->scene;
  tp_status status = tp_built_system_bracket(x->limits, x->s, true, 1, message);
  if (status == TP_OK) status = tp_built_system_bracket(x->limits + 1, x->s, false, 1, message);
  if (status == TP_OK && is_asked(scene, true)) status = solve_case(x, true, message);
  if (status == TP_OK && is_asked(scene, false)) status = solve_case(x, false, message);
  tp_load_bracket_clear(x->limits);
  tp_load_bracket_clear(x->limits + 1);
  return status;
}

tp_status tp_solve_block_system(tp_block_system **system, const tp_scene *scene,
                                const tp_solve_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, system);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  if (scene->many.count == 0) {
    return tp_refuse(message, TP_FAULT_KEY, scene->block.place,
                     "this scene is of one block: tp_solve takes it");
  }
  tp_built_system built;
  tp_status status = tp_built_system_init(&built, scene, message);
  if (status != TP_OK) return status;
  solving x = {.s = &built, .options = options};
  status = tp_block_system_describe(&x.system, &built, message);
  if (status == TP_OK) status = solve_cases(&x, message);
  if (status == TP_OK) {
    *system = x.system;
  } else {
    tp_block_system_free(x.system);
  }
  tp_built_system_clear(&built);
  return status;
}

bool tp_block_system_is_undecided(const tp_block_system *system) {
  if (system == NULL) return true;
  for (size_t k = 0; k < system->case_count; k++) {
    if (system->cases[k].verdict == TP_SYSTEM_UNDECIDED) return true;
  }
  return false;
}

/* A factor of limit analysis is above the true one where friction does not dilate: what it does not
 * reach is certainly not met, and what it reaches is met where the blocks certainly stand. */
tp_design tp_system_case_meets(const tp_system_case *own, double required) {
  if (own == NULL) return TP_DESIGN_OPEN;
  if (own->verdict == TP_SYSTEM_COLLAPSES) return TP_DESIGN_NOT_MET;
  if (own->fos.state == TP_FOS_NUMBER && !own->fos_is_least &&
      own->fos.value.value + own->fos.value.error < required) {
    return TP_DESIGN_NOT_MET;
  }
  return TP_DESIGN_OPEN;
}

tp_design tp_block_system_meets(const tp_block_system *system, double required) {
  if (system == NULL) return TP_DESIGN_OPEN;
  tp_design worst = TP_DESIGN_MET;
  for (size_t k = 0; k < system->case_count && worst != TP_DESIGN_NOT_MET; k++) {
    const tp_design own = tp_system_case_meets(system->cases + k, required);
    if (own != TP_DESIGN_MET) worst = own;
  }
  return worst;
}
