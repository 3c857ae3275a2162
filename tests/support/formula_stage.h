/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A language to test the reader of formulas in: two dialects, trees written out. */

#ifndef TP_TEST_FORMULA_STAGE_H
#define TP_TEST_FORMULA_STAGE_H

#include "formula_names.h"

/* All that a dialect may allow, and as little as possible. */
extern const tp_dialect printed, plain;

/* A node with brackets round every operation; "." is a product that is not written. */
void write_out(char *out, const tp_formula *f, long index);
/* The text is read as this tree. */
void reads(const tp_dialect *dialect, const char *text, const char *tree);
/* The text is refused with a message that begins so. */
void refuses(const tp_dialect *dialect, const char *text, const char *beginning);

#endif
