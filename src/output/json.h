/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The pieces of JSON that every report is made of. */

#ifndef TP_JSON_H
#define TP_JSON_H

#include "output/encode.h"

/* A computed number, `"key": {"value": v, "error": e}`; null where it lies outside the range of a
 * double. */
void tp_json_number(tp_text *text, const char *key, tp_bounded number);

/* true or false. */
const char *tp_json_truth(bool value);

#endif
