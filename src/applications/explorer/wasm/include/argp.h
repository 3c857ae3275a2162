/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* glibc's <argp.h>, whose macros for compilers musl has not. */

#ifndef TP_WASM_ARGP_H
#define TP_WASM_ARGP_H

#include <features.h>
#ifdef __cplusplus
#define __BEGIN_DECLS extern "C" {
#define __END_DECLS }
#else
#define __BEGIN_DECLS
#define __END_DECLS
#endif

#ifndef __THROW
#define __THROW
#endif
#ifndef __NTH
#define __NTH(function) function
#endif
#define __error_t_defined 1
typedef int error_t;

#include <glibc/argp.h>

#endif
