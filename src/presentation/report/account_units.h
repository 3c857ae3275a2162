/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Units of the account of moments by elements. */

#ifndef TP_REPORT_ACCOUNT_UNITS_H
#define TP_REPORT_ACCOUNT_UNITS_H

#include "report/page.h"

/* Weights are in N, or shares of the block's weight; moments likewise, times the length unit,
 * unless the scene asks for other units. */
typedef struct tp_account_units {
  char weight[16], moment[32];
  tp_result_unit force, whole_moment; /* no name: none is asked for, or they are shares */
} tp_account_units;

tp_account_units tp_account_units_of(const tp_solution *solution);

/* A moment of the account to six digits; returns `out`. */
const char *tp_account_moment(const tp_page *page, char out[TP_NUMBER_SIZE], tp_bounded moment,
                              const tp_account_units *units);

#endif
