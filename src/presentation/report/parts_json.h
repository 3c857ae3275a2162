/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The parts of JSON that reports of several results share. */

#ifndef TP_REPORT_PARTS_JSON_H
#define TP_REPORT_PARTS_JSON_H

#include "output/json.h"

/* How far two results that tie are known to be equal: "exact", or as far as so many bits tell. */
void tp_json_tie(tp_json *json, const char *key, long bits);

/* {"numerator": n, "denominator": d} */
void tp_json_fraction(tp_json *json, const char *key, const tp_fraction *fraction);

/* {"x_m": x, "y_m": y} */
void tp_json_point(tp_json *json, const char *key, tp_bounded x_m, tp_bounded y_m);

/* Two such points in a list: the ends of a facet. */
void tp_json_ends(tp_json *json, const char *key, tp_bounded x0_m, tp_bounded y0_m, tp_bounded x1_m,
                  tp_bounded y1_m);

/* A number, or null where it is not known. */
void tp_json_known(tp_json *json, const char *key, bool known, tp_bounded number);

/* {"least": a, "most": b} */
void tp_json_range(tp_json *json, const char *key, double least, double most);

/* A number, or the word for one that is infinite: always, where it holds at every tilt, and never.
 */
void tp_json_number_or_word(tp_json *json, const char *key, double value);

/* The same number with the other sign. */
tp_bounded tp_bounded_negated(tp_bounded number);

#endif
