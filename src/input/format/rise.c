/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Memory of what is kept of points in space. */

#include "format/rise.h"

#include <stdlib.h>

tp_rise *tp_rise_new(const fmpq_t z) {
  tp_rise *rise = calloc(1, sizeof *rise);
  if (rise == NULL) return NULL;
  fmpq_init(rise->z);
  fmpq_set(rise->z, z);
  return rise;
}

void tp_rise_free(tp_rise *rise) {
  if (rise == NULL) return;
  fmpq_clear(rise->z);
  free(rise);
}
