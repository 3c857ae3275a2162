/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Single values of a study file, and complaints with their place in it. */

#ifndef TP_STUDY_VALUES_H
#define TP_STUDY_VALUES_H

#include "study/study.h"

typedef struct tp_study_reader {
  tp_study *study;
  tp_message *message;
} tp_study_reader;

/* Fail at a node. */
tp_status tp_study_fail(const tp_study_reader *reader, const tp_node *node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The complaint of a call that knows nothing of the study, told at a node: its status. */
tp_status tp_study_fail_of(const tp_study_reader *reader, const tp_node *node, tp_status status,
                           const tp_message *inner);

/* A number, exact in the text, rounded to the nearest double; `name` in messages. */
TP_MUST_USE tp_status tp_study_read_number(const tp_study_reader *reader, double *value,
                                           const tp_node *node, const char *name);
TP_MUST_USE tp_status tp_study_read_exact(const tp_study_reader *reader, fmpq_t value,
                                          const tp_node *node, const char *name);
/* A whole number within least and most. */
TP_MUST_USE tp_status tp_study_read_whole(const tp_study_reader *reader, uint64_t *value,
                                          const tp_node *node, const char *name, uint64_t least,
                                          uint64_t most);

/* To the nearest double. */
double tp_study_double(const fmpq_t value);

/* The path of a file that the study names, relative to its folder, to be freed; NULL when memory is
 * exhausted. */
char *tp_study_beside(const tp_study *study, const char *name);

#endif
