/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What Cairo writes, kept in memory; Cairo does not hand every error on. */

#ifndef TP_FIGURE_SINK_H
#define TP_FIGURE_SINK_H

#include <cairo.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct tp_sink {
  char *bytes; /* to be freed */
  size_t length, capacity;
  bool failed; /* memory was exhausted */
} tp_sink;

/* To be given to Cairo, with a tp_sink. */
cairo_status_t tp_sink_write(void *closure, const unsigned char *data, unsigned int length);

#endif
