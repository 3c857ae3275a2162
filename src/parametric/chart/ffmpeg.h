/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Frames into a moving picture by ffmpeg. */

#ifndef TP_CHART_FFMPEG_H
#define TP_CHART_FFMPEG_H

#include "topple_basics.h"

typedef enum tp_video_format { TP_VIDEO_WEBM, TP_VIDEO_GIF } tp_video_format;

/* Frames a second of each format: a GIF counts in hundredths. */
double tp_video_rate(tp_video_format format);

/* `frames` are PNGs, one behind the other, all of one size with even sides. `*video` is allocated
 * with malloc; the same frames are the same bytes. TP_SYSTEM_FAILED where ffmpeg is not installed,
 * or fails. */
TP_MUST_USE tp_status tp_ffmpeg_run(char **video, size_t *length, const char *frames,
                                    size_t frames_length, tp_video_format format,
                                    tp_message *message);

#endif
