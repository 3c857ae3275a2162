/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What holds a face, by the balls of its columns: cohesion and bonds, each at its bound where the
 * motion works against it, and the forces of the two columns that span it (face.h). */

#include "certificate/face.h"

static bool in_no_face(const tp_face *face, long column) {
  return column != face->columns[0] && column != face->columns[1];
}

/* K: what cohesion and bonds hold against the twist, each at its bound where the motion works
 * against it. */
void tp_face_find_resistance(tp_face *face, const tp_cones *cones, const tp_judge *judge) {
  tp_vector column;
  arb_t power, most, zero;
  tp_vector_init(&column);
  arb_init(power);
  arb_init(most);
  arb_init(zero);
  arb_zero(face->resistance);
  const long first = 2 * cones->count, count = tp_cones_column_count(cones);
  for (long k = first; k < count; k++) {
    tp_cones_column(column.of, cones, k, judge->precision);
    tp_vector_dot(power, &face->twist, &column, judge->precision);
    arb_neg(power, power);
    face->full[k - first] = in_no_face(face, k) && arb_is_positive(power);
    /* one that may do no work is in the bound of K both at its bound and not (take_idle) */
    if (!arb_contains_zero(power)) arb_max(power, power, zero, judge->precision);
    tp_cones_bound(most, cones, k);
    arb_addmul(face->resistance, power, most, judge->bits);
  }
  tp_vector_clear(&column);
  arb_clear(power);
  arb_clear(most);
  arb_clear(zero);
}

void tp_face_settle_capacities(tp_face *face, const tp_cones *cones, const bool *at_most,
                               const tp_judge *judge) {
  const long first = 2 * cones->count, count = tp_cones_column_count(cones);
  tp_vector column;
  arb_t power;
  tp_vector_init(&column);
  arb_init(power);
  for (long k = first; k < count; k++) {
    if (!at_most[k] || face->full[k - first] || !in_no_face(face, k)) continue;
    tp_cones_column(column.of, cones, k, judge->precision);
    tp_vector_dot(power, &face->twist, &column, judge->precision);
    face->full[k - first] = arb_contains_zero(power) != 0;
  }
  tp_vector_clear(&column);
  arb_clear(power);
}

void tp_face_add_capacities(tp_vector *wrench, const tp_face *face, const tp_cones *cones,
                            const tp_judge *judge) {
  const long first = 2 * cones->count, count = tp_cones_column_count(cones);
  tp_vector column;
  arb_t most;
  tp_vector_init(&column);
  arb_init(most);
  for (long k = first; k < count; k++) {
    if (!face->full[k - first]) continue;
    tp_cones_column(column.of, cones, k, judge->precision);
    tp_cones_bound(most, cones, k);
    for (int row = 0; row < 3; row++) {
      arb_addmul(wrench->of + row, column.of + row, most, judge->bits);
    }
  }
  tp_vector_clear(&column);
  arb_clear(most);
}

/* R = f_0 c_0 + f_1 c_1: with n = c_0 x c_1, f_0 = (R x c_1) . n / n^2, f_1 = (c_0 x R) . n / n^2.
 */
void tp_face_forces(arb_ptr factors, const tp_face *face, const tp_cones *cones,
                    const tp_vector *wrench, const tp_judge *judge) {
  tp_vector rest, cross;
  arb_t size;
  tp_vector_init(&rest);
  tp_vector_init(&cross);
  arb_init(size);
  for (int row = 0; row < 3; row++) arb_set(rest.of + row, wrench->of + row);
  if (cones->capacity_count > 0) tp_face_add_capacities(&rest, face, cones, judge);
  tp_vector_neg(&rest);
  tp_vector_dot(size, &face->normal, &face->normal, judge->precision);
  for (int k = 0; k < 2; k++) {
    if (k == 0) {
      tp_vector_cross(&cross, &rest, face->edges + 1, judge->precision);
    } else {
      tp_vector_cross(&cross, face->edges, &rest, judge->precision);
    }
    tp_vector_dot(factors + k, &cross, &face->normal, judge->precision);
    arb_div(factors + k, factors + k, size, judge->bits);
  }
  tp_vector_clear(&rest);
  tp_vector_clear(&cross);
  arb_clear(size);
}
