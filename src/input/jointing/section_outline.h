/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The outline of the section of a slope. */

#ifndef TP_JOINTING_SECTION_OUTLINE_H
#define TP_JOINTING_SECTION_OUTLINE_H

#include "jointing/cuts.h"

/* Its corners, surface and ends and bottom. */
TP_MUST_USE tp_status tp_cuts_outline(tp_cuts *cuts, tp_message *message);

#endif
