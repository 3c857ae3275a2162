/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Photographs in JPEG: as libjpeg wrote them, turned as a camera notes that it was held, cut off at
 * every length. The story: points are told as a viewer shows them, which turns the picture; half a
 * picture from a messenger must be no block cut in half. */

#include "suite.h"
#include "trace/picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jpeglib.h>

enum { WIDTH = 48, HEIGHT = 32, CORNER = 8 };

/* Corners from the upper left, clockwise as they are seen, each of a colour of its own on white. */
static const unsigned char colours[4][3] = {{255, 0, 0}, {0, 160, 0}, {0, 0, 255}, {0, 0, 0}};

static void paint(unsigned char *rgb) {
  memset(rgb, 255, 3 * (size_t)WIDTH * HEIGHT);
  for (int y = 0; y < HEIGHT; y++) {
    for (int x = 0; x < WIDTH; x++) {
      const bool left = x < CORNER, right = x >= WIDTH - CORNER;
      const bool top = y < CORNER, bottom = y >= HEIGHT - CORNER;
      const int corner = top      ? (left    ? 0
                                     : right ? 1
                                             : -1)
                         : bottom ? (left    ? 3
                                     : right ? 2
                                             : -1)
                                  : -1;
      if (corner >= 0) memcpy(rgb + 3 * (y * WIDTH + x), colours[corner], 3);
    }
  }
}

/* With a note of EXIF where `orientation` is above zero, the numbers of either order of bytes. */
static void add_exif(struct jpeg_compress_struct *info, int orientation, bool little) {
  unsigned char note[] = {'E', 'x', 'i', 'f', 0, 0, 'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1,
                          1,   18,  0,   3,   0, 0, 0,   1,   0, 0,  0, 0, 0, 0, 0, 0};
  if (orientation == 0) return;
  note[25] = (unsigned char)orientation;
  if (little) {
    static const unsigned char own[] = {'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0, 18, 1, 3, 0, 1, 0, 0, 0};
    memcpy(note + 6, own, sizeof own);
    note[24] = (unsigned char)orientation;
    note[25] = 0;
  }
  jpeg_write_marker(info, JPEG_APP0 + 1, note, sizeof note);
}

static unsigned char *encode(unsigned long *length, int orientation, bool little) {
  struct jpeg_compress_struct info;
  struct jpeg_error_mgr errors;
  unsigned char rgb[3 * WIDTH * HEIGHT], *bytes = NULL;
  paint(rgb);
  *length = 0;
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  jpeg_mem_dest(&info, &bytes, length);
  info.image_width = WIDTH;
  info.image_height = HEIGHT;
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 95, TRUE);
  jpeg_start_compress(&info, TRUE);
  add_exif(&info, orientation, little);
  for (int y = 0; y < HEIGHT; y++) {
    JSAMPROW row = rgb + 3 * (size_t)y * WIDTH;
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  return bytes;
}

/* Which of the corners of the picture as it was taken is seen in this one. */
static int seen_in(const tp_trace_picture *picture, int corner) {
  const int x = corner == 1 || corner == 2 ? picture->width - 1 - CORNER / 2 : CORNER / 2;
  const int y = corner >= 2 ? picture->height - 1 - CORNER / 2 : CORNER / 2;
  const unsigned char *pixel = picture->rgb + 3 * (y * picture->width + x);
  int best = -1;
  long least = 30L * 30;
  for (int k = 0; k < 4; k++) {
    long square = 0;
    for (int c = 0; c < 3; c++) square += (pixel[c] - colours[k][c]) * (pixel[c] - colours[k][c]);
    if (square < least) best = k, least = square;
  }
  return best;
}

/* The standard's table: where the first row and the first column of what is stored are seen. */
START_TEST(turned_as_exif_says) {
  static const int seen[9][4] = {{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 0, 3, 2},
                                 {2, 3, 0, 1}, {3, 2, 1, 0}, {0, 3, 2, 1},
                                 {3, 0, 1, 2}, {2, 1, 0, 3}, {1, 2, 3, 0}};
  for (int orientation = 0; orientation <= 8; orientation++) {
    for (int little = 0; little < 2; little++) {
      tp_trace_picture picture;
      tp_message message;
      unsigned long length = 0;
      unsigned char *bytes = encode(&length, orientation, little != 0);
      ck_assert_int_eq(tp_picture_read_bytes(&picture, bytes, length, "p.jpg", &message), TP_OK);
      ck_assert_int_eq(picture.width, orientation >= 5 ? HEIGHT : WIDTH);
      ck_assert_int_eq(picture.height, orientation >= 5 ? WIDTH : HEIGHT);
      for (int corner = 0; corner < 4; corner++) {
        ck_assert_int_eq(seen_in(&picture, corner), seen[orientation][corner]);
      }
      tp_picture_clear(&picture);
      free(bytes);
    }
  }
}
END_TEST

/* But for the mark that ends it, which some leave out. */
START_TEST(cut_off_anywhere) {
  unsigned long length = 0;
  unsigned char *bytes = encode(&length, 6, false);
  for (unsigned long cut = 0; cut + 2 < length; cut++) {
    tp_trace_picture picture;
    tp_message message = {.text = ""};
    unsigned char *own = malloc(cut + 1); /* so that reading on is noticed */
    ck_assert_ptr_nonnull(own);
    memcpy(own, bytes, cut);
    const tp_status status = tp_picture_read_bytes(&picture, own, cut, "p.jpg", &message);
    ck_assert_int_eq(status, TP_BAD_INPUT);
    ck_assert(message.text[0] != '\0' && picture.rgb == NULL);
    free(own);
  }
  free(bytes);
}
END_TEST

SUITE(picture) {
  Suite *suite = suite_create("picture");
  TCase *cases = tcase_create("picture");
  tcase_set_timeout(cases, 60);
  tcase_add_test(cases, turned_as_exif_says);
  tcase_add_test(cases, cut_off_anywhere);
  suite_add_tcase(suite, cases);
  return suite;
}
