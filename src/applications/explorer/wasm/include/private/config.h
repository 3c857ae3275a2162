/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What musl, the C library of emscripten, has: asked for by libyaml, expat, GSL and glibc's argp,
 * whose own configuration scripts would ask compiler and linker for each. */

#ifndef TP_WASM_CONFIG_H
#define TP_WASM_CONFIG_H

/* libyaml */
#define YAML_VERSION_MAJOR 0
#define YAML_VERSION_MINOR 2
#define YAML_VERSION_PATCH 5
#define YAML_VERSION_STRING "0.2.5"

/* expat: hashes are salted by what the system says is random. */
#define XML_DEV_URANDOM 1
#define XML_CONTEXT_BYTES 1024
#define XML_DTD 1
#define XML_GE 1
#define XML_NS 1
#define BYTEORDER 1234
#define HAVE_MEMMOVE 1

/* GSL */
#define HAVE_DECL_ACOSH 1
#define HAVE_DECL_ASINH 1
#define HAVE_DECL_ATANH 1
#define HAVE_DECL_EXPM1 1
#define HAVE_DECL_FINITE 1
#define HAVE_DECL_FPRND_T 0
#define HAVE_DECL_FREXP 1
#define HAVE_DECL_HYPOT 1
#define HAVE_DECL_ISFINITE 1
#define HAVE_DECL_ISINF 1
#define HAVE_DECL_ISNAN 1
#define HAVE_DECL_LDEXP 1
#define HAVE_DECL_LOG1P 1
#define HAVE_IEEE_COMPARISONS 1
#define HAVE_IEEE_DENORMALS 1
#define HAVE_MEMCPY 1
#define HAVE_STRDUP 1
#define HAVE_VPRINTF 1
#define GSL_COERCE_DBL(x) (x) /* no register is longer than a double */
#define GSL_RANGE_COND(x) (x)
#define RETURN_IF_NULL(x)                                                                          \
  if (!x) {                                                                                        \
    return;                                                                                        \
  }

/* argp: as far as glibc's compiler macros stand in its headers, which musl's have not */
#define __THROW
#define __NTH(function) function
#define __nonnull(parameters)
#define __vsnprintf_internal(text, size, format, arguments, flags)                                 \
  vsnprintf(text, size, format, arguments)
#define _GL_UNUSED
#define __BEGIN_DECLS
#define __END_DECLS
#define gettext(message) (message)
#define dgettext(domain, message) (message)
#define HAVE_ALLOCA_H 1
#define HAVE_FLOCKFILE 1
#define HAVE_STRCHRNUL 1
#define HAVE_MEMPCPY 1
#define HAVE_STRNDUP 1
#define HAVE_SYSEXITS_H 1
#define HAVE_DECL_FLOCKFILE 1
#define HAVE_DECL_PROGRAM_INVOCATION_NAME 1
#define HAVE_DECL_PROGRAM_INVOCATION_SHORT_NAME 0

#endif
