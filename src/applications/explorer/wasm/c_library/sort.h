/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What musl's <stdlib.h> of this emscripten does not declare; included before each source. */

#ifndef TP_WASM_SORT_H
#define TP_WASM_SORT_H

#include <stddef.h>

void qsort_r(void *items, size_t count, size_t size,
             int (*compare)(const void *, const void *, void *), void *context);

#endif
