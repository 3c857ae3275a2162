/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Running one suite of Check as a program: its closing line, and the exit status. */

#ifndef TP_TEST_RUNNER_H
#define TP_TEST_RUNNER_H

#include "rounds.h"

#include <check.h>
#include <flint/flint.h>

static inline int run_suite(Suite *suite) {
  SRunner *runner = srunner_create(suite);
  srunner_run_all(runner, CK_ENV);
  const int failed = srunner_ntests_failed(runner);
  srunner_free(runner);
  flint_cleanup();
  return failed == 0 ? 0 : 1;
}

#endif
