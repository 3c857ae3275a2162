/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which signs tell the contact of a block that varies. */

#ifndef TP_CASE_FILTER_OUTLINE_SIGNS_H
#define TP_CASE_FILTER_OUTLINE_SIGNS_H

#include "case_filter/outline_mapping.h"

/* The signs that tell the contact, of points and contact that are mapped; `fits` becomes false
 * where one is zero in the scene at hand and may not stay so. */
void tp_outline_mapping_add_signs(tp_outline_mapping *m, tp_direction towards);

#endif
