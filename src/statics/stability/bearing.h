/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which pivots carry a reaction at the static limit. */

#ifndef TP_STABILITY_BEARING_H
#define TP_STABILITY_BEARING_H

#include "topple.h"

/* Does one of the limit's reactions act at the pivot, as far as the bounds tell? */
bool tp_pivot_bears(const tp_pivot *pivot, const tp_limit *limit);

#endif
