/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The four blocks of Table 7 of Alejano et al., placed in its ranges and judged.
 *
 * The table gives a tilt and a range of inverse slenderness x = dx / y for each block. Placed are
 *   1  x = 1.1 tan(phi + i), at phi + 1: anywhere in its range does as well;
 *   2  x = 1.001 tan(phi + i), at phi + i - 1: as near to toppling as its range allows;
 *   3  at phi + i - 1, halfway between the x that topples about a peak and that of a planar base;
 *   4  at phi + 1, halfway between the x of a planar base and that about a valley:
 * the last two where the table's verdicts are possible at all. */

#ifndef TP_PAPER_TABLE_7_H
#define TP_PAPER_TABLE_7_H

#include "chart/motion_names.h"

enum { TP_TABLE_7_BLOCKS = 4, TP_TABLE_7_LEAST_ROUGHNESS = 2 };

typedef struct tp_table_7_block {
  int number; /* 1 to 4 */
  double inverse_slenderness, tilt_deg;
} tp_table_7_block;

typedef struct tp_table_7_verdict {
  const char *program;                  /* by the borders of the map */
  char from_rest[TP_MOTIONS_NAME_SIZE]; /* on a planar base, what begins; empty on a rough one */
  const char *paper;
  bool agrees; /* the paper with the program, or with what begins from rest */
} tp_table_7_verdict;

tp_table_7_block tp_table_7_locate(int number, const tp_chart_mechanisms_options *options);

TP_MUST_USE tp_status tp_table_7_judge(tp_table_7_verdict *verdict, const tp_table_7_block *block,
                                       const tp_chart_mechanisms_options *options, bool rough,
                                       tp_message *message);

#endif
