/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* JPEG by libjpeg, which tells of errors by a jump; warnings, as of data that end too early, are
 * errors here. */

#include "trace/picture.h"

#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jpeglib.h>

enum { MOST_SCANS = 200 }; /* of a progressive one, each of which costs a pass over all pixels */

typedef struct reader {
  struct jpeg_error_mgr errors; /* first, so that libjpeg's pointer is one of this */
  struct jpeg_progress_mgr progress;
  jmp_buf back;
  char text[JMSG_LENGTH_MAX];
} reader;

static void leave(j_common_ptr info) {
  reader *r = (reader *)info->err;
  if (r->text[0] == '\0') info->err->format_message(info, r->text);
  longjmp(r->back, 1);
}

static void heed(j_common_ptr info, int level) {
  if (level < 0) leave(info);
}

static void be_silent(j_common_ptr info) {
  (void)info;
}

static void count_scans(j_common_ptr info) {
  const j_decompress_ptr own = (j_decompress_ptr)info;
  reader *r = (reader *)info->err;
  if (own->input_scan_number <= MOST_SCANS) return;
  snprintf(r->text, sizeof r->text, "it has more than 200 scans");
  leave(info);
}

static tp_status refuse(const reader *r, const char *name, tp_message *message) {
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){name, 0, 0},
                   "a broken JPEG: %s; save it again from where it comes", r->text);
}

/* What libjpeg has taken is given back by its caller, whichever way this ends. */
static tp_status decode(struct jpeg_decompress_struct *info, reader *r, tp_trace_picture *picture,
                        const char *name, tp_message *message) {
  if (setjmp(r->back) != 0) return refuse(r, name, message);
  (void)jpeg_read_header(info, TRUE);
  const tp_status status =
      tp_picture_check_size(info->image_width, info->image_height, name, message);
  if (status != TP_OK) return status;
  info->out_color_space = JCS_RGB;
  info->dct_method = JDCT_ISLOW;
  (void)jpeg_start_decompress(info);
  const size_t stride = 3 * (size_t)info->output_width;
  picture->width = (int)info->output_width;
  picture->height = (int)info->output_height;
  picture->rgb = malloc(stride * info->output_height);
  if (picture->rgb == NULL) return tp_fail_memory(message, "a picture");
  while (info->output_scanline < info->output_height) {
    JSAMPROW row = picture->rgb + stride * info->output_scanline;
    (void)jpeg_read_scanlines(info, &row, 1);
  }
  (void)jpeg_finish_decompress(info);
  return TP_OK;
}

tp_status tp_picture_read_jpeg(tp_trace_picture *picture, const unsigned char *bytes, size_t length,
                               const char *name, tp_message *message) {
  struct jpeg_decompress_struct info = {0};
  reader r = {.text = ""};
  info.err = jpeg_std_error(&r.errors);
  r.errors.error_exit = leave;
  r.errors.emit_message = heed;
  r.errors.output_message = be_silent;
  r.progress.progress_monitor = count_scans;
  if (setjmp(r.back) != 0) return tp_fail_memory(message, "a picture");
  jpeg_create_decompress(&info);
  info.progress = &r.progress;
  jpeg_mem_src(&info, bytes, length);
  const tp_status status = decode(&info, &r, picture, name, message);
  jpeg_destroy_decompress(&info);
  return status;
}

/* ---- EXIF --------------------------------------------------------------------------------------
 */

typedef struct exif {
  const unsigned char *bytes;
  size_t length;
  bool little;
} exif;

static unsigned long number_at(const exif *e, size_t at, int size) {
  unsigned long value = 0;
  if (at + (size_t)size > e->length) return 0;
  for (int k = 0; k < size; k++) value = value << 8 | e->bytes[at + (e->little ? size - 1 - k : k)];
  return value;
}

/* In the first directory of a TIFF: the tag 274. */
static int find_orientation(exif *e) {
  enum { ENTRY = 12, ORIENTATION = 274 };
  if (e->length < 8) return 1;
  e->little = e->bytes[0] == 'I';
  const size_t directory = number_at(e, 4, 4);
  if (directory > e->length - 2) return 1;
  const size_t count = number_at(e, directory, 2);
  for (size_t k = 0; k < count && directory + 2 + ENTRY * (k + 1) <= e->length; k++) {
    const size_t at = directory + 2 + ENTRY * k;
    if (number_at(e, at, 2) == ORIENTATION) return (int)number_at(e, at + 8, 2);
  }
  return 1;
}

int tp_picture_orientation(const unsigned char *bytes, size_t length) {
  size_t at = 2;
  while (at + 4 <= length && bytes[at] == 0xff && bytes[at + 1] != 0xda) {
    const size_t size = (size_t)bytes[at + 2] << 8 | bytes[at + 3];
    if (size < 2 || at + 2 + size > length) return 1;
    if (bytes[at + 1] == 0xe1 && size >= 16 && memcmp(bytes + at + 4, "Exif\0\0", 6) == 0) {
      exif own = {bytes + at + 10, size - 8, false};
      return find_orientation(&own);
    }
    at += 2 + size;
  }
  return 1;
}
