/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Brent's method of the GNU Scientific Library, whose handler of errors is never called
 * (number/root.c): what it refuses is kept from it, and its state is kept on the stack. */

#include "number/minimum.h"

#include <gsl/gsl_min.h>
#include <math.h>
#include <stddef.h>

/* More than Brent's method needs, which is 6 doubles in GSL 2.7. */
enum { STATE_DOUBLES = 32 };

bool tp_minimum_narrow(tp_minimum *m, tp_minimum_function function, void *context, double width,
                       int most) {
  double state[STATE_DOUBLES];
  const bool ordered = m->low < m->x && m->x < m->high && isfinite(m->high - m->low);
  const bool least = m->value < m->low_value && m->value < m->high_value;
  if (!ordered || !least || !isfinite(m->low_value) || !isfinite(m->high_value)) return false;
  if (gsl_min_fminimizer_brent->size > sizeof state) return false;
  gsl_function own = {function, context};
  gsl_min_fminimizer solver = {.type = gsl_min_fminimizer_brent, .state = state};
  if (gsl_min_fminimizer_set_with_values(&solver, &own, m->x, m->value, m->low, m->low_value,
                                         m->high, m->high_value) != 0) {
    return false;
  }
  for (int k = 0; k < most && solver.x_upper - solver.x_lower > width; k++) {
    if (gsl_min_fminimizer_iterate(&solver) != 0) break;
  }
  *m = (tp_minimum){solver.x_lower, solver.x_minimum, solver.x_upper,
                    solver.f_lower, solver.f_minimum, solver.f_upper};
  return true;
}
