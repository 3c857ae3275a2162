/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What Cairo would find out about WebAssembly by its configure: 32 bits, one thread. */

#ifndef TP_WASM_CAIRO_CONFIG_H
#define TP_WASM_CAIRO_CONFIG_H

#define CAIRO_NO_MUTEX 1
#define HAVE_FT_GET_X11_FONT_FORMAT 1
#define HAVE_FT_GLYPHSLOT_EMBOLDEN 1
#define HAVE_FT_GLYPHSLOT_OBLIQUE 1
#define HAVE_FT_LIBRARY_SETLCDFILTER 1
#define HAVE_FT_LOAD_SFNT_TABLE 1
#define HAVE_GMTIME_R 1
#define HAVE_INTTYPES_H 1
#define HAVE_LOCALTIME_R 1
#define HAVE_STDINT_H 1
#define HAVE_STRNDUP 1
#define HAVE_UINT64_T 1
#define HAVE_UNISTD_H 1
#define HAVE_ZLIB 1
#define PACKAGE_VERSION "1.16.0"
#define SIZEOF_INT 4
#define SIZEOF_LONG 4
#define SIZEOF_LONG_LONG 8
#define SIZEOF_SIZE_T 4
#define SIZEOF_VOID_P 4

#endif
