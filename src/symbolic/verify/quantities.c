/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The quantities that claims may be about: derived from the block, its pivot and its base.
 *
 * area               of the section, holes taken off, parts weighted by relative density
 * x_arm, y_arm       lever arms of the weight about the pivot (docs/mechanics.md section 3)
 * critical_angle     atan2(x_arm, y_arm)
 * fos                x_arm cot alpha / y_arm: the resultant form, Eq. (2)
 * fos_elements       by elements, each moment on its own side, (A1.3)
 * stabilising_moment, overturning_moment
 *                    the sums of moments by elements, with the weights w_1, w_2, … as symbols:
 * slabs first, the farthest up-dip first, then triangles likewise, (A1.1) stabilising_area_moment,
 * overturning_area_moment the same with the elements' areas for their weights rounding_length the l
 * at which the block topples at alpha, (A2.4) corner_radius      the radius that this l belongs to,
 * (A2.6) facet_angle        of the facet at the pivot to the mean plane, positive: Eq. (7)
 * mean_square_slope  (1/L) int (dy/dx)^2 dx over the contact: the square of Eq. (13)'s root
 * block_width, mean_height, amplitude
 *                    along the mean plane; area over width; of the contact, peak to valley
 *
 * With a rounded corner everything but `rounding_length` and `corner_radius` is about the axis
 * where rounding puts it. Which side a moment is on is decided with the sharp corner, at the
 * scene's values. */

#include "verify/quantities.h"

#include "verify/quantity_rules.h"

#include <string.h>

bool tp_quantities_add(tp_subject *s) {
  static const struct {
    const char *name;
    tp_name_kind kind;
    tp_quantity_rule rule;
  } quantities[] = {
      {"area", TP_NAME_FORMULA, tp_quantity_area},
      {"x_arm", TP_NAME_FORMULA, tp_quantity_critical_angle},
      {"y_arm", TP_NAME_FORMULA, tp_quantity_y_arm},
      {"critical_angle", TP_NAME_DIRECTION, tp_quantity_critical_angle},
      {"fos", TP_NAME_FORMULA, tp_quantity_fos},
      {"fos_elements", TP_NAME_FORMULA, tp_quantity_fos_elements},
      {"stabilising_moment", TP_NAME_FORMULA, tp_quantity_stabilising},
      {"overturning_moment", TP_NAME_FORMULA, tp_quantity_overturning},
      {"stabilising_area_moment", TP_NAME_FORMULA, tp_quantity_stabilising_area},
      {"overturning_area_moment", TP_NAME_FORMULA, tp_quantity_overturning_area},
      {"rounding_length", TP_NAME_FORMULA, tp_quantity_rounding_length},
      {"corner_radius", TP_NAME_FORMULA, tp_quantity_corner_radius},
      {"facet_angle", TP_NAME_DIRECTION, tp_quantity_facet_angle},
      {"mean_square_slope", TP_NAME_FORMULA, tp_quantity_mean_square_slope},
      {"block_width", TP_NAME_FORMULA, tp_quantity_block_width},
      {"mean_height", TP_NAME_FORMULA, tp_quantity_mean_height},
      {"amplitude", TP_NAME_FORMULA, tp_quantity_amplitude},
  };
  for (size_t k = 0; k < sizeof quantities / sizeof quantities[0]; k++) {
    tp_name *name = tp_subject_add_name(s, quantities[k].name, quantities[k].kind);
    if (name == NULL) return false;
    name->rule = quantities[k].rule;
    name->ready = false;
  }
  return true;
}

bool tp_quantities_example_values(tp_subject *s) {
  const long alpha = s->angles[TP_ANGLE_ALPHA].degrees;
  const tp_name *width = NULL;
  if (!s->given[alpha]) fmpq_set_si(s->values + alpha, 20, 1);
  fmpq_set_si(s->values + s->angles[TP_ANGLE_I].degrees, 10, 1); /* where no facet says otherwise */
  const long index = tp_subject_find(s, "block_width", strlen("block_width"));
  if (s->has_model && index >= 0 && tp_subject_name(&width, s, index, NULL) == TP_OK &&
      tp_field_evaluate(s->values + s->length, width->value, s->field)) {
    fmpz_t fifty;
    fmpz_init_set_ui(fifty, 50);
    fmpq_div_fmpz(s->values + s->length, s->values + s->length, fifty);
    fmpz_clear(fifty);
  }
  return !s->has_model || tp_quantity_example_weights(s);
}
