/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The parts of JSON that reports of several results share. */

#ifndef TP_PARTS_JSON_H
#define TP_PARTS_JSON_H

#include "output/text.h"

/* A factor of safety; null where it is no number, and `"key_is"` says in words what it is then, as
 * it does of one below zero. */
void tp_json_fos(tp_text *text, const char *key, tp_fos fos);

/* `, "tie_is": "exact"`, or as far as so many bits tell; nothing where there is no tie. */
void tp_json_tie(tp_text *text, bool tie, long bits);

/* `"key": {"numerator": n, "denominator": d}` */
void tp_json_fraction(tp_text *text, const char *key, const tp_fraction *fraction);

/* The key `critical_angle_deg` of a pivot; null where loads leave it none, and why. */
void tp_json_critical_angle(tp_text *text, const tp_pivot *pivot);

#endif
