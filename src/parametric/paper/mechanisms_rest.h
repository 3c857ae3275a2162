/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What begins from rest, in the mechanism maps of a planar and of a rough base: where one motion
 * takes over from another, from the modes of motion of exact blocks. */

#ifndef TP_PAPER_MECHANISMS_REST_H
#define TP_PAPER_MECHANISMS_REST_H

#include "chart/chart.h"

typedef struct tp_mechanisms_rest {
  tp_chart *chart;
  const tp_chart_mechanisms_options *options;
  const char *panel;     /* its key */
  double x_most, y_most; /* of the map: inverse slenderness, tilt in degrees */
} tp_mechanisms_rest;

/* Slabs on a plane. */
TP_MUST_USE tp_status tp_mechanisms_rest_planar(const tp_mechanisms_rest *rest,
                                                tp_message *message);

/* Sawtooth blocks with flanks of the roughness angle and the amplitude, so that their flanks are
 * a = A / tan(i) wide and their widths whole multiples of 2 a: about a peak and about a valley.
 * None where there are no such teeth, or more than 3000 flanks in the width of the map. */
TP_MUST_USE tp_status tp_mechanisms_rest_rough(const tp_mechanisms_rest *rest, tp_message *message);

#endif
