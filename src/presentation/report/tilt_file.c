/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes the drawing of a tilt test by the ending of its file name: frames or animation as SVG,
 * video as WebM or GIF. */

#include "common/host.h"
#include "output/file.h"
#include "report/tilt_video.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef enum kind { AS_FRAMES, AS_SVG, AS_WEBM, AS_GIF, AS_NONE } kind;

static kind kind_of(const char *path, bool moving) {
  const char *ending = strrchr(path, '.');
  if (ending == NULL) return AS_NONE;
  if (strcasecmp(ending, ".svg") == 0) return moving ? AS_SVG : AS_FRAMES;
  if (moving && strcasecmp(ending, ".webm") == 0) return AS_WEBM;
  if (moving && strcasecmp(ending, ".gif") == 0) return AS_GIF;
  return AS_NONE;
}

static tp_status draw(char **data, size_t *size, const tp_tilt_test *test, kind of,
                      tp_message *message) {
  if (of == AS_WEBM || of == AS_GIF) {
    return tp_tilt_video(data, size, test, of == AS_GIF ? TP_VIDEO_GIF : TP_VIDEO_WEBM, message);
  }
  const tp_status status =
      of == AS_SVG ? tp_report_tilt_animation(data, test) : tp_report_tilt_frames(data, test);
  if (status == TP_OUT_OF_MEMORY) return tp_fail_memory(message, "the drawing");
  if (status == TP_OK) *size = strlen(*data);
  return status;
}

tp_status tp_report_tilt_file(const char *path, const tp_tilt_test *test, bool moving,
                              tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, test);
  TP_REFUSE_NULL(message, path);
  const kind of = kind_of(path, moving);
  if (of == AS_NONE) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     moving ? "a drawing that moves is SVG, WebM or GIF: give a name that ends in "
                              ".svg, .webm or .gif"
                            : "drawings of a tilt test are SVG: give a name that ends in .svg");
  }
  char *data = NULL;
  size_t size = 0;
  tp_status status = draw(&data, &size, test, of, message);
  if (status == TP_OK) {
    status = tp_file_write(path, data, size, (tp_file_sources){0, NULL}, message);
  }
  free(data);
  return status;
}
