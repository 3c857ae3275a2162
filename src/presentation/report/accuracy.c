/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of methods and precisions with time, bound and true error, as text and as JSON; errors
 * below the range of doubles are printed from their logarithms. */

#include "common/host.h"
#include "output/encode.h"
#include "report/converge.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>

/* 1.2e-15 of a logarithm, which goes on where doubles end; rounded up. */
static const char *power(char out[TP_NUMBER_SIZE], double log10_value) {
  if (!isfinite(log10_value)) {
    snprintf(out, TP_NUMBER_SIZE, "0");
    return out;
  }
  double exponent = floor(log10_value);
  double head = ceil(10 * pow(10, log10_value - exponent)) / 10;
  if (head >= 10) {
    head /= 10;
    exponent++;
  }
  snprintf(out, TP_NUMBER_SIZE, "%.1fe%.0f", head, exponent);
  return out;
}

static void add_time(tp_text *t, double seconds) {
  static const struct {
    double least, factor;
    const char *unit;
  } units[] = {{1, 1, "s "}, {1e-3, 1e3, "ms"}, {1e-6, 1e6, "µs"}, {0, 1e9, "ns"}};
  int k = 0;
  while (seconds < units[k].least) k++;
  const double value = seconds * units[k].factor;
  tp_text_add(t, "%8.*f %s", value < 10 ? 2 : value < 100 ? 1 : 0, value, units[k].unit);
}

static void add_run(tp_text *t, const tp_accuracy_run *run, bool sweep) {
  char n[2][TP_NUMBER_SIZE];
  if (sweep) tp_text_add(t, "%10zu  ", run->vertices);
  tp_text_add(t, "%-25s%-12s %5ld ", tp_accuracy_method_name(run->method),
              tp_level_name(run->level), run->bits);
  add_time(t, run->seconds);
  tp_text_add(t, " %10s %10s\n", run->has_bound ? power(n[0], run->bound_log10) : "none",
              power(n[1], run->true_error_log10));
}

/* By how much the models of a rounded corner part: an error of the model that no arithmetic
 * mends. */
static void add_models(tp_text *t, const tp_accuracy *a) {
  const tp_accuracy_value *of[TP_ACCURACY_METHODS] = {NULL};
  char n[TP_NUMBER_SIZE];
  if (a->sweep) return;
  for (size_t k = 0; k < a->value_count; k++) of[a->values[k].method] = a->values + k;
  tp_text_add(t, "\nResults\n");
  for (size_t k = 0; k < a->value_count; k++) {
    const tp_accuracy_value *value = a->values + k;
    tp_text_add(t, "  %-25s%s°%s\n", tp_accuracy_method_name(value->method),
                tp_text_significant(n, value->angle_deg, 15),
                value->method == TP_ACCURACY_BOUNDARY && of[TP_ACCURACY_ROUNDED_PAPER] != NULL
                    ? ", corners treated as sharp"
                    : "");
  }
}

tp_status tp_report_accuracy(char **text, const tp_accuracy *a) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, a);
  tp_text t = {0};
  if (a->title != NULL) {
    tp_encode_plain(&t, a->title);
    tp_text_add(&t, "\n\n");
  }
  tp_text_add(&t,
              a->sweep ? "Cost of accuracy on rough blocks of growing size, towards "
                         "the left:\nangles in degrees, against their exact values\n\n%10s  "
                       : "Cost of accuracy, towards the %s: angles in degrees, "
                         "against their\nexact values\n\n",
              a->sweep ? "vertices" : tp_direction_name(a->towards));
  tp_text_add(&t, "%-25s%-12s %5s %11s %10s %10s\n", "method", "arithmetic", "bits", "time",
              "bound", "true error");
  for (size_t k = 0; k < a->run_count; k++) {
    const bool first = k == 0 || a->runs[k].method != a->runs[k - 1].method;
    if (first) tp_text_add(&t, "\n");
    add_run(&t, a->runs + k, a->sweep);
  }
  add_models(&t, a);
  if (a->simulated != NULL) {
    const char *engine = tp_tilt_engine_name(a->simulated->settings.engine);
    const char *quantity = tp_converge_quantity_name(a->simulated->quantity);
    tp_text_add(&t, "\nDependence of its simulated test on the settings, by %s: the %s\n", engine,
                quantity);
    tp_text_convergence(&t, a->simulated);
  }
  return tp_text_finish(&t, text);
}
