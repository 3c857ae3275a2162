/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#ifndef TP_GOVERNING_H
#define TP_GOVERNING_H

#include "topple.h"

/* The factor of safety that governs each case, from what the solution holds. */
void tp_solution_govern(tp_solution *solution);

#endif
