/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names that formulas of tests may use: fronts of each other and of a function, one of an angle. */

#ifndef TP_TEST_FORMULA_NAMES_H
#define TP_TEST_FORMULA_NAMES_H

#include "formula/read.h"

enum { NAMES = 7 };
extern const char *const formula_names[NAMES];
extern const tp_vocabulary vocabulary;

#endif
