/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A simulated tilt test as a page of 80 columns, put together from the parts of
 * report/tilt_text.h. */

#include "common/host.h"
#include "output/encode.h"
#include "report/notes.h"
#include "report/tilt_text.h"
#include "report/words.h"

static void add_case(tp_text *t, const tp_tilt_case *c, const tp_tilt_test *test) {
  tp_text_add(t, "\n%s\n\n", tp_text_table(test, c));
  tp_tilt_add_verdict(t, c, test);
  tp_tilt_add_events(t, c, test);
  tp_tilt_add_ending(t, c, test);
  tp_text_add(t, "  %zu run%s, %.3g s. Simulated: no bound is proven.\n", c->runs,
              c->runs == 1 ? "" : "s", c->seconds);
}

tp_status tp_report_tilt(char **text, const tp_tilt_test *test) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, test);
  tp_text t = {0};
  if (test->title != NULL) {
    tp_encode_plain(&t, test->title);
    tp_text_add(&t, "\n\n");
  }
  tp_tilt_add_settings(&t, test);
  for (size_t k = 0; k < test->case_count; k++) add_case(&t, test->cases + k, test);
  if (test->notes.count > 0) tp_text_add(&t, "\n");
  tp_text_notes(&t, &test->notes);
  return tp_text_finish(&t, text);
}
