/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loading of optional libraries of Topple, each of which alone needs another one. */

#ifndef TP_COMMON_LIBRARY_BESIDE_H
#define TP_COMMON_LIBRARY_BESIDE_H

/* Why there is none. */
typedef struct tp_library_why {
  char text[300];
} tp_library_why;

/* The library of that name: beside what this code lies in, the library or the program; where it
 * lies seen from there, as both are installed; else where it was meant to be installed. It is of
 * this version to the last digit, and stays loaded. NULL: `why` tells. */
void *tp_library_beside(const char *name, tp_library_why *why);

#endif
