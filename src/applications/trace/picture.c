/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Decodes PNG by libpng's simplified interface and JPEG by libjpeg, and turns the pixels by the
 * EXIF orientation. */

#include "trace/picture.h"
#include "common/input_file.h"

#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

void tp_picture_clear(tp_trace_picture *picture) {
  free(picture->rgb);
  *picture = (tp_trace_picture){0};
}

static tp_status fail(const char *name, const char *what, tp_message *message) {
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){name, 0, 0}, "%s", what);
}

/* ---- PNG ---------------------------------------------------------------------------------------
 */

static tp_status read_png(tp_trace_picture *picture, const unsigned char *bytes, size_t length,
                          const char *name, tp_message *message) {
  png_image image = {.version = PNG_IMAGE_VERSION};
  const png_color white = {255, 255, 255};
  if (png_image_begin_read_from_memory(&image, bytes, length) == 0) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){name, 0, 0}, "a broken PNG: %s",
                     image.message);
  }
  tp_status status = tp_picture_check_size(image.width, image.height, name, message);
  image.format = PNG_FORMAT_RGB;
  if (status == TP_OK) {
    picture->rgb = malloc((size_t)PNG_IMAGE_SIZE(image));
    if (picture->rgb == NULL) status = tp_fail_memory(message, "a picture");
  }
  if (status == TP_OK && (png_image_finish_read(&image, &white, picture->rgb, 0, NULL) == 0 ||
                          PNG_IMAGE_FAILED(image))) {
    status = tp_refuse(message, TP_FAULT_FORMAT, (tp_place){name, 0, 0},
                       "a broken PNG: %s; save it again from where it comes", image.message);
  }
  picture->width = (int)image.width;
  picture->height = (int)image.height;
  png_image_free(&image);
  return status;
}

/* ---- which way round ---------------------------------------------------------------------------
 */

/* Where pixel (x, y) of the picture that is turned was. */
static size_t source_of(const tp_trace_picture *from, int orientation, int x, int y) {
  const int w = from->width, h = from->height;
  const bool swapped = orientation >= 5;
  int u = swapped ? y : x, v = swapped ? x : y;
  if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8) u = w - 1 - u;
  if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7) v = h - 1 - v;
  return 3 * ((size_t)v * (size_t)w + (size_t)u);
}

static tp_status turn(tp_trace_picture *picture, int orientation, tp_message *message) {
  if (orientation < 2 || orientation > 8) return TP_OK;
  const bool swapped = orientation >= 5;
  tp_trace_picture own = {.width = swapped ? picture->height : picture->width,
                          .height = swapped ? picture->width : picture->height};
  own.rgb = malloc(3 * (size_t)own.width * (size_t)own.height);
  if (own.rgb == NULL) return tp_fail_memory(message, "a picture");
  unsigned char *to = own.rgb;
  for (int y = 0; y < own.height; y++) {
    for (int x = 0; x < own.width; x++, to += 3) {
      memcpy(to, picture->rgb + source_of(picture, orientation, x, y), 3);
    }
  }
  free(picture->rgb);
  *picture = own;
  return TP_OK;
}

/* ---- files -------------------------------------------------------------------------------------
 */

tp_status tp_picture_read_bytes(tp_trace_picture *picture, const unsigned char *bytes,
                                size_t length, const char *name, tp_message *message) {
  static const unsigned char png[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  static const unsigned char jpeg[] = {0xff, 0xd8, 0xff};
  tp_status status = TP_OK;
  *picture = (tp_trace_picture){0};
  if (length >= sizeof png && memcmp(bytes, png, sizeof png) == 0) {
    status = read_png(picture, bytes, length, name, message);
  } else if (length >= sizeof jpeg && memcmp(bytes, jpeg, sizeof jpeg) == 0) {
    status = tp_picture_read_jpeg(picture, bytes, length, name, message);
    if (status == TP_OK) status = turn(picture, tp_picture_orientation(bytes, length), message);
  } else {
    status =
        fail(name, "this is neither a PNG nor a JPEG; save the picture as one of them", message);
  }
  if (status != TP_OK) tp_picture_clear(picture);
  return status;
}

static tp_status read_all(unsigned char **bytes, size_t *length, FILE *file, const char *path,
                          tp_message *message) {
  struct stat about;
  if (fstat(fileno(file), &about) != 0) return tp_fail_file(message, path, "read", errno);
  if (!S_ISREG(about.st_mode)) return fail(path, "is not a regular file", message);
  if (about.st_size > TP_PICTURE_BYTES) {
    return fail(path, "is larger than 256 MiB; cut out what shows the block", message);
  }
  *bytes = malloc((size_t)about.st_size + 1);
  if (*bytes == NULL) return tp_fail_memory(message, "a picture");
  *length = fread(*bytes, 1, (size_t)about.st_size, file);
  return ferror(file) == 0 ? TP_OK : tp_fail_file(message, path, "read", errno);
}

tp_status tp_picture_read(tp_trace_picture *picture, const char *path, tp_message *message) {
  unsigned char *bytes = NULL;
  size_t length = 0;
  *picture = (tp_trace_picture){0};
  FILE *file = NULL;
  tp_status status = tp_input_open(&file, path, message);
  if (status != TP_OK) return status;
  status = read_all(&bytes, &length, file, path, message);
  fclose(file);
  if (status == TP_OK) status = tp_picture_read_bytes(picture, bytes, length, path, message);
  if (status == TP_OK) tp_sha256(picture->hash, bytes, length);
  free(bytes);
  return status;
}
