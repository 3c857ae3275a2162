/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The outline of a block in a picture, in pixels from the upper left corner: x to the right, y
 * down, pixel (0, 0) from 0 to 1. */

#ifndef TP_TRACE_REGION_H
#define TP_TRACE_REGION_H

#include "trace/picture.h"

typedef struct tp_trace_point {
  double x, y;
} tp_trace_point;

/* A closed chain of points. */
typedef struct tp_trace_ring {
  long count, room;
  tp_trace_point *points;
} tp_trace_ring;

TP_MUST_USE bool tp_trace_ring_add(tp_trace_ring *ring, tp_trace_point point);
void tp_trace_ring_clear(tp_trace_ring *ring);
/* With its sign: above zero where it runs clockwise as it is seen. */
double tp_trace_ring_area(const tp_trace_ring *ring);
double tp_trace_ring_length(const tp_trace_ring *ring);

/* What the segmentation of a picture found. */
typedef struct tp_picture_region {
  tp_trace_ring contour; /* along edges of pixels of the picture that was worked on, clockwise */
  int step;              /* pixels of the picture in one of those, along a side */
  double touching;       /* share of the contour that lies on that of the rough polygon */
} tp_picture_region;

/* The largest part within the rough polygon that is unlike what lies around it, without holes. The
 * picture is cut out and made smaller, to at most half a million pixels, before. */
TP_MUST_USE tp_status tp_region_find(tp_picture_region *region, const tp_trace_picture *picture,
                                     const tp_trace_ring *rough, const char *name,
                                     tp_message *message);

#endif
