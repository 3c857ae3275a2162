/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Heads of C functions that evaluate derived formulas. */

#ifndef TP_REPORT_C_ARGUMENTS_H
#define TP_REPORT_C_ARGUMENTS_H

#include "output/text.h"

/* "(double alpha, double a, double b) {": `first`, then the parameters. */
void tp_c_arguments(tp_text *text, const tp_derivation *derivation, const char *first);

/* "a", or "p_double for double" where C keeps the parameter's name for itself. */
void tp_add_symbol(tp_text *text, const char *symbol, const char *parameter);

#endif
