/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit_states.h"

#include <check.h>
#include <gsl/gsl_errno.h>
#include <math.h>

static void refuse(const char *reason, const char *file, int line, int number) {
  ck_abort_msg("%s:%d: GSL's handler was called: %s (%d)", file, line, reason, number);
}

void refuse_gsl(void) {
  gsl_set_error_handler(refuse);
}

void near(double value, double truth, double room) {
  ck_assert_msg(fabs(value - truth) <= room, "%.15g for %.15g", value, truth);
}

static tp_status evaluate(double *g, void *context, const double *x, size_t count,
                          tp_message *message) {
  limit_state *own = context;
  (void)message;
  for (size_t k = 0; k < count; k++) g[k] = own->g(x + k * own->n, own->of, own->n);
  own->points += count;
  return TP_OK;
}

tp_reliability problem_of(limit_state *own, const tp_distribution *variables,
                          const double *correlation) {
  return (tp_reliability){own->n, variables, correlation, evaluate, own};
}

tp_form found(const tp_reliability *problem) {
  const tp_form_options options = tp_form_options_default();
  const limit_state *own = problem->context;
  const uint64_t before = own->points;
  tp_form form;
  tp_message message = {.text = ""};
  ck_assert_msg(tp_form_find(&form, problem, &options, &message) == TP_OK, "%s", message.text);
  ck_assert_uint_eq(form.calls, own->points - before);
  double square = 0, shares = 0;
  for (size_t k = 0; k < form.dimensions; k++) square += form.scores[k] * form.scores[k];
  for (size_t k = 0; k < form.dimensions; k++) shares += form.importance[k];
  near(sqrt(square), fabs(form.beta), 1e-12);
  if (form.state == TP_FORM_CONVERGED) near(shares, 1, 1e-12);
  return form;
}

double plane(const double *x, const double *of, size_t n) {
  double g = of[n];
  for (size_t k = 0; k < n; k++) g += of[k] * x[k];
  return g;
}

double sphere(const double *x, const double *of, size_t n) {
  double square = 0;
  for (size_t k = 0; k < n; k++) square += (x[k] - of[k]) * (x[k] - of[k]);
  return of[n] * of[n] - square;
}

double gap(const double *x, const double *of, size_t n) {
  return x[0] > of[n - 1] ? NAN : 5 - x[0];
}
