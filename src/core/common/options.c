/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Copies as many bytes of an options struct as both sides know, by the size at its beginning; sizes
 * that this library can not know are refused. */

#include "common/options.h"

#include <string.h>

static size_t size_of(const void *options) {
  size_t size;
  memcpy(&size, options, sizeof size);
  return size;
}

void tp_options_fill(void *options, size_t size, const void *defaults) {
  const size_t known = size_of(defaults);
  if (options == NULL || size < sizeof size) return;
  memset(options, 0, size);
  memcpy(options, defaults, size < known ? size : known);
  memcpy(options, &size, sizeof size);
}

tp_status tp_options_take(void *own, const void *given, const char *entry, tp_message *message) {
  const size_t known = size_of(own), size = size_of(given);
  /* Of another multiple a field might be cut. */
  if (size == 0 || size > known || size % sizeof size != 0) {
    return tp_refuse(
        message, TP_FAULT_ARGUMENT, (tp_place){0},
        "%s: the size of 'options' is %zu, and this library knows up to %zu; begin with "
        "the defaults, which have it",
        entry, size, known);
  }
  memcpy(own, given, size);
  memcpy(own, &known, sizeof known);
  return TP_OK;
}
