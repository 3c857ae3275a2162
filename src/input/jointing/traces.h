/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Traces of the joint sets of a slope, across its section. */

#ifndef TP_JOINTING_TRACES_H
#define TP_JOINTING_TRACES_H

#include "jointing/cuts.h"

/* Of all sets, behind the outline. Bad input: more blocks to be cut than is allowed, by their
 * number about. */
TP_MUST_USE tp_status tp_cuts_traces(tp_cuts *cuts, tp_message *message);

#endif
