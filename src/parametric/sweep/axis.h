/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The numbers that a sweep takes for a key: a range or a list, in exact rationals. */

#ifndef TP_SWEEP_AXIS_H
#define TP_SWEEP_AXIS_H

#include "scene_varying/vary.h"

typedef struct tp_axis {
  char *name; /* the key */
  tp_scene_key key;
  size_t count;       /* of the values */
  fmpq_t first, step; /* of a range */
  fmpq *list;         /* or NULL */
} tp_axis;

/* Of "KEY=FIRST:LAST:STEP" or "KEY=VALUE,VALUE"; to be cleared, whatever the outcome. */
TP_MUST_USE tp_status tp_axis_read(tp_axis *axis, const tp_scene *scene, const char *text,
                                   tp_message *message);
void tp_axis_clear(tp_axis *axis);

/* The setting "KEY=NUMBER" of the value, to be freed; NULL when memory is exhausted. */
char *tp_axis_setting(const tp_axis *axis, size_t value);

#endif
