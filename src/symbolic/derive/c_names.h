/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of parameters in C, where some mean something else already. */

#ifndef TP_DERIVE_C_NAMES_H
#define TP_DERIVE_C_NAMES_H

#include "derive/field.h"

/* Can a name not be a parameter's in C: a keyword of C or C++, what <math.h>, the compiler or the
 * generated functions define, anything that begins with _, or capitals alone, as macros have? */
bool tp_c_name_is_reserved(const char *name);

/* Have the field write its parameters by names that C leaves free: p_ before a reserved one, again
 * until nothing else has the name. False when memory is exhausted. */
TP_MUST_USE bool tp_c_names_set(tp_field *field);

#endif
