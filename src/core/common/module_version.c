/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In each library that Topple loads while it runs: the version that it was built as. What loads it
 * compares that with its own, as the two hand structs to each other that no public header holds
 * still. */

#include "topple_basics.h"

const char *tp_module_version(void);

const char *tp_module_version(void) {
  return TP_VERSION;
}
