/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The sheet of a simulated tilt test. Its numbers have no proven bound, which it says first. */

#include "report/sheet.h"

#include "report/tilt_text.h"
#include "report/words.h"

#include <math.h>

static void add_verdict(tp_document *d, const tp_tilt_case *c, const tp_tilt_test *test) {
  tp_text verdict = {0}, ending = {0};
  tp_document_heading(d, 2, "%s", tp_document_say(d, tp_text_table(test, c)));
  /* of a block that is shaken, or let go, the answer is how it ended; statics follow
   */
  const bool released = test->settings.protocol == TP_TILT_RELEASE;
  tp_tilt_add_verdict(&verdict, c, test);
  tp_tilt_add_ending(&ending, c, test);
  tp_sheet_prose(d, TP_PASSAGE_ANSWER, released ? &ending : &verdict);
  tp_sheet_prose(d, TP_PASSAGE_PARAGRAPH, released ? &verdict : &ending);
}

static void add_angle(tp_document *d, const char *name, bool known, double degrees) {
  if (!known) return;
  tp_document_word(d, name);
  tp_document_cell(d, "%.6g°", degrees);
}

static void add_numbers(tp_document *d, const tp_tilt_case *c, const tp_tilt_test *test,
                        const tp_sheet_options *options) {
  const bool released = test->settings.protocol == TP_TILT_RELEASE;
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Numbers of the test");
  add_angle(d, "Stands at", !released && c->stands_at_deg == c->stands_at_deg, c->stands_at_deg);
  add_angle(d, "Begins to move at", c->has_bracket, c->lets_go_at_deg);
  add_angle(d, "Statics, α_s", c->has_onset, c->onset_deg);
  add_angle(d, "Statics, α_w", c->has_limit, c->limit_deg);
  add_angle(d, "Peak rotation", c->has_peak_turn, fabs(c->peak_turn_deg));
  add_angle(d, "Balance angle", c->has_peak_turn && c->has_balance_turn, c->balance_turn_deg);
  if (c->has_peak_turn && c->has_balance_turn) {
    tp_document_word(d, "Peak rotation over balance angle");
    tp_document_cell(d, "%.3g %%", 100 * c->peak_over_balance);
  }
  tp_document_cell(d, "Final state");
  tp_document_cell(d, "%s, at a tilt of %.6g°", tp_document_say(d, tp_tilt_end_name(c->end)),
                   c->ended_deg);
  tp_document_cell(d, "Runs");
  if (options->times != 0) {
    tp_document_cell(d, "%zu, in %.3g s", c->runs, c->seconds);
  } else {
    tp_document_cell(d, "%zu", c->runs);
  }
}

static void add_event(tp_document *d, const tp_tilt_event *e, const tp_tilt_case *c,
                      const tp_tilt_test *test) {
  tp_text words = {0};
  tp_document_cell(d, "%.4f", e->angle_deg);
  if (test->settings.engine != TP_TILT_PATH) tp_document_cell(d, "%.4f", e->time_s);
  tp_tilt_add_event_words(&words, e, c, test);
  tp_document_told_cell(d, words.failed ? "" : words.data);
  d->failed = d->failed || words.failed;
  tp_text_drop(&words);
}

/* What is told once of several, to and fro. */
static void add_chatter(tp_document *d, const tp_tilt_test *test, size_t times) {
  tp_document_word(d, "");
  if (test->settings.engine != TP_TILT_PATH) tp_document_word(d, "");
  tp_document_cell(d, "alternating, %zu times in all, until it", times);
}

static void add_events(tp_document *d, const tp_tilt_case *c, const tp_tilt_test *test) {
  const bool timed = test->settings.engine != TP_TILT_PATH;
  tp_text facets = {0};
  size_t k = 0;
  tp_document_heading(d, 3, "Events");
  tp_tilt_add_facets(&facets, c, test);
  if (facets.length > 0) {
    tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Facets of the base, and of the contact");
    tp_sheet_fact_lines(d, &facets);
  }
  tp_document_table(d, TP_TABLE_OF_COLUMNS, timed ? 3 : 2, timed ? 3 : 1,
                    "Events (facets of the base from left to right)");
  tp_document_cell(d, "Tilt (°)");
  if (timed) tp_document_cell(d, "Time (s)");
  tp_document_cell(d, "Event");
  for (size_t rows = 0; k < c->event_count && rows < TP_TILT_EVENTS_TOLD; rows++) {
    const size_t length = tp_tilt_chatter_length(c, k);
    const bool several = length >= TP_TILT_CHATTER;
    add_event(d, c->events + k, c, test);
    if (several) add_chatter(d, test, length);
    if (several) add_event(d, c->events + k + length - 1, c, test);
    k += several ? length : 1;
  }
  if (k < c->event_count) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH, "and %zu more (listed by --json)", c->event_count - k);
  }
}

static void add_case(tp_document *d, const tp_tilt_case *c, const tp_tilt_test *test,
                     const tp_sheet_options *options) {
  tp_document_heading(d, 2, "Account: %s", tp_document_say(d, tp_text_table(test, c)));
  add_numbers(d, c, test, options);
  if (c->event_count > 0) add_events(d, c, test);
}

void tp_sheet_build_tilt(tp_document *document, const tp_tilt_test *test,
                         const tp_sheet_files *files, const tp_sheet_options *options,
                         tp_sheet_head *head, tp_picture frames, const tp_sheet_picture *charts,
                         size_t count) {
  tp_document own = {.language = head->language, .comma = head->comma}, *d = &own;
  tp_text settings = {0};
  tp_sheet_set_letterhead(d, head);
  tp_sheet_add_title(d, test->title, "Simulated tilt test of a rock block");
  tp_sheet_add_foot(d, files, options);
  tp_sheet_add_persons(d, head);
  tp_document_add(d, TP_PASSAGE_CAUTION,
                  "A simulation: its numbers have no proven bound. The static tilts α_s and α_w "
                  "given beside them do; topple solve --report documents these.");
  for (size_t k = 0; k < test->case_count; k++) add_verdict(d, test->cases + k, test);
  tp_sheet_add_notes(d, &test->notes);
  tp_document_heading(d, 2, "Figure");
  tp_document_figure(d, frames, "The block at some moments of its test.",
                     "Drawings of the block on its base at some moments. The events are listed in "
                     "the text of this page.");
  tp_document_heading(d, 2, "Test settings");
  tp_tilt_add_settings(&settings, test);
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "What was simulated, and with which numbers");
  tp_sheet_fact_lines(d, &settings);
  for (size_t k = 0; k < test->case_count; k++) add_case(d, test->cases + k, test, options);
  tp_sheet_add_charts(d, charts, count);
  tp_sheet_add_origin(d, files, options);
  tp_sheet_add_files(d, files, options);
  tp_sheet_add_signatures(d, head);
  *document = own;
}
