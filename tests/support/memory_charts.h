/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Charts while memory runs out. */

#ifndef TP_TEST_MEMORY_CHARTS_H
#define TP_TEST_MEMORY_CHARTS_H

#include "topple.h"

void chart_fos(void);
void chart_mechanisms(void);
void chart_ranges(void);
void chart_map(void);
void chart_map_contours(void);
void chart_profile(const tp_profile *profile);

#endif
