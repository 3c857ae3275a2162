/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The clock by which effects are timed; no result depends on it. */

#ifndef TP_COMMON_CLOCK_H
#define TP_COMMON_CLOCK_H

/* Seconds of a clock that never goes back. */
double tp_clock_now(void);

#endif
