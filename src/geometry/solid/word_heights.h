/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exact comparisons of heights of a solid whose coordinates fit into words. Numbers are those of
 * GMP: the first large one of FLINT costs as much as all else that a solid of few faces needs. */

#ifndef TP_SOLID_WORD_HEIGHTS_H
#define TP_SOLID_WORD_HEIGHTS_H

#include "solid/word_turns.h"

#include <gmp.h>

/* The centroid M / (4 V6). */
typedef struct tp_word_centre {
  mpz_t weight4, moment[3];
} tp_word_centre;

/* Within all of a surface that has words; to be cleared. */
void tp_word_centre_init(tp_word_centre *centre, const tp_surface *surface);
void tp_word_centre_clear(tp_word_centre *centre);

/* The sign of the height over the plane of three vertices less that over another, both above 0. The
 * vertices may be those of another surface on the same lattice, which has words. */
int tp_word_centre_compare(const tp_word_centre *centre, const tp_surface *surface,
                           const int one[3], const int other[3]);

#endif
