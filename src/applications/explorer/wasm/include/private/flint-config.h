/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* FLINT in WebAssembly: one thread, no instructions beyond the least, nothing of the processor's.
 */

#define FLINT_USES_BLAS 0
#define FLINT_USES_TLS 0
#define FLINT_USES_FENV 0
#define FLINT_USES_PTHREAD 0
#define FLINT_BIG_ENDIAN 0
#define FLINT_USES_GC 0
#define FLINT_USES_CPUSET 0
#define FLINT_REENTRANT 0
#define FLINT_WANT_ASSERT 0
#define FLINT_DLL
