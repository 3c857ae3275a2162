/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Units of weights and moments in tables: those that the scene asks for, else N and N m, and in the
 * account by elements the weight times the length unit. */

#ifndef TP_ACCOUNT_UNITS_H
#define TP_ACCOUNT_UNITS_H

#include "report/page.h"

/* Of the account by elements. Without a unit weight its weights are shares of the block's, W, which
 * have no other unit. */
typedef struct tp_account_units {
  char weight[16], moment[32]; /* as heads of tables have them */
  tp_result_unit force;        /* no name: none is asked for */
  tp_result_unit whole_moment; /* likewise */
} tp_account_units;

tp_account_units tp_account_units_of(const tp_solution *solution);

/* A moment of the account, in N m or W m. */
const char *tp_account_moment(char out[TP_NUMBER_SIZE], const tp_solution *solution,
                              tp_bounded moment);

/* The unit of the moments of loads. */
const char *tp_load_moment_unit(const tp_solution *solution);

#endif
