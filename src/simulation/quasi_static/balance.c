/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Residual and Jacobian of the three equations of equilibrium from the integrals of each facet,
 * with stick, slip and a bound of the rounding (docs/tilt_path.md); quasi_static/solve.c finds the
 * zero. */

#include "quasi_static/balance.h"

#include "quasi_static/facet_stress.h"

#include <float.h>
#include <math.h>

/* A shear force within this share of Coulomb's limit is at it: that of a facet that slips is
 * computed anew from its own strain, and comes out with the rounding of some ten operations. */
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
  const tp_facet_lines *lines;
  double closure_from, closure_to;
  tp_facet_stress stress;
  double force, limit;  /* normal; of the shear force */
  double strain, trial; /* of the shear springs without slip; the force that it would make, */
  double doubt;         /* and what rounding may make of that */
} facet_at;

static facet_at place_facet(const tp_joint_facet *facet, const tp_facet_lines *lines,
                            const tp_three *moved) {
  facet_at at = {.lines = lines};
  at.closure_from = facet->locked_from - tp_three_product(&lines->from, moved);
  at.closure_to = facet->locked_to - tp_three_product(&lines->to, moved);
  at.stress = tp_facet_stress_of(facet->length, facet->in_a_point, at.closure_from, at.closure_to);
  at.force = at.stress.force_from + at.stress.force_to;
  at.limit = facet->friction * at.force;
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
                        const tp_joint_facet *facet, double ratio) {
  const tp_facet_stress *s = &at->stress;
  if (shear == TP_FACET_OPEN) return 0;
  if (shear == TP_FACET_STICKS) {
    const tp_three closes =
        combined(s->closed_by_from, &at->lines->from, s->closed_by_to, &at->lines->to);
    add_outer(&sum->stiffness, ratio * facet->length * s->closed, &at->lines->tangent,
              &at->lines->tangent);
    add_outer(&sum->stiffness, -ratio * facet->length * at->strain, &at->lines->tangent, &closes);
    add(&sum->force, at->trial, &at->lines->tangent);
    return at->trial;
  }
  const double sign = shear == TP_FACET_SLIPS_ALONG ? -1 : 1;
  const tp_three presses = combined(s->stiffness_from + s->stiffness_between, &at->lines->from,
                                    s->stiffness_between + s->stiffness_to, &at->lines->to);
  add_outer(&sum->stiffness, sign * facet->friction, &at->lines->tangent, &presses);
  add(&sum->force, sign * at->limit, &at->lines->tangent);
  return sign * at->limit;
}

static void add_facet(tp_imbalance *sum, tp_facet_state *state, const tp_balance *b, long k,
                      const tp_path_pose *pose) {
  const tp_joint_facet *facet = b->model->facets + k;
  const tp_facet_lines *lines = b->lines->facets + k;
  const double ratio = b->model->shear_ratio;
  facet_at at = place_facet(facet, lines, &pose->moved);
  const tp_facet_stress *s = &at.stress;
  const double closed_length = facet->length * s->closed;
  at.strain = b->strains[k] + tp_three_product(&lines->tangent, &pose->since);
  at.trial = -ratio * closed_length * at.strain;
  at.doubt = DBL_EPSILON * ratio * closed_length *
             (sizes(&lines->tangent, &pose->since) + fabs(b->strains[k]));
  const tp_facet_shear shear = shear_of(&at);
  add_outer(&sum->stiffness, s->stiffness_from, &lines->from, &lines->from);
  add_outer(&sum->stiffness, s->stiffness_between, &lines->from, &lines->to);
  add_outer(&sum->stiffness, s->stiffness_between, &lines->to, &lines->from);
  add_outer(&sum->stiffness, s->stiffness_to, &lines->to, &lines->to);
  add(&sum->force, s->force_from, &lines->from);
  add(&sum->force, s->force_to, &lines->to);
  const double shear_force = add_shear(sum, &at, shear, facet, ratio);
  sum->rounding += DBL_EPSILON *
                   ((s->stiffness_from + s->stiffness_between) * sizes(&lines->from, &pose->moved) +
                    (s->stiffness_between + s->stiffness_to) * sizes(&lines->to, &pose->moved));
  if (shear == TP_FACET_STICKS) sum->rounding += at.doubt;
  if (state == NULL) return;
  *state =
      (tp_facet_state){.from_closed = at.closure_from > 0,
                       .to_closed = at.closure_to > 0 && !facet->in_a_point,
                       .shear = shear,
                       .force_from = s->force_from,
                       .force_to = s->force_to,
                       .shear_force = shear_force,
                       .closed = s->closed,
                       .strain = shear == TP_FACET_STICKS ? at.strain
                                 : shear == TP_FACET_OPEN ? 0
                                                          : -shear_force / (ratio * closed_length)};
}

static bool same(const tp_xy *a, const tp_xy *b) {
  return a->x == b->x && a->y == b->y;
}

static bool is_of(const tp_path_lines *lines, const tp_path_frame *frame) {
  const tp_path_frame *own = &lines->frame;
  return same(&own->first, &frame->first) && same(&own->second, &frame->second) &&
         same(&own->normal, &frame->normal) && same(&own->other, &frame->other);
}

void tp_path_lines_set(tp_path_lines *lines, const tp_path_model *model,
                       const tp_path_frame *frame) {
  if (is_of(lines, frame)) return;
  lines->frame = *frame;
  lines->x = tp_path_along(frame, (tp_xy){1, 0}, (tp_xy){0, 0});
  lines->y = tp_path_along(frame, (tp_xy){0, 1}, (tp_xy){0, 0});
  for (long k = 0; k < model->count; k++) {
    const tp_joint_facet *facet = model->facets + k;
    lines->facets[k] =
        (tp_facet_lines){.from = tp_path_along(frame, facet->normal, facet->from),
                         .to = tp_path_along(frame, facet->normal, facet->to),
                         .tangent = tp_path_along(frame, facet->tangent, facet->from)};
  }
}

static const tp_three turn = {{0, 0, 1}};

/* The load, and the moment of the weight as it moves with the centroid. */
static void add_load(tp_imbalance *sum, const tp_balance *b, const tp_path_pose *pose) {
  const double *load = b->load.of, moves = b->model->moves;
  const tp_path_lines *lines = b->lines;
  const tp_three arm = combined(load[1], &lines->x, -load[0], &lines->y);
  add(&sum->force, load[0], &lines->x);
  add(&sum->force, load[1], &lines->y);
  add(&sum->force, load[2] + moves * tp_three_product(&arm, &pose->moved), &turn);
  add_outer(&sum->stiffness, -moves, &turn, &arm);
  sum->rounding += DBL_EPSILON * 4 * tp_three_size(&b->load);
}

static void add_drag(tp_imbalance *sum, const tp_balance *b, const tp_path_pose *pose) {
  tp_matrix inertia = {{{0}}};
  add_outer(&inertia, 1, &b->lines->x, &b->lines->x);
  add_outer(&inertia, 1, &b->lines->y, &b->lines->y);
  add_outer(&inertia, b->model->square_gyration, &turn, &turn);
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
