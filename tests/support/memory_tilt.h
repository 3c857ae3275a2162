/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Simulated tilt tests while memory runs out. */

#ifndef TP_TEST_MEMORY_TILT_H
#define TP_TEST_MEMORY_TILT_H

void simulate_tilt_test(void);
void chart_overturning(void);
void vary_tilt_test(void);

#endif
