/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "study/dynamic_border.h"

#include <math.h>

static const double degree = 57.29577951308232;

double tp_dynamic_border_deg(double delta_deg, double kappa, double friction_deg) {
  return delta_deg + atan(tan((friction_deg - delta_deg) / degree) / kappa) * degree;
}

/* Do all contact points lie on one level, with no facet between them that does not? */
static bool is_planar(const tp_case *own) {
  for (size_t k = 0; k < own->pivot_count; k++) {
    const tp_pivot *p = own->pivots + k;
    if (p->kind != TP_PIVOT_FLAT_END || p->rounded) return false;
    if (fabs(p->y_m.value - own->pivots[0].y_m.value) > p->y_m.error + own->pivots[0].y_m.error) {
      return false;
    }
  }
  return own->pivot_count > 0;
}

bool tp_dynamic_border_of(double *delta_deg, double *kappa, const tp_solution *solution,
                          const tp_case *own) {
  if (solution->loaded || !own->has_governing || !is_planar(own)) return false;
  const tp_block_result *b = &solution->block;
  const tp_pivot *toe = own->pivots + own->governing;
  const double x = b->centroid_x_m.value - toe->x_m.value,
               y = b->centroid_y_m.value - toe->y_m.value;
  const double gyration =
      (b->second_moment_xx_m4.value + b->second_moment_yy_m4.value) / b->area_m2.value;
  *kappa = gyration / (gyration + x * x + y * y);
  *delta_deg = toe->critical_angle_deg.value;
  return *delta_deg > 0 && *kappa > 0;
}
