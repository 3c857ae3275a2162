/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Drawings of a tilt test as SVG, shared by the one with frames and the one that moves. All units
 * of the drawing are such that the block's extent is 100; y grows downwards. */

#ifndef TP_REPORT_TILT_SVG_H
#define TP_REPORT_TILT_SVG_H

#include "output/language.h"
#include "output/text.h"

typedef struct tp_tilt_view {
  const tp_tilt_case *own;
  double scale;                    /* units per metre */
  double left, top, width, height; /* of what is seen; the block's centroid starts at (0, 0) */
  size_t moments; /* the first so many have all of the block in view; later it is far away */
} tp_tilt_view;

tp_tilt_view tp_tilt_view_of(const tp_tilt_case *own);

/* How far the block comes between a moment and the one before, in extents and radians. */
double tp_tilt_view_way(const tp_tilt_view *view, size_t moment);

/* Numbers of the drawing. */
double tp_tilt_view_x(const tp_tilt_view *view, double x_m);
double tp_tilt_view_y(const tp_tilt_view *view, double y_m);
/* Degrees, clockwise as SVG has them, by which the table is turned at a tilt. */
double tp_tilt_view_turn(const tp_tilt_view *view, double angle_deg);

/* The moments of the frames that are drawn side by side, rising; how many there are. */
enum { TP_TILT_FRAMES = 6 };
size_t tp_tilt_frames_choose(size_t chosen[TP_TILT_FRAMES], const tp_tilt_view *view);

/* What stands above a row of frames and below one, in a language. */
void tp_tilt_frames_head(tp_text *t, const tp_tilt_test *test, const tp_tilt_case *own,
                         const tp_language *language, bool comma);
void tp_tilt_frames_foot(tp_text *t, const tp_tilt_test *test, const tp_tilt_moment *moment,
                         const tp_language *language, bool comma);
TP_MUST_USE tp_status tp_tilt_frames_svg(char **text, const tp_tilt_test *test,
                                         const tp_language *language, bool comma);

/* The way around the points, as the attribute d of a path. */
void tp_tilt_svg_ring(tp_text *t, const tp_tilt_view *view, const tp_tilt_point *points,
                      size_t count);
void tp_tilt_svg_begin(tp_text *t, double width, double height);

#endif
