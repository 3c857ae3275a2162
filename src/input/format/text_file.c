/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads a file into a growing buffer, skips a byte-order mark of UTF-8, and converts UTF-16 of
 * either byte order. */

#include "format/text_file.h"
#include "common/input_file.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 128 << 20, FIRST = 1 << 16 };

static tp_status read_bytes(tp_text_file *file, FILE *in, const char *path, tp_message *message) {
  size_t room = FIRST;
  char *text = malloc(room), *grown = text;
  size_t length = 0, got = 0;
  while (grown != NULL && (got = fread(text + length, 1, room - 1 - length, in)) > 0) {
    length += got;
    if (length > MOST) {
      free(text);
      return tp_refuse(message, TP_FAULT_RANGE, (tp_place){path, 0, 0},
                       "a drawing of more than 128 MiB; export the layers of block and base alone");
    }
    if (length < room - 1) continue;
    grown = realloc(text, 2 * room);
    if (grown != NULL) text = grown;
    room *= 2;
  }
  const int problem = ferror(in) ? errno : 0;
  if (grown == NULL || problem != 0) {
    free(text);
    if (grown == NULL) return tp_fail_memory(message, "a drawing");
    return tp_fail_file(message, path, "read", problem);
  }
  text[length] = '\0';
  *file = (tp_text_file){text, length};
  return TP_OK;
}

static uint32_t unit_at(const unsigned char *bytes, bool big) {
  return big ? (uint32_t)bytes[0] << 8 | bytes[1] : (uint32_t)bytes[1] << 8 | bytes[0];
}

static size_t put_character(char *to, uint32_t c) {
  if (c < 0x80) {
    to[0] = (char)c;
    return 1;
  }
  if (c < 0x800) {
    to[0] = (char)(0xC0 | c >> 6);
    to[1] = (char)(0x80 | (c & 0x3F));
    return 2;
  }
  if (c < 0x10000) {
    to[0] = (char)(0xE0 | c >> 12);
    to[1] = (char)(0x80 | (c >> 6 & 0x3F));
    to[2] = (char)(0x80 | (c & 0x3F));
    return 3;
  }
  to[0] = (char)(0xF0 | c >> 18);
  to[1] = (char)(0x80 | (c >> 12 & 0x3F));
  to[2] = (char)(0x80 | (c >> 6 & 0x3F));
  to[3] = (char)(0x80 | (c & 0x3F));
  return 4;
}

/* Two halves of a pair make one character; a half alone becomes U+FFFD. */
static tp_status from_utf16(tp_text_file *file, bool big, tp_message *message) {
  enum { MOST_BYTES = 3 }; /* of UTF-8 for two of UTF-16; a pair of four has four */
  const unsigned char *bytes = (const unsigned char *)file->text;
  char *text = malloc(file->length / 2 * MOST_BYTES + 1);
  if (text == NULL) return tp_fail_memory(message, "a drawing");
  size_t length = 0;
  for (size_t k = 2; k + 1 < file->length; k += 2) {
    uint32_t c = unit_at(bytes + k, big);
    const uint32_t next = k + 3 < file->length ? unit_at(bytes + k + 2, big) : 0;
    if (c >= 0xD800 && c < 0xDC00 && next >= 0xDC00 && next < 0xE000) {
      c = 0x10000 + ((c - 0xD800) << 10) + (next - 0xDC00);
      k += 2;
    } else if (c >= 0xD800 && c < 0xE000) {
      c = 0xFFFD;
    }
    length += put_character(text + length, c);
  }
  text[length] = '\0';
  free(file->text);
  *file = (tp_text_file){text, length};
  return TP_OK;
}

static tp_status decode(tp_text_file *file, tp_message *message) {
  const unsigned char *start = (const unsigned char *)file->text;
  if (file->length >= 2 && start[0] == 0xFF && start[1] == 0xFE) {
    return from_utf16(file, false, message);
  }
  if (file->length >= 2 && start[0] == 0xFE && start[1] == 0xFF) {
    return from_utf16(file, true, message);
  }
  if (file->length >= 3 && memcmp(start, "\xef\xbb\xbf", 3) == 0) {
    file->length -= 3;
    memmove(file->text, file->text + 3, file->length + 1);
  }
  return TP_OK;
}

tp_status tp_text_file_read(tp_text_file *file, const char *path, tp_message *message) {
  FILE *in = NULL;
  tp_text_file own = {NULL, 0};
  tp_status status = tp_input_open(&in, path, message);
  if (status != TP_OK) return status;
  status = read_bytes(&own, in, path, message);
  fclose(in);
  if (status == TP_OK) status = decode(&own, message);
  if (status == TP_OK) {
    *file = own;
  } else {
    free(own.text);
  }
  return status;
}
