/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What an axis of a map says of a number of the scene: quantity, symbol and unit. */

#ifndef TP_AXIS_LABEL_H
#define TP_AXIS_LABEL_H

#include <stdbool.h>
#include <stddef.h>

/* The label, in gnuplot's markup where *plain is false; a parameter and a coordinate are called by
 * their keys. `length_unit` is the scene's. */
void tp_axis_label(char *label, size_t size, bool *plain, const char *key, const char *length_unit);

#endif
