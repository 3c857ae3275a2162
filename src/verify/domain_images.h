/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Symbols of a domain in terms of one number t > 0 each (verify/domain.h). */

#ifndef TP_DOMAIN_IMAGES_H
#define TP_DOMAIN_IMAGES_H

#include "verify/domain.h"

/* Sine and cosine of an angle between two in [-180, 180), 180: by t, for which the sine stands. */
void tp_domain_image_angle(tp_domain *domain, const tp_angle *angle, const fmpq_t low,
                           const fmpq_t high);

/* The symbol in terms of its own t. Where a denominator may not be positive the symbol is free:
 * nothing is then proven about it, and points alone tell. */
void tp_domain_image_symbol(tp_domain *domain, const tp_bounds *bounds);

#endif
