/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The program of a wing's tests: the suite named by its argument, or without one the names. */

#define _GNU_SOURCE
#include "suite.h"
#include "runner.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static test_suite *registered;

void register_suite(test_suite *suite) {
  suite->next = registered;
  registered = suite;
}

static char folder[] = "/tmp/topple-test-XXXXXX";
static bool has_folder;

const char *scratch_folder(void) {
  if (!has_folder && mkdtemp(folder) == NULL) abort();
  has_folder = true;
  return folder;
}

static int run(const test_suite *suite) {
  const int failed = run_suite(suite->make());
  if (!has_folder) return failed;
  char command[64];
  snprintf(command, sizeof command, "rm -r '%s'", folder);
  return system(command) == 0 ? failed : 1;
}

int main(int count, char **arguments) {
  for (const test_suite *suite = registered; suite != NULL; suite = suite->next) {
    if (count < 2)
      puts(suite->name);
    else if (strcmp(suite->name, arguments[1]) == 0)
      return run(suite);
  }
  if (count < 2) return 0;
  fprintf(stderr, "There is no suite '%s'; without an argument: all names.\n", arguments[1]);
  return 2;
}
