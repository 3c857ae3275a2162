/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Welford's recurrence for mean and squares, and an estimate kept whenever the number of samples
 * doubles. */

#include "statistics/convergence.h"

#include "statistics/proportion.h"
#include "statistics/score.h"

#include <math.h>

tp_convergence tp_convergence_begin(bool proportion, double confidence) {
  return (tp_convergence){.proportion = proportion, .confidence = confidence};
}

tp_estimate tp_convergence_now(const tp_convergence *c) {
  if (c->proportion) return tp_proportion(c->hits, c->samples, c->confidence);
  if (c->samples < 2) return (tp_estimate){c->mean, -INFINITY, INFINITY};
  const double n = (double)c->samples;
  const double half = tp_student_score(c->confidence, n - 1) * sqrt(c->squares / (n - 1) / n);
  return (tp_estimate){c->mean, c->mean - half, c->mean + half};
}

void tp_convergence_add(tp_convergence *c, double value) {
  const double apart = value - c->mean;
  c->samples++;
  if (value != 0) c->hits++;
  c->mean += apart / (double)c->samples;
  c->squares += apart * (value - c->mean);
  const bool doubled = (c->samples & (c->samples - 1)) == 0;
  if (!doubled || c->count == TP_CONVERGENCE_POINTS) return;
  c->points[c->count++] = (tp_convergence_point){c->samples, tp_convergence_now(c)};
}
