/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What Pixman would find out about WebAssembly by its configure: no special instructions. */

#ifndef TP_WASM_PIXMAN_CONFIG_H
#define TP_WASM_PIXMAN_CONFIG_H

#define HAVE_BUILTIN_CLZ 1
#define HAVE_FLOAT128 0
#define PACKAGE "pixman"
#define PIXMAN_NO_TLS 1
#define SIZEOF_LONG 4
#define TOOLCHAIN_SUPPORTS_ATTRIBUTE_CONSTRUCTOR 1

#endif
