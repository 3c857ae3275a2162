/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Facets, tractions and loads of a body divided by extent, weight and unit closure, and the checks
 * of stiffness and tolerance. */

#include "quasi_static/model.h"

#include "common/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The closure by the weight alone may be this share of the block: second-order terms are of its
 * square. */
static const double most_closure = 1e-2;

/* Angles below this are not told apart: rounding of the balance, 1e-13, is far below it. */
static const double least_tolerance = 1e-10;

tp_path_settings tp_path_settings_default(void) {
  const double degree = acos(-1) / 180;
  return (tp_path_settings){.normal_pa_m = 1e12,
                            .shear_pa_m = 1e10,
                            .to_angle = 89.9 * degree,
                            .tolerance = 1e-6 * degree,
                            .moments_every = degree / 2,
                            .most_events = 20000};
}

static tp_status refuse(tp_message *message, const char *what) {
  return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0}, "%s", what);
}

static bool is_stiffness(double value) {
  return isfinite(value) && value > 0;
}

static tp_status check(const tp_path_settings *s, const tp_rigid_body *body, tp_message *message) {
  if (!is_stiffness(s->normal_pa_m) || !is_stiffness(s->shear_pa_m)) {
    return refuse(message, "the path needs a normal and a shear stiffness of the contact above 0");
  }
  if (!(s->from_angle >= 0 && s->to_angle >= s->from_angle && s->to_angle < acos(-1) / 2)) {
    return refuse(message, "the path goes from a tilt of 0 or more to one that is not less, below "
                           "90 degrees");
  }
  if (!(s->tolerance >= least_tolerance && s->tolerance < 1)) {
    return refuse(message, "the tolerance of the path's angles is at least 1e-10 radians, and less "
                           "than 1");
  }
  if (!(s->moments_every >= 0 && s->point_length_m >= 0 && isfinite(s->point_length_m))) {
    return refuse(message,
                  "the step of the path's history and the length of a point are 0 or more");
  }
  if (body->closed_count == 0) {
    return refuse(message, "the block does not touch its base: there is no equilibrium to follow");
  }
  return TP_OK;
}

static tp_xy over(tp_xy point, double extent_m) {
  return (tp_xy){point.x / extent_m, point.y / extent_m};
}

static bool are_finite(const tp_path_traction *tractions, long count) {
  for (long k = 0; k < count; k++) {
    const tp_path_traction *own = tractions + k;
    if (!isfinite(own->from_pa) || !isfinite(own->to_pa) || !isfinite(own->shear_pa)) return false;
  }
  return true;
}

/* The facets out of their ends: those of a facet follow each other. */
static void set_facets(tp_path_model *model, const tp_path_settings *settings) {
  const tp_rigid_body *body = model->body;
  const double point_m =
      settings->point_length_m > 0 ? settings->point_length_m : body->extent_m / 100;
  for (long k = 0; k < body->closed_count;) {
    const tp_closed_point *end = body->closed + k;
    const bool in_a_point = end->share_m == 0;
    model->facets[model->count++] = (tp_joint_facet){
        .from = over(end->at, body->extent_m),
        .to = over(end[in_a_point ? 0 : 1].at, body->extent_m),
        .tangent = end->tangent,
        .normal = end->normal,
        .length = (in_a_point ? point_m : 2 * end->share_m) / body->extent_m,
        .in_a_point = in_a_point,
        .friction = end->friction,
        .number = end->facet,
    };
    k += in_a_point ? 1 : 2;
  }
}

static void set_tractions(tp_path_model *model, const tp_path_settings *settings) {
  const tp_rigid_body *body = model->body;
  const double unit_pa = model->weight_n / (body->extent_m * body->thickness_m);
  for (long k = 0; k < model->count; k++) {
    const tp_path_traction *own = settings->tractions + k;
    tp_joint_facet *facet = model->facets + k;
    facet->locked_from = own->from_pa / unit_pa;
    facet->locked_to = own->to_pa / unit_pa;
    facet->locked_shear = own->shear_pa / unit_pa;
  }
}

static tp_status check_stiffness(const tp_path_model *model, double normal_pa_m,
                                 tp_message *message) {
  double length = 0;
  for (long k = 0; k < model->count; k++) length += model->facets[k].length;
  const double share = model->closure_m / model->body->extent_m / length;
  if (share <= most_closure) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                   "under its weight alone the block would close its contact by %.3g of its size, "
                   "which is not small: the normal stiffness must be %.3g Pa/m or more",
                   share, normal_pa_m * share / most_closure);
}

tp_status tp_path_model_init(tp_path_model *model, const tp_rigid_body *body,
                             const tp_path_settings *settings, tp_message *message) {
  memset(model, 0, sizeof *model);
  const tp_status checked = check(settings, body, message);
  if (checked != TP_OK) return checked;
  model->body = body;
  model->facets = calloc((size_t)body->closed_count, sizeof *model->facets);
  if (model->facets == NULL) return tp_fail_memory(message, "the springs of the contact");
  set_facets(model, settings);
  model->shear_ratio = settings->shear_pa_m / settings->normal_pa_m;
  model->square_gyration = body->inertia_kg_m2 / body->mass_kg / (body->extent_m * body->extent_m);
  model->weight_n = body->mass_kg * TP_GRAVITY_M_S2;
  model->closure_m = model->weight_n / (settings->normal_pa_m * body->extent_m * body->thickness_m);
  if (settings->weight_moves) model->moves = model->closure_m / body->extent_m;
  if (settings->tractions != NULL) {
    if (!are_finite(settings->tractions, model->count)) {
      tp_path_model_clear(model);
      return refuse(message, "the tractions that are locked in on the facets must be finite");
    }
    set_tractions(model, settings);
  }
  const tp_status small = check_stiffness(model, settings->normal_pa_m, message);
  if (small != TP_OK) tp_path_model_clear(model);
  return small;
}

void tp_path_model_clear(tp_path_model *model) {
  free(model->facets);
  memset(model, 0, sizeof *model);
}

tp_three tp_path_load(const tp_path_model *model, double tilt) {
  const tp_drive held = {.angle = tilt, .final_angle = tilt};
  const tp_body_force force = tp_drive_force(&held, model->body, 0);
  return (tp_three){{force.x_n / model->weight_n, force.y_n / model->weight_n,
                     force.moment_nm / (model->weight_n * model->body->extent_m)}};
}

tp_three tp_path_load_rate(const tp_path_model *model, double tilt) {
  const double step = 1e-4;
  const tp_three after = tp_path_load(model, tilt + step),
                 before = tp_path_load(model, tilt - step);
  tp_three rate;
  for (int k = 0; k < 3; k++) rate.of[k] = (after.of[k] - before.of[k]) / (2 * step);
  return rate;
}
