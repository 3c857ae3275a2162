/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A suite of Check in a program of many.
 *
 * A file of tests holds one suite, `SUITE(name) { Suite *suite = …; return suite; }`, which is
 * registered before `main` begins; the program of a wing is linked of all its files and runs the
 * suite that its argument names, so that a new file costs no program of its own to link. */

#ifndef TP_TEST_SUITE_H
#define TP_TEST_SUITE_H

#include "rounds.h"

#include <check.h>

typedef struct test_suite {
  const char *name;
  Suite *(*make)(void);
  struct test_suite *next;
} test_suite;

void register_suite(test_suite *suite);

/* A folder that is removed when the suite has run. */
const char *scratch_folder(void);

#define SUITE(suite_name)                                                                          \
  static Suite *suite_name##_suite(void);                                                          \
  static test_suite suite_name##_registered = {#suite_name, suite_name##_suite, NULL};             \
  __attribute__((constructor)) static void register_##suite_name(void) {                           \
    register_suite(&suite_name##_registered);                                                      \
  }                                                                                                \
  static Suite *suite_name##_suite(void)

#endif
