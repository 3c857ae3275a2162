/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "output/json.h"

#include <math.h>

void tp_json_number(tp_text *t, const char *key, tp_bounded number) {
  if (!isfinite(number.error)) {
    tp_text_add(t, "\"%s\": null", key);
  } else {
    tp_text_add(t, "\"%s\": {\"value\": %.17g, \"error\": %.17g", key, number.value, number.error);
    if (number.digits != NULL) tp_text_add(t, ", \"digits\": \"%s\"", number.digits);
    tp_text_add(t, "}");
  }
}

const char *tp_json_truth(bool value) {
  return value ? "true" : "false";
}
