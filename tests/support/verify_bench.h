/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A subject to read and decide formulas about. */

#ifndef TP_TEST_VERIFY_BENCH_H
#define TP_TEST_VERIFY_BENCH_H

#include "verify/evaluate.h"

/* A slab w = 2 wide and h = 3 high; a symbol m = 5 and an angle psi = 30 degrees besides. */
typedef struct bench {
  tp_subject subject;
  tp_claim_sample sample;
  tp_message message;
} bench;

/* A subject of the slab, whose declared symbol has this name. */
tp_status init_subject(tp_subject *subject, const char *name, tp_message *message);
void bench_init(bench *b);
void bench_clear(bench *b);
void read_claim_formula(tp_formula *formula, bench *b, const char *text);
/* The text's value at the sample. */
double value_of(bench *b, const char *text);
/* Are both texts the same rational function? */
bool same(bench *b, const char *one, const char *other);

#endif
