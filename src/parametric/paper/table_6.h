/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The examples of Table 6 of Alejano et al.: factors of safety of toothed blocks, as printed. */

#ifndef TP_PAPER_TABLE_6_H
#define TP_PAPER_TABLE_6_H

enum { TP_TABLE_6_EXAMPLES = 6 };

typedef struct tp_table_6_example {
  double inverse_slenderness, amplitude, tilt_deg;
  const char *printed[3]; /* by tp_toe_kind */
} tp_table_6_example;

extern const tp_table_6_example tp_table_6[TP_TABLE_6_EXAMPLES];

#endif
