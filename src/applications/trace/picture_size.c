/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bounds of a picture's width, height and pixels, shared by the readers of PNG and JPEG. */

#include "trace/picture.h"

tp_status tp_picture_check_size(unsigned long width, unsigned long height, const char *name,
                                tp_message *message) {
  if (width == 0 || height == 0) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){name, 0, 0}, "a picture without pixels");
  }
  if (width <= TP_PICTURE_SIDE && height <= TP_PICTURE_SIDE &&
      width * height <= TP_PICTURE_PIXELS) {
    return TP_OK;
  }
  return tp_refuse(
      message, TP_FAULT_RANGE, (tp_place){name, 0, 0},
      "%lu by %lu pixels; pictures of at most 100 million are read, and 32767 on a side: "
      "cut out what shows the block, or make it smaller",
      width, height);
}
