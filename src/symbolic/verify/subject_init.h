/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A subject from a geometry: its block and pivot, the symbols of its field, the names of the
 * program, of the claims file and of the scene. */

#ifndef TP_VERIFY_SUBJECT_INIT_H
#define TP_VERIFY_SUBJECT_INIT_H

#include "verify/subject.h"

/* A symbol or angle that a claims file declares, with its value where numbers are needed. */
typedef struct tp_declared {
  const char *name;
  const fmpq *value;
  bool angle;
} tp_declared;

/* How a geometry is set up; `scene` NULL: no block, formulas in declared symbols alone. */
typedef struct tp_subject_options {
  const char *scene; /* path */
  bool has_direction;
  tp_direction towards; /* else the first of the scene */
  bool has_pivot;
  size_t pivot;       /* else the governing one */
  bool rounded;       /* the corner at the pivot, by the length r */
  tp_members members; /* one block, or all N of a parity */
  long declared_count;
  const tp_declared *declared;
} tp_subject_options;

TP_MUST_USE tp_status tp_subject_init(tp_subject *subject, const tp_subject_options *options,
                                      tp_place place, tp_message *message);

#endif
