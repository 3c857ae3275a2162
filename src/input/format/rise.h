/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is kept of an object of a drawing whose points have a z (format/standing.h). */

#ifndef TP_FORMAT_RISE_H
#define TP_FORMAT_RISE_H

#include "plane/polyline.h"

#include <flint/fmpq.h>

typedef struct tp_rise {
  fmpq_t z;         /* of the first point */
  bool changes;     /* along it */
  double off;       /* how far a point lies beside the plane, where one was chosen, */
  tp_mark off_mark; /* and which */
} tp_rise;

/* Of a first point with that z; NULL when memory is exhausted. */
tp_rise *tp_rise_new(const fmpq_t z);
void tp_rise_free(tp_rise *rise);

#endif
