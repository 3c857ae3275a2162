/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "formula_names.h"

#include <string.h>

const char *const formula_names[NAMES] = {"a", "b", "ab", "alpha", "sigma_n", "dx", "sine"};

static long find(const void *context, const char *name, size_t length) {
  (void)context;
  for (long k = 0; k < NAMES; k++) {
    if (strlen(formula_names[k]) == length && memcmp(formula_names[k], name, length) == 0) return k;
  }
  return -1;
}

static bool is_angle(const void *context, long name) {
  (void)context;
  return strcmp(formula_names[name], "alpha") == 0;
}

const tp_vocabulary vocabulary = {find, is_angle, NULL};
