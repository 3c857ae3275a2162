/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Newton's method for the balance. The forces are smooth but for borders between stick and slip
 * and where an end of a stuck facet opens; there a step is halved until it lessens the imbalance.
 * Which pose is found, where there are several, is that near the start: steps are kept short by who
 * calls. */

#include "quasi_static/balance.h"

#include <math.h>

/* The imbalance that is aimed at, over the weight; rounding may leave some more, but for poses so
 * far off that it could leave this much. */
static const double aim = 1e-13, most_rounding = 1e-11;

enum { MOST_STEPS = 40, MOST_HALVINGS = 12 };

static double largest(const tp_three *x) {
  return fmax(fabs(x->of[0]), fmax(fabs(x->of[1]), fabs(x->of[2])));
}

static double length_of(const tp_three *x) {
  return sqrt(x->of[0] * x->of[0] + x->of[1] * x->of[1] + x->of[2] * x->of[2]);
}

static void swap_rows(double a[3][4], int i, int j) {
  for (int k = 0; k < 4; k++) {
    const double kept = a[i][k];
    a[i][k] = a[j][k];
    a[j][k] = kept;
  }
}

/* Upper triangular, with the sign of its determinant: 0 where it is singular. */
static int eliminate(double a[3][4]) {
  int sign = 1;
  for (int k = 0; k < 3; k++) {
    int pivot = k;
    for (int i = k + 1; i < 3; i++) {
      if (fabs(a[i][k]) > fabs(a[pivot][k])) pivot = i;
    }
    if (pivot != k) {
      swap_rows(a, k, pivot);
      sign = -sign;
    }
    if (a[k][k] == 0) return 0;
    if (a[k][k] < 0) sign = -sign;
    for (int i = k + 1; i < 3; i++) {
      const double factor = a[i][k] / a[k][k];
      for (int j = k; j < 4; j++) a[i][j] -= factor * a[k][j];
    }
  }
  return sign;
}

static void fill(double a[3][4], const tp_matrix *matrix, const tp_three *right) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) a[i][j] = matrix->of[i][j];
    a[i][3] = right->of[i];
  }
}

bool tp_matrix_solve(tp_three *x, const tp_matrix *matrix, const tp_three *right) {
  double a[3][4];
  fill(a, matrix, right);
  if (eliminate(a) == 0) return false;
  for (int i = 2; i >= 0; i--) {
    double sum = a[i][3];
    for (int j = i + 1; j < 3; j++) sum -= a[i][j] * x->of[j];
    x->of[i] = sum / a[i][i];
  }
  return isfinite(largest(x));
}

/* One step of Newton's method, halved until the step that would follow by the same stiffness is
 * shorter: a measure that does not depend on the units of forces and moments, which close to a
 * limit are of very different sizes (the natural monotonicity test; Deuflhard, Newton Methods for
 * Nonlinear Problems, 2004, section 3.3). Not `careful`: taken whole, across borders of stick and
 * slip at which every shorter one looks worse. */
static bool step(tp_path_pose *pose, tp_imbalance *imbalance, const tp_balance *balance,
                 bool careful) {
  const tp_matrix stiffness = imbalance->stiffness;
  tp_three move, next_move;
  if (!tp_matrix_solve(&move, &stiffness, &imbalance->force)) return false;
  const double length = length_of(&move);
  double part = 1;
  for (int k = 0; k < MOST_HALVINGS; k++, part /= 2) {
    tp_path_pose next = *pose;
    tp_path_pose_add(&next, part, &move);
    tp_balance_at(imbalance, balance, &next, NULL);
    if (!careful || (tp_matrix_solve(&next_move, &stiffness, &imbalance->force) &&
                     length_of(&next_move) <= (1 - part / 4) * length)) {
      *pose = next;
      return true;
    }
  }
  return false;
}

/* One step more, which costs little and often leaves rounding alone. */
static void polish(tp_path_pose *pose, double *left, tp_imbalance *imbalance,
                   const tp_balance *balance) {
  tp_path_pose next = *pose;
  if (!step(&next, imbalance, balance, true) || largest(&imbalance->force) >= *left) return;
  *left = largest(&imbalance->force);
  *pose = next;
}

static bool solve(tp_path_pose *pose, double *left, const tp_balance *balance, bool careful) {
  tp_path_pose at = *pose;
  tp_imbalance imbalance;
  tp_balance_at(&imbalance, balance, &at, NULL);
  for (int k = 0; k < MOST_STEPS; k++) {
    *left = largest(&imbalance.force);
    if (*left <= aim + 2 * imbalance.rounding && imbalance.rounding <= most_rounding) {
      *pose = at;
      polish(pose, left, &imbalance, balance);
      return true;
    }
    if (!step(&at, &imbalance, balance, careful)) return false;
  }
  return false;
}

bool tp_balance_solve(tp_path_pose *pose, double *left, const tp_balance *balance) {
  return solve(pose, left, balance, true) || solve(pose, left, balance, false);
}

bool tp_matrix_is_positive(const tp_matrix *matrix) {
  double a[3][4];
  fill(a, matrix, &(tp_three){{0}});
  return eliminate(a) > 0;
}
