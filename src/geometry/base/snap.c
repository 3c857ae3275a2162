/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Memory of a snapped outline. */

#include "base/snap.h"

#include <string.h>

void tp_snap_init(tp_snap *snap) {
  memset(snap, 0, sizeof *snap);
  fmpq_init(snap->most);
  fmpq_init(snap->overlap);
  fmpq_init(snap->left);
  fmpq_init(snap->right);
}

void tp_snap_clear(tp_snap *snap) {
  tp_polyline_clear(&snap->outline);
  tp_polyline_clear(&snap->moved);
  fmpq_clear(snap->most);
  fmpq_clear(snap->overlap);
  fmpq_clear(snap->left);
  fmpq_clear(snap->right);
}
