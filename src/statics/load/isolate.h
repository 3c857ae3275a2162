/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The zeros of functions with terms in 1 / cos a, one by one (load/zeros.h). */

#ifndef TP_LOAD_ISOLATE_H
#define TP_LOAD_ISOLATE_H

#include "load/roots.h"
#include "load/wrench.h"

/* Into `roots`, which are empty and certain. */
void tp_roots_isolate(tp_roots *roots, const tp_trig *f, long bits);

#endif
