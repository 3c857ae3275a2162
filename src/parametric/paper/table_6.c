/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table 6 as printed: inverse slenderness, amplitude, tilt and the three factors of safety of each
 * block. */

#include "paper/table_6.h"

const tp_table_6_example tp_table_6[TP_TABLE_6_EXAMPLES] = {
    {0.5, 0.1, 20, {"1.37", "1.53", "1.25"}},   {0.75, 0.1, 25, {"1.61", "1.78", "1.46"}},
    {1, 0.1, 30, {"1.73", "1.92", "1.57"}},     {0.5, 0.05, 20, {"1.37", "1.44", "1.30"}},
    {0.75, 0.05, 25, {"1.61", "1.69", "1.53"}}, {1, 0.05, 30, {"1.73", "1.82", "1.65"}},
};
