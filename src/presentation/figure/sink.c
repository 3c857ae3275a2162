/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Write callback for Cairo that appends to a growing buffer and remembers a failure. */

#include "figure/sink.h"

#include <stdlib.h>
#include <string.h>

cairo_status_t tp_sink_write(void *closure, const unsigned char *data, unsigned int length) {
  tp_sink *s = closure;
  if (s->failed) return CAIRO_STATUS_NO_MEMORY;
  if (length > s->capacity - s->length) {
    const size_t capacity = 2 * (s->capacity + length);
    char *bytes = realloc(s->bytes, capacity);
    s->failed = bytes == NULL;
    if (s->failed) return CAIRO_STATUS_NO_MEMORY;
    s->bytes = bytes;
    s->capacity = capacity;
  }
  memcpy(s->bytes + s->length, data, length);
  s->length += length;
  return CAIRO_STATUS_SUCCESS;
}
