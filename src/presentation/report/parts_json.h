/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The parts of JSON that reports of several results share. */

#ifndef TP_REPORT_PARTS_JSON_H
#define TP_REPORT_PARTS_JSON_H

#include "output/json.h"

/* A factor of safety; null where it is no number, and `key_is` says in words what it is then, as it
 * does of one below zero. */
void tp_json_fos(tp_json *json, const char *key, tp_fos fos);

/* null, and the words in `key_is`. */
void tp_json_no_fos(tp_json *json, const char *key, const char *words);

/* `tie_is`: exact, or as far as so many bits tell; nothing where there is no tie. */
void tp_json_tie(tp_json *json, bool tie, long bits);

/* {"numerator": n, "denominator": d} */
void tp_json_fraction(tp_json *json, const char *key, const tp_fraction *fraction);

/* {"x_m": x, "y_m": y} */
void tp_json_point(tp_json *json, const char *key, tp_bounded x_m, tp_bounded y_m);

/* A number, or null where it is not known. */
void tp_json_known(tp_json *json, const char *key, bool known, tp_bounded number);

/* The key `critical_angle_deg` of a pivot; null where loads leave it none, and why. */
void tp_json_critical_angle(tp_json *json, const tp_pivot *pivot);

#endif
