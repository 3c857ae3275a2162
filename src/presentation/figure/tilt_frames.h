/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The frames of a tilt test (report/tilt_frames.c) on paper: the same drawing by Cairo. */

#ifndef TP_FIGURE_TILT_FRAMES_H
#define TP_FIGURE_TILT_FRAMES_H

#include "figure/paper.h"

/* The test, and the language that it is drawn in; kept until it is drawn. */
typedef struct tp_tilt_drawing {
  const tp_tilt_test *test;
  const tp_language *language;
  bool comma;
} tp_tilt_drawing;

tp_vector_picture tp_tilt_frames_drawing(const tp_tilt_drawing *drawing);

#endif
