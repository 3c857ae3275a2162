/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does the moment of one load about a pivot vanish, exactly? A load whose line passes through the
 * pivot turns nothing, but the ball of its moment contains zero at any number of bits.
 *
 * The load acts at a rational point, by components that are rationals times functions of the tilt,
 * all up to one positive factor. So its moment is such a sum, too, with one of the pairs cos a and
 * sin a, 1 / cos a and 1 / cos^2 a, or a constant: it is zero where its rationals are, or where
 * they cancel at a tilt of 0, 45 or 60 degrees. At no other rational angle is the tangent or the
 * cosine rational (Niven). The same of the direction of an anchor. */

#ifndef TP_LOAD_VANISH_H
#define TP_LOAD_VANISH_H

#include "load/loads.h"

/* In metres, x mirrored towards the right as in tp_load_setting. */
typedef struct tp_exact_setting {
  const tp_scene *scene;
  const tp_wetted *wetted;
  bool mirrored;
  bool has_centroid; /* of the weight: known exactly */
  fmpq_t x, y;
  fmpq_t heel_x, heel_y, toe_x, toe_y; /* of the base joint, where there is water */
  fmpq_t pivot_x, pivot_y;
} tp_exact_setting;

void tp_exact_setting_init(tp_exact_setting *setting, const tp_scene *scene, bool mirrored);
void tp_exact_setting_clear(tp_exact_setting *setting);

/* All of a load, or of a weight (a surcharge, too) its part normal to the base or along it. */
typedef enum tp_load_part { TP_LOAD_WHOLE, TP_WEIGHT_NORMAL, TP_WEIGHT_PARALLEL } tp_load_part;

/* At a tilt in degrees, or at every tilt (NULL); false where it does not, or where that is not
 * known exactly. */
bool tp_load_vanishes(const tp_load *load, tp_load_part part, const tp_exact_setting *setting,
                      const fmpq *tilt_deg);

#endif
