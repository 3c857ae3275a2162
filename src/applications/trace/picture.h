/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A picture in memory: three bytes a pixel, from the upper left corner, turned as its EXIF says, so
 * as viewers show it. PNG of any kind by libpng, over white where it is transparent; JPEG by
 * libjpeg. A file of at most 256 MiB, and 100 million pixels; what is broken is refused, not
 * repaired. */

#ifndef TP_TRACE_PICTURE_H
#define TP_TRACE_PICTURE_H

#include "common/message.h"
#include "output/sha256.h"

enum { TP_PICTURE_BYTES = 1 << 28, TP_PICTURE_PIXELS = 100000000, TP_PICTURE_SIDE = 32767 };

typedef struct tp_trace_picture {
  int width, height;
  unsigned char *rgb;
  uint8_t hash[TP_SHA256_SIZE]; /* of the file, where it was read from one */
} tp_trace_picture;

TP_MUST_USE tp_status tp_picture_read(tp_trace_picture *picture, const char *path,
                                      tp_message *message);
TP_MUST_USE tp_status tp_picture_read_bytes(tp_trace_picture *picture, const unsigned char *bytes,
                                            size_t length, const char *name, tp_message *message);
void tp_picture_clear(tp_trace_picture *picture);

/* For the reader: a JPEG; and which way it is to be turned, 1 to 8 as EXIF counts. */
TP_MUST_USE tp_status tp_picture_read_jpeg(tp_trace_picture *picture, const unsigned char *bytes,
                                           size_t length, const char *name, tp_message *message);
int tp_picture_orientation(const unsigned char *bytes, size_t length);

/* A picture of that size, of which not all may be read; false with a message. */
TP_MUST_USE tp_status tp_picture_check_size(unsigned long width, unsigned long height,
                                            const char *name, tp_message *message);

#endif
