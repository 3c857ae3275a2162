/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples, and what they tell, while memory runs out. */

#ifndef TP_TEST_MEMORY_SAMPLES_H
#define TP_TEST_MEMORY_SAMPLES_H

void draw_samples(void);
void measure_sensitivity(void);
void find_reliability(void);

#endif
