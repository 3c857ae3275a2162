/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tilts at which a moment or a force vanishes, and the one at which a block begins to move: of
 * zeros that are told apart (load/zeros.h, load/isolate.h), the first that rises above level. */

#ifndef TP_LOAD_ROOTS_H
#define TP_LOAD_ROOTS_H

#include <arb.h>
#include <stdbool.h>

/* The functions of load/wrench.h times cos^2 are trigonometric polynomials of degree 3, with at
 * most 6 zeros in a turn. */
enum { TP_ROOTS_MAX = 8 };

typedef struct tp_roots {
  long count; /* ascending, in (-90, 90) degrees */
  arb_struct degrees[TP_ROOTS_MAX];
  bool rising[TP_ROOTS_MAX]; /* from below zero to above */
  bool certain;              /* all zeros are found, and no other */
} tp_roots;

void tp_roots_init(tp_roots *roots);
void tp_roots_clear(tp_roots *roots);

/* Keep a zero, in ascending order. */
void tp_roots_keep(tp_roots *roots, const arb_t radians, bool rising, long bits);

/* The tilt at which what is stable below zero first begins to move as the table is tilted from
 * level: the first rising zero above level; where it is not stable level, the last one below. False
 * where there is none: `*always` says that it is never stable. `*level` is the value at level
 * ground. */
bool tp_roots_critical(arb_t degrees, bool *always, tp_roots *roots, const arb_t level);

#endif
