/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With W the sum of all loads and n the pushes of ground, W = -sum of f n where forces f >= 0 hold
 * the blocks: so that n . v >= 0 for all of them gives W . v <= 0. The v that ground allows are a
 * cone, of which the edges run along faces of ground: these are tried, either way, and no others,
 * as nothing is lost but time. */

#include "assemblage/common_slide.h"

#include <math.h>

enum { MOST_LINES = 32 };

/* The push of ground by a column, on the one block that it has. */
static bool push_of(double push[2], const tp_force_column *c) {
  if ((c->row[0] < 0) == (c->row[1] < 0)) return false;
  const int side = c->row[0] < 0 ? 1 : 0;
  push[0] = c->entry[side][0].value;
  push[1] = c->entry[side][1].value;
  return true;
}

/* Are all pushes of ground along v, or at right angles to it? */
static bool is_free(const tp_force_program *p, const double v[2]) {
  static const double within = 1e-14;
  for (long k = 0; k < p->count; k++) {
    double push[2];
    if (!push_of(push, p->columns + k)) continue;
    const double power = push[0] * v[0] + push[1] * v[1];
    if (power < -within * hypot(push[0], push[1]) * hypot(v[0], v[1])) return false;
  }
  return true;
}

static void sum_loads(double sum[2], double *size, const tp_force_program *p, double load) {
  sum[0] = sum[1] = *size = 0;
  for (long b = 0; b < p->rows / 3; b++) {
    for (int axis = 0; axis < 2; axis++) {
      const double own = p->dead[3 * b + axis].value + load * p->live[3 * b + axis].value;
      sum[axis] += own;
      *size += fabs(own);
    }
  }
}

bool tp_common_slide(const tp_force_program *p, double load) {
  static const double little = 1e-9, alike = 1e-12;
  double lines[MOST_LINES][2], loads[2], size = 0;
  int count = 0;
  sum_loads(loads, &size, p, load);
  for (long k = 0; k < p->count && count < MOST_LINES; k++) {
    double push[2];
    if (!push_of(push, p->columns + k)) continue;
    const double length = hypot(push[0], push[1]);
    const double line[2] = {-push[1] / length, push[0] / length};
    bool is_new = true;
    for (int l = 0; l < count && is_new; l++) {
      is_new = fabs(lines[l][0] * line[1] - lines[l][1] * line[0]) > alike;
    }
    if (!is_new) continue;
    const double power = loads[0] * line[0] + loads[1] * line[1];
    const double v[2] = {power < 0 ? -line[0] : line[0], power < 0 ? -line[1] : line[1]};
    if (fabs(power) > little * size && is_free(p, v)) return true;
    lines[count][0] = line[0];
    lines[count++][1] = line[1];
  }
  return false;
}
