/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The name by which the sources of FLINT 3 ask for what they define. */

#include <calcium/fmpz_mpoly_q.h>
