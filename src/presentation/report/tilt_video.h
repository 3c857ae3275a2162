/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The drawing that moves as WebM or GIF: frames by gnuplot, one after the other, and ffmpeg. */

#ifndef TP_REPORT_TILT_VIDEO_H
#define TP_REPORT_TILT_VIDEO_H

#include "chart/ffmpeg.h"
#include "topple_tilt_test.h"

/* `*video` is allocated with malloc. */
TP_MUST_USE tp_status tp_tilt_video(char **video, size_t *length, const tp_tilt_test *test,
                                    tp_video_format format, tp_message *message);

#endif
