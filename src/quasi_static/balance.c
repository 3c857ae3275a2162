/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "quasi_static/balance.h"

#include "quasi_static/facet_stress.h"

#include <float.h>
#include <math.h>

/* A shear force within this share of Coulomb's limit is at it: that of a facet that slips is
 * computed anew from its own slip, and comes out with the rounding of some ten operations. */
static const double at_limit = 1e-12;

static double sizes(const tp_three *a, const tp_three *b) {
  return fabs(a->of[0] * b->of[0]) + fabs(a->of[1] * b->of[1]) + fabs(a->of[2] * b->of[2]);
}

static tp_three combined(double a, const tp_three *x, double b, const tp_three *y) {
  tp_three sum;
  for (int k = 0; k < 3; k++) sum.of[k] = a * x->of[k] + b * y->of[k];
  return sum;
}

static void add_outer(tp_matrix *matrix, double factor, const tp_three *column,
                      const tp_three *row) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) matrix->of[i][j] += factor * column->of[i] * row->of[j];
  }
}

static void add(tp_three *sum, double factor, const tp_three *x) {
  for (int k = 0; k < 3; k++) sum->of[k] += factor * x->of[k];
}

/* One facet at a pose. */
typedef struct facet_at {
  tp_three from, to, tangent; /* how forces along the normals at its ends and along it act */
  double closure_from, closure_to;
  tp_facet_stress stress;
  double force, limit; /* normal; of the shear force */
  double shear, trial; /* along the facet; the force that it would make, */
  double doubt;        /* and what rounding may make of that */
} facet_at;

static facet_at place_facet(const tp_joint_facet *facet, const tp_path_pose *pose) {
  facet_at at = {.from = tp_path_along(&pose->frame, facet->normal, facet->from),
                 .to = tp_path_along(&pose->frame, facet->normal, facet->to),
                 .tangent = tp_path_along(&pose->frame, facet->tangent, facet->from)};
  at.closure_from = facet->locked_from - tp_three_product(&at.from, &pose->moved);
  at.closure_to = facet->locked_to - tp_three_product(&at.to, &pose->moved);
  at.stress = tp_facet_stress_of(facet->length, facet->in_a_point, at.closure_from, at.closure_to);
  at.force = at.stress.force_from + at.stress.force_to;
  at.limit = facet->friction * at.force;
  at.shear = tp_three_product(&at.tangent, &pose->moved);
  return at;
}

static tp_facet_shear shear_of(const facet_at *at) {
  if (at->stress.closed == 0) return TP_FACET_OPEN;
  if (at->trial == 0) return TP_FACET_STICKS;
  if (fabs(at->trial) < at->limit * (1 - at_limit) - 8 * at->doubt) return TP_FACET_STICKS;
  return at->trial < 0 ? TP_FACET_SLIPS_ALONG : TP_FACET_SLIPS_AGAINST;
}

/* Adds the shear force and minus its derivative. */
static double add_shear(tp_imbalance *sum, const facet_at *at, tp_facet_shear shear,
                        const tp_joint_facet *facet, double ratio, double slip) {
  const tp_facet_stress *s = &at->stress;
  if (shear == TP_FACET_OPEN) return 0;
  if (shear == TP_FACET_STICKS) {
    const tp_three closes = combined(s->closed_by_from, &at->from, s->closed_by_to, &at->to);
    add_outer(&sum->stiffness, ratio * facet->length * s->closed, &at->tangent, &at->tangent);
    add_outer(&sum->stiffness, -ratio * facet->length * (at->shear - slip), &at->tangent, &closes);
    add(&sum->force, at->trial, &at->tangent);
    return at->trial;
  }
  const double sign = shear == TP_FACET_SLIPS_ALONG ? -1 : 1;
  const tp_three presses = combined(s->stiffness_from + s->stiffness_between, &at->from,
                                    s->stiffness_between + s->stiffness_to, &at->to);
  add_outer(&sum->stiffness, sign * facet->friction, &at->tangent, &presses);
  add(&sum->force, sign * at->limit, &at->tangent);
  return sign * at->limit;
}

