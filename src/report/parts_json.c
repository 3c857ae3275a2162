/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/parts_json.h"

#include "output/encode.h"
#include "output/json.h"
#include "report/words.h"

void tp_json_fraction(tp_text *t, const char *key, const tp_fraction *f) {
  tp_text_add(t, "\"%s\": {\"numerator\": ", key);
  tp_encode_json(t, f->numerator);
  tp_text_add(t, ", \"denominator\": ");
  tp_encode_json(t, f->denominator);
  tp_text_add(t, "}");
}

void tp_json_fos(tp_text *t, const char *key, tp_fos fos) {
  if (fos.state == TP_FOS_NUMBER) {
    tp_json_number(t, key, fos.value);
  } else {
    tp_text_add(t, "\"%s\": null", key);
  }
  const char *why = tp_text_fos(fos);
  if (why != NULL) tp_text_add(t, ", \"%s_is\": \"%s\"", key, why);
}

void tp_json_critical_angle(tp_text *t, const tp_pivot *p) {
  if (p->never || p->always) {
    tp_text_add(t, "\"critical_angle_deg\": null, \"critical_angle_is\": \"%s\"",
                p->never ? "never" : "always");
  } else {
    tp_json_number(t, "critical_angle_deg", p->critical_angle_deg);
  }
}

void tp_json_tie(tp_text *t, bool tie, long bits) {
  if (!tie) return;
  if (bits == 0) {
    tp_text_add(t, ", \"tie_is\": \"exact\"");
  } else {
    tp_text_add(t, ", \"tie_is\": \"not told apart by %ld bits\"", bits);
  }
}
