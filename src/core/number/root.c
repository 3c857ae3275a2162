/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Brent's method of the GNU Scientific Library, and bisection where that no longer narrows the
 * bracket.
 *
 * This file and number/series.c call the GNU Scientific Library. Where that meets what it refuses
 * it calls a handler of the process, which ends it unless the program has set another: the handler
 * is none of ours to change, and is never called. For what is refused is kept from it: ends out of
 * order, signs that do not differ and values that are no numbers (a search that comes upon one ends
 * with the step that did, to which it is told as 0); and it is asked for no memory, as the state of
 * its method, whose type is public, is kept on the stack. */

#include "number/root.h"

#include <gsl/gsl_roots.h>
#include <math.h>
#include <stddef.h>

/* More than Brent's method needs, which is 8 doubles in GSL 2.7. */
enum { STATE_DOUBLES = 32 };

typedef struct samples {
  const tp_root_search *search;
  tp_root_end low, high, last; /* the ends of the range, and where it was sampled last */
  int count;
  bool failed;
} samples;

static double sample(double x, void *context) {
  samples *taken = context;
  if (x == taken->low.x) return taken->low.value;
  if (x == taken->high.x) return taken->high.value;
  taken->count++;
  taken->last = (tp_root_end){x, NAN};
  taken->failed = !(x > taken->low.x && x < taken->high.x) ||
                  !taken->search->value(&taken->last.value, taken->search->context, x) ||
                  !isfinite(taken->last.value);
  return taken->failed ? 0 : taken->last.value;
}

static bool is_flat(const tp_root_search *s, double value) {
  return fabs(value) <= s->flat;
}

static bool is_narrow(const tp_root *root, double width) {
  const double middle = root->low + (root->high - root->low) / 2;
  return root->high - root->low <= width || middle == root->low || middle == root->high;
}

/* Where the method says that two doubles are next to each other though one may lie between. */
static void halve(tp_root *root, samples *taken) {
  const double middle = root->low + (root->high - root->low) / 2;
  const double value = sample(middle, taken);
  *((value < 0) == (taken->low.value < 0) ? &root->low : &root->high) = middle;
}

static bool narrow(tp_root *root, gsl_root_fsolver *solver, samples *taken) {
  const tp_root_search *s = taken->search;
  while (!is_narrow(root, s->width)) {
    const int before = taken->count;
    if (before >= s->most) return false;
    (void)gsl_root_fsolver_iterate(solver);
    if (taken->count > before) {
      root->low = solver->x_lower;
      root->high = solver->x_upper;
    } else {
      halve(root, taken);
    }
    if (taken->failed) return false;
    if (is_flat(s, taken->last.value)) {
      *root = (tp_root){taken->last.x, taken->last.x, true};
      return true;
    }
  }
  return true;
}

bool tp_root_find(tp_root *root, const tp_root_search *search, tp_root_end low, tp_root_end high) {
  double state[STATE_DOUBLES];
  if (!(low.x < high.x && isfinite(high.x - low.x))) return false;
  if (!isfinite(low.value) || !isfinite(high.value)) return false;
  if (is_flat(search, low.value) || is_flat(search, high.value)) {
    const double x = is_flat(search, low.value) ? low.x : high.x;
    *root = (tp_root){x, x, true};
    return true;
  }
  if ((low.value < 0) == (high.value < 0) || gsl_root_fsolver_brent->size > sizeof state) {
    return false;
  }
  samples taken = {.search = search, .low = low, .high = high};
  gsl_function function = {sample, &taken};
  gsl_root_fsolver solver = {.type = gsl_root_fsolver_brent, .state = state};
  if (gsl_root_fsolver_set(&solver, &function, low.x, high.x) != 0) return false;
  tp_root own = {low.x, high.x, false};
  if (!narrow(&own, &solver, &taken)) return false;
  *root = own;
  return true;
}
