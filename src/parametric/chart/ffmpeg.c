/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments of ffmpeg for WebM (VP9) and GIF, with options that make the same bytes each time, run
 * by chart/program.h. */

#include "chart/ffmpeg.h"

#include "chart/program.h"

double tp_video_rate(tp_video_format format) {
  return format == TP_VIDEO_GIF ? 12.5 : 25;
}

/* VP9 of a quality at which edges are clean. */
static const char *const webm[] = {
    "ffmpeg",     "-hide_banner", "-loglevel",  "error",      "-nostdin",  "-f",
    "image2pipe", "-c:v",         "png",        "-framerate", "25",        "-i",
    "pipe:0",     "-c:v",         "libvpx-vp9", "-crf",       "30",        "-b:v",
    "0",          "-deadline",    "good",       "-cpu-used",  "5",         "-threads",
    "1",          "-pix_fmt",     "yuv420p",    "-fflags",    "+bitexact", "-flags:v",
    "+bitexact",  "-f",           "webm",       "pipe:1",     NULL};

/* A palette for each frame: one for all would hold all frames in memory. */
static const char palettes[] = "split[a][b];[a]palettegen=stats_mode=single:max_colors=64[p];"
                               "[b][p]paletteuse=new=1:dither=none";
static const char *const gif[] = {"ffmpeg",     "-hide_banner",
                                  "-loglevel",  "error",
                                  "-nostdin",   "-f",
                                  "image2pipe", "-c:v",
                                  "png",        "-framerate",
                                  "12.5",       "-i",
                                  "pipe:0",     "-filter_complex",
                                  palettes,     "-threads",
                                  "1",          "-fflags",
                                  "+bitexact",  "-f",
                                  "gif",        "pipe:1",
                                  NULL};

tp_status tp_ffmpeg_run(char **video, size_t *length, const char *frames, size_t frames_length,
                        tp_video_format format, tp_message *message) {
  const tp_plot_program program = {
      .name = "ffmpeg",
      .arguments = format == TP_VIDEO_GIF ? gif : webm,
      .input = frames,
      .input_length = frames_length,
      .where_missing = "which makes WebM and GIF of frames, is not installed: 'apt-get install "
                       "ffmpeg' on Debian; an animation as .svg needs none"};
  return tp_program_run(video, length, &program, message);
}
