/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A double as the shortest decimal that names it. */

#ifndef TP_NUMBER_SHORTEST_H
#define TP_NUMBER_SHORTEST_H

enum { TP_SHORTEST_SIZE = 32 };

/* The shortest of the decimals of 15 to 17 digits that name the double, which is finite. */
const char *tp_shortest(char out[TP_SHORTEST_SIZE], double value);

#endif
