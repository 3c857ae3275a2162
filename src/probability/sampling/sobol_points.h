/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The points of Sobol' (1967) in up to 40 dimensions, 52 binary places each: primitive polynomials
 * and first direction numbers of Bratley and Fox (Algorithm 659, ACM Trans. Math. Softw. 14 (1988)
 * 88-100), in the order of Antonov and Saleev, so that the first 30 places are those of
 * gsl_qrng_sobol of the GNU Scientific Library, which cannot begin at a point but the first. Point
 * 0 is the origin; any 2^m in a row from a multiple of 2^m fall once into each of 2^m equal strata
 * of a dimension. */

#ifndef TP_SAMPLING_SOBOL_POINTS_H
#define TP_SAMPLING_SOBOL_POINTS_H

#include <stddef.h>
#include <stdint.h>

enum { TP_SOBOL_BITS = 52, TP_SOBOL_DIMENSIONS = 40 };

/* The direction numbers of a dimension below TP_SOBOL_DIMENSIONS. */
void tp_sobol_directions(uint64_t directions[TP_SOBOL_BITS], size_t dimension);

/* A coordinate of a point below 2^52, in steps of 2^-52. */
uint64_t tp_sobol_coordinate(const uint64_t directions[TP_SOBOL_BITS], uint64_t point);

/* By which direction the point after this one differs from it. */
unsigned tp_sobol_step(uint64_t point);

#endif
