/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What was done to mend a mesh, in a solid and as notes on it: what was invented is a caution. */

#ifndef TP_SOLID_TILT_REPAIRED_H
#define TP_SOLID_TILT_REPAIRED_H

#include "solid_tilt/solid_body.h"

/* Into the solid, which has its unit: lengths in metres. */
TP_MUST_USE tp_status tp_repair_tell(tp_solid *solid, const tp_solid_body *body,
                                     tp_message *message);

TP_MUST_USE tp_status tp_repair_notes(tp_solid *solid, tp_message *message);

#endif
