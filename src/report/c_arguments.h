/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Heads of C functions that evaluate derived formulas. */

#ifndef TP_C_ARGUMENTS_H
#define TP_C_ARGUMENTS_H

#include "report/text.h"

/* "(double alpha, double a, double b) {": `first`, then the parameters. */
void tp_c_arguments(tp_text *text, const tp_derivation *derivation, const char *first);

#endif
