/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Studies while memory runs out. */

#ifndef TP_TEST_MEMORY_STUDIES_H
#define TP_TEST_MEMORY_STUDIES_H

void run_study(void);
void merge_study(void);

#endif
