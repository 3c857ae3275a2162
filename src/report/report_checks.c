/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "report/report_checks.h"

#include "report/json.h"

#include <string.h>

void tp_text_check(tp_text *t, const tp_derived_checks *checks, size_t condition,
                   const char *what) {
  for (size_t k = 0; k < checks->count; k++) {
    const tp_derived_check *c = checks->items + k;
    if (c->number != condition) continue;
    tp_text_add(t, "      solved at %s: the %s is the formula's; at %s: ", c->inside, what,
                c->outside);
    switch (c->beyond) {
    case TP_CHECK_SAME:
      tp_text_add(t, "it still is\n");
      break;
    case TP_CHECK_OTHER:
      tp_text_add(t, "it is another\n");
      break;
    case TP_CHECK_NONE:
      tp_text_add(t, "there is none\n");
      break;
    case TP_CHECK_CONTACT:
      tp_text_add(t, "the contact is another\n");
      break;
    case TP_CHECK_REFUSED:
      tp_text_add(t, "the scene has no answer\n");
      break;
    case TP_CHECK_UNDECIDED:
      tp_text_add(t, "undecided\n");
      break;
    }
  }
}

void tp_text_unmet(tp_text *t, const tp_derived_checks *checks, size_t conditions) {
  if (!checks->run || checks->count >= conditions) return;
  tp_text_add(t, "  (%zu of these %zu: others fail first in all directions tried)\n",
              conditions - checks->count, conditions);
}

static const char *verdict_name(tp_check_verdict verdict) {
  static const char *const names[] = {"same", "other", "none", "contact", "refused", "undecided"};
  return names[verdict];
}

/* "c = 7.41, b = 100" as {"c": 7.41, "b": 100}. */
static void add_numbers(tp_text *t, const char *text) {
  tp_text_add(t, "{");
  while (*text != '\0') {
    const size_t key = strcspn(text, " "), number = strcspn(text + key + 3, ",");
    tp_text_add(t, "\"%.*s\": %.*s", (int)key, text, (int)number, text + key + 3);
    text += key + 3 + number;
    if (*text == ',') {
      tp_text_add(t, ", ");
      text += 2;
    }
  }
  tp_text_add(t, "}");
}

void tp_json_checks(tp_text *t, const tp_derived_checks *checks) {
  if (!checks->run) return;
  tp_text_add(t, ",\n     \"checks\": [");
  for (size_t k = 0; k < checks->count; k++) {
    const tp_derived_check *c = checks->items + k;
    tp_text_add(t, "%s\n       {\"condition\": %zu, \"inside\": ", k == 0 ? "" : ",", c->number);
    add_numbers(t, c->inside);
    tp_text_add(t, ", \"outside\": ");
    add_numbers(t, c->outside);
    tp_text_add(t, ", \"beyond\": \"%s\"}", verdict_name(c->beyond));
  }
  tp_text_add(t, "]");
}
