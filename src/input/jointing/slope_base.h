/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The base of a slope. */

#ifndef TP_JOINTING_SLOPE_BASE_H
#define TP_JOINTING_SLOPE_BASE_H

#include "jointing/cuts.h"

/* Behind the traces, along which it may step. Bad input: joints that it cannot step along. */
TP_MUST_USE tp_status tp_cuts_base(tp_cuts *cuts, tp_message *message);

#endif