static void add_facet(tp_imbalance *sum, tp_facet_state *state, const tp_balance *b, long k,
                      const tp_path_pose *pose) {
  const tp_joint_facet *facet = b->model->facets + k;
  const double ratio = b->model->shear_ratio, slip = b->slips[k];
  facet_at at = place_facet(facet, pose);
  const tp_facet_stress *s = &at.stress;
  const double closed_length = facet->length * s->closed;
  at.trial = -ratio * closed_length * (at.shear - slip);
  at.doubt = DBL_EPSILON * ratio * closed_length * (sizes(&at.tangent, &pose->moved) + fabs(slip));
  const tp_facet_shear shear = shear_of(&at);
  add_outer(&sum->stiffness, s->stiffness_from, &at.from, &at.from);
  add_outer(&sum->stiffness, s->stiffness_between, &at.from, &at.to);
  add_outer(&sum->stiffness, s->stiffness_between, &at.to, &at.from);
  add_outer(&sum->stiffness, s->stiffness_to, &at.to, &at.to);
  add(&sum->force, s->force_from, &at.from);
  add(&sum->force, s->force_to, &at.to);
  const double shear_force = add_shear(sum, &at, shear, facet, ratio, slip);
  sum->rounding +=
      DBL_EPSILON * ((s->stiffness_from + s->stiffness_between) * sizes(&at.from, &pose->moved) +
                     (s->stiffness_between + s->stiffness_to) * sizes(&at.to, &pose->moved));
  if (shear == TP_FACET_STICKS) sum->rounding += at.doubt;
  if (state == NULL) return;
  *state = (tp_facet_state){.from_closed = at.closure_from > 0,
                            .to_closed = at.closure_to > 0 && !facet->in_a_point,
                            .shear = shear,
                            .force_from = s->force_from,
                            .force_to = s->force_to,
                            .shear_force = shear_force,
                            .closed = s->closed,
                            .slip = shear == TP_FACET_STICKS ? slip
                                    : shear == TP_FACET_OPEN
                                        ? at.shear
                                        : at.shear + shear_force / (ratio * closed_length)};
}

typedef struct centroid {
  tp_three x, y, turn; /* how it moves along x and y, and turns */
} centroid;

static centroid centroid_in(const tp_path_frame *frame) {
  const tp_xy at = {0, 0};
  return (centroid){.x = tp_path_along(frame, (tp_xy){1, 0}, at),
                    .y = tp_path_along(frame, (tp_xy){0, 1}, at),
                    .turn = {{0, 0, 1}}};
}

tp_matrix tp_path_inertia(const tp_path_model *model, const tp_path_frame *frame) {
  const centroid own = centroid_in(frame);
  tp_matrix inertia = {{{0}}};
  add_outer(&inertia, 1, &own.x, &own.x);
  add_outer(&inertia, 1, &own.y, &own.y);
  add_outer(&inertia, model->square_gyration, &own.turn, &own.turn);
  return inertia;
}

/* The load, and the moment of the weight as it moves with the centroid. */
static void add_load(tp_imbalance *sum, const tp_balance *b, const tp_path_pose *pose) {
  const double *load = b->load.of, moves = b->model->moves;
  const centroid own = centroid_in(&pose->frame);
  const tp_three arm = combined(load[1], &own.x, -load[0], &own.y);
  add(&sum->force, load[0], &own.x);
  add(&sum->force, load[1], &own.y);
  add(&sum->force, load[2] + moves * tp_three_product(&arm, &pose->moved), &own.turn);
  add_outer(&sum->stiffness, -moves, &own.turn, &arm);
  sum->rounding += DBL_EPSILON * 4 * tp_three_size(&b->load);
}

static void add_drag(tp_imbalance *sum, const tp_balance *b, const tp_path_pose *pose) {
  const tp_matrix inertia = tp_path_inertia(b->model, &pose->frame);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      const double drag = inertia.of[i][j] * pose->since.of[j] / b->over_time;
      sum->force.of[i] -= drag;
      sum->stiffness.of[i][j] += inertia.of[i][j] / b->over_time;
      sum->rounding += DBL_EPSILON * fabs(drag);
    }
  }
}

void tp_balance_at(tp_imbalance *imbalance, const tp_balance *balance, const tp_path_pose *pose,
                   tp_facet_state *states) {
  *imbalance = (tp_imbalance){0};
  add_load(imbalance, balance, pose);
  for (long k = 0; k < balance->model->count; k++) {
    add_facet(imbalance, states == NULL ? NULL : states + k, balance, k, pose);
  }
  if (balance->over_time > 0) add_drag(imbalance, balance, pose);
}
