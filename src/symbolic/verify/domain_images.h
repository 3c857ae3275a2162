/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Symbols of a domain in terms of one number t > 0 each (verify/domain.h), for which the symbol
 * itself stands. */

#ifndef TP_VERIFY_DOMAIN_IMAGES_H
#define TP_VERIFY_DOMAIN_IMAGES_H

#include "verify/subject.h"

/* Bounds of a symbol, open; `has_…` false: none. */
typedef struct tp_domain_bounds {
  long symbol;
  bool has_low, has_high;
  fmpz_mpoly_q_t low, high;
} tp_domain_bounds;

/* By symbol; what is free takes any value and has no image. */
typedef struct tp_images {
  const tp_field *field;
  bool *free;
  fmpz_mpoly_q_struct *of;
} tp_images;

/* Every symbol its own image; false when memory is exhausted. */
TP_MUST_USE bool tp_images_init(tp_images *images, const tp_field *field);
void tp_images_clear(tp_images *images);

/* Sine and cosine of an angle between two in [-180, 180), 180: by t, for which the sine stands. */
void tp_images_set_angle(tp_images *images, const tp_angle *angle, const fmpq_t low,
                         const fmpq_t high);

/* The symbol in terms of its own t. Where a denominator may not be positive the symbol is free:
 * nothing is then proven about it, and points alone tell. */
void tp_images_set_symbol(tp_images *images, const tp_domain_bounds *bounds);

#endif
