/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a contact that the scene leaves to the default keeps its ends. */

#ifndef TP_DERIVE_CONTACT_CONDITIONS_H
#define TP_DERIVE_CONTACT_CONDITIONS_H

#include "derive/conditions.h"
#include "derive/model.h"

/* The contact of a mated base ends where the underside rises beyond 45 degrees for good
 * (base/underside.h): in the vertices with the least x + y and the largest x - y, which stay those.
 * False where another vertex is alike at the values alone. */
bool tp_contact_conditions(tp_conditions *conditions, const tp_model *model);

#endif
