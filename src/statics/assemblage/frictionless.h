/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Do normal forces alone hold blocks in contact? Then whatever friction there is, none can begin to
 * move (contact_modes/node.h, by reactions). Of any number of blocks: searched by Newton's method
 * for the centre of such forces, proven in doubles with their bounds. */

#ifndef TP_ASSEMBLAGE_FRICTIONLESS_H
#define TP_ASSEMBLAGE_FRICTIONLESS_H

#include "assemblage/force_program.h"

/* With so much of the live load. Not held: no proof was found; `slides`: nor is there one. */
TP_MUST_USE tp_status tp_frictionless_hold(bool *held, bool *slides,
                                           const tp_assemblage *assemblage,
                                           const tp_weight_loads *loads, tp_near load,
                                           tp_message *message);

#endif
