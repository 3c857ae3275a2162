/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What kind of picture a file is, and how large, by its first bytes: PNG by its chunks (ISO/IEC
 * 15948, 5), JPEG by its segments up to the frame header (ITU-T T.81, B.2.2), SVG by its root
 * element. */

#include "document/logo.h"

#include "common/input_file.h"
#include "common/outside.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BYTES = 1 << 20, MOST_DOTS = 4096 };

const char *tp_logo_type(tp_logo_kind kind) {
  switch (kind) {
  case TP_LOGO_PNG:
    return "png";
  case TP_LOGO_JPEG:
    return "jpeg";
  case TP_LOGO_SVG:
    return "svg+xml";
  case TP_LOGO_NONE:
    break;
  }
  return "";
}

void tp_logo_clear(tp_logo *logo) {
  free(logo->bytes);
  *logo = (tp_logo){0};
}

static uint32_t big_endian(const unsigned char *at, int bytes) {
  uint32_t value = 0;
  for (int k = 0; k < bytes; k++) value = value << 8 | at[k];
  return value;
}

/* Chunk after chunk, from IHDR to IEND. */
static bool is_whole_png(tp_logo *own) {
  enum { SIGNATURE = 8, AROUND = 12, HEAD = 13 };
  const unsigned char *bytes = (const unsigned char *)own->bytes;
  size_t at = SIGNATURE;
  bool first = true;
  while (at + AROUND <= own->length) {
    const uint32_t length = big_endian(bytes + at, 4);
    if (length > own->length - at - AROUND) return false;
    if (first != (memcmp(bytes + at + 4, "IHDR", 4) == 0)) return false;
    if (first && length != HEAD) return false;
    if (first) {
      const uint32_t width = big_endian(bytes + at + 8, 4), height = big_endian(bytes + at + 12, 4);
      own->width = width <= INT32_MAX ? (int)width : INT32_MAX;
      own->height = height <= INT32_MAX ? (int)height : INT32_MAX;
    }
    if (memcmp(bytes + at + 4, "IEND", 4) == 0) return true;
    first = false;
    at += AROUND + length;
  }
  return false;
}

/* Its frame header: baseline, extended or progressive. */
static bool is_frame(unsigned char marker) {
  return marker >= 0xC0 && marker <= 0xC2;
}

/* Segment after segment, up to the frame header; and the end of the image at the end. */
static bool is_whole_jpeg(tp_logo *own) {
  const unsigned char *bytes = (const unsigned char *)own->bytes;
  size_t end = own->length;
  while (end > 4 && bytes[end - 1] == 0) end--;
  if (bytes[end - 2] != 0xFF || bytes[end - 1] != 0xD9) return false;
  for (size_t at = 2; at + 9 <= own->length;) {
    if (bytes[at] != 0xFF) return false;
    const unsigned char marker = bytes[at + 1];
    const uint32_t length = big_endian(bytes + at + 2, 2);
    if (length < 2) return false;
    if (is_frame(marker)) {
      own->height = (int)big_endian(bytes + at + 5, 2);
      own->width = (int)big_endian(bytes + at + 7, 2);
      return true;
    }
    at += 2 + length;
  }
  return false;
}

/* Text whose first element is svg, and which defines no entities. */
static bool is_svg(const char *text, size_t length) {
  if (strlen(text) != length || strstr(text, "<!ENTITY") != NULL) return false;
  for (const char *at = strchr(text, '<'); at != NULL; at = strchr(at + 1, '<')) {
    if (strncmp(at, "<svg", 4) == 0) return strstr(at, "</svg>") != NULL;
    if (strncmp(at, "<!--", 4) == 0) {
      at = strstr(at, "-->");
      if (at == NULL) return false;
    } else if (at[1] != '?' && at[1] != '!') {
      return false;
    }
  }
  return false;
}

static bool begins(const tp_logo *own, const char *with, size_t length) {
  return own->length > length + 8 && memcmp(own->bytes, with, length) == 0;
}

/* What is wrong with it; NULL: nothing. */
static const char *judge(tp_logo *own) {
  if (own->length > MOST_BYTES) return "it is larger than 1 MiB: save it smaller";
  if (begins(own, "\x89PNG\r\n\x1a\n", 8)) {
    own->kind = TP_LOGO_PNG;
    if (!is_whole_png(own)) return "it begins as a PNG, but is cut off or damaged";
  } else if (begins(own, "\xff\xd8\xff", 3)) {
    own->kind = TP_LOGO_JPEG;
    if (!is_whole_jpeg(own)) return "it begins as a JPEG, but is cut off, damaged or lossless";
  } else if (is_svg(own->bytes, own->length)) {
    own->kind = TP_LOGO_SVG;
    return NULL;
  } else {
    return "it is none of PNG, JPEG and SVG (an SVG without entities)";
  }
  if (own->width < 1 || own->height < 1) return "it has no dots";
  if (own->width > MOST_DOTS || own->height > MOST_DOTS) {
    return "it has more than 4096 dots a side: save it smaller";
  }
  return NULL;
}

enum { IS_NO_FILE = -1 };

/* At most a byte more than a logo may have, with a zero behind them; an errno where they cannot be
 * read, or IS_NO_FILE. */
static int read_bytes(tp_logo *own, const char *path) {
  FILE *file = NULL;
  tp_message message;
  if (tp_input_open(&file, path, &message) != TP_OK) {
    return message.system_error != 0 ? message.system_error : IS_NO_FILE;
  }
  errno = 0;
  own->length = fread(own->bytes, 1, MOST_BYTES + 1, file);
  const int why = ferror(file) != 0 ? errno : 0;
  fclose(file);
  own->bytes[own->length] = '\0';
  return why;
}

static tp_status fail_unread(const char *path, tp_place place, int why, tp_message *message) {
  const tp_status status =
      tp_fail(message, TP_SYSTEM_FAILED, place, "the logo '%s' cannot be read: %s",
              tp_quote_all(path).text, strerror(why));
  return tp_fail_because(message, status, why);
}

tp_status tp_logo_read(tp_logo *logo, const char *path, tp_place place, tp_message *message) {
  tp_logo own = {.bytes = malloc(MOST_BYTES + 2)};
  if (own.bytes == NULL) return tp_fail_memory(message, "the logo");
  const int unread = read_bytes(&own, path);
  const char *why = unread == 0            ? judge(&own)
                    : unread == IS_NO_FILE ? "it is not a regular file"
                                           : NULL;
  if (unread == 0 && why == NULL) {
    *logo = own;
    return TP_OK;
  }
  free(own.bytes);
  if (unread != 0 && why == NULL) return fail_unread(path, place, unread, message);
  return tp_refuse(message, TP_FAULT_FORMAT, place, "the logo '%s' cannot be used: %s",
                   tp_quote_all(path).text, why);
}
