/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What samples of rare events are drawn from: unit normal densities around centres, each with a
 * share, and one around the origin that is wider than the variables' own, which bounds the weights
 * where no centre is near (Hesterberg's defensive mixture, Technometrics 37 (1995) 185-194). A
 * sample's weight is the variables' density over that of the whole mixture, whichever part it was
 * drawn from. */

#ifndef TP_STATISTICS_MIXTURE_H
#define TP_STATISTICS_MIXTURE_H

#include "common/message.h"

#include <stdint.h>

enum { TP_MIXTURE_CENTRES = 64 };

typedef struct tp_mixture {
  size_t dimensions, count; /* count: of the centres; 0: the wide part alone */
  double *centres;
  double shares[TP_MIXTURE_CENTRES]; /* of the centres among each other: they add up to 1 */
  double wide;                       /* the share of the wide part, */
  double spread;                     /* and its deviations */
} tp_mixture;

/* `centres` are copied, and each has a share by its distance b, exp(-b^2 / 2). Left to
 * tp_mixture_clear. */
TP_MUST_USE tp_status tp_mixture_init(tp_mixture *mixture, const double *centres, size_t count,
                                      size_t dimensions, tp_message *message);
void tp_mixture_clear(tp_mixture *mixture);

/* One more, while there is room; with an equal share. */
void tp_mixture_add(tp_mixture *mixture, const double *centre);

/* Point number k of a stream. */
void tp_mixture_draw(const tp_mixture *mixture, double *z, uint64_t stream, uint64_t k);

/* The variables' density over that of the mixture; and the part that each centre has in the latter,
 * where `parts` is not NULL. */
double tp_mixture_weight(const tp_mixture *mixture, const double *z, double *parts);

/* The largest weight that a centre has: of failures that the centres are the design points of, none
 * weighs much more. */
double tp_mixture_expected(const tp_mixture *mixture);

#endif
