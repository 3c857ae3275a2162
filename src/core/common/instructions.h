/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which instruction sets this machine has. What is compiled for several of them gives the same bits
 * by each. */

#ifndef TP_COMMON_INSTRUCTIONS_H
#define TP_COMMON_INSTRUCTIONS_H

#include <stdbool.h>

typedef enum tp_instructions {
  TP_INSTRUCTIONS_BEST,
  TP_INSTRUCTIONS_BASELINE,
  TP_INSTRUCTIONS_AVX2, /* with FMA */
  TP_INSTRUCTIONS_AVX512,
  TP_INSTRUCTIONS_COUNT
} tp_instructions;

/* Can this machine run them? */
bool tp_instructions_present(tp_instructions set);

/* The best one that it can run, where that is asked for; else the one that is. */
tp_instructions tp_instructions_chosen(tp_instructions asked);

#endif
