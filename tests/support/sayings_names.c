/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of enumerations, one past the last among them, and calls on texts, which a locale must not
 * sort into letters and others. */

#define _GNU_SOURCE
#include "sayings.h"

#include <string.h>

static void note_text(sayings *s, const char *text) {
  *next_saying(s) = strdup(text);
}

static void say_version(sayings *s) {
  note_text(s, tp_version());
  note_number(s, tp_version_number());
  note_text(s, tp_figure_version());
}

static void say_enumerations(sayings *s) {
  for (int k = 0; k <= TP_DEPENDENCY_FAILED + 1; k++) {
    note_text(s, tp_status_meaning((tp_status)k));
    note_number(s, tp_status_exit((tp_status)k));
  }
  for (int k = 0; k <= TP_FAULT_ARGUMENT + 1; k++) note_text(s, tp_fault_name((tp_fault)k));
  for (int k = 0; k <= TP_LEVELS; k++) note_text(s, tp_level_name((tp_level)k));
  for (int k = 0; k <= TP_CAUTION + 1; k++) note_text(s, tp_note_kind_name((tp_note_kind)k));
  for (int k = 0; k <= TP_VERDICTS; k++) note_text(s, tp_verdict_name((tp_verdict)k));
  for (int k = 0; k <= TP_FOS_BY_DRIVING + 1; k++) {
    note_text(s, tp_fos_definition_name((tp_fos_definition)k));
  }
  for (int k = 0; k <= TP_BATCH_STANDINGS; k++) {
    note_text(s, tp_batch_standing_name((tp_batch_standing)k));
  }
  for (int k = 0; k <= TP_FACTOR_UNAFFECTED + 1; k++) {
    note_text(s, tp_factor_standing_name((tp_factor_standing)k));
  }
  for (int k = 0; k <= TP_MECHANISM_UNDECIDED + 1; k++) {
    note_text(s, tp_mechanism_name((tp_mechanism)k));
  }
  for (int k = 0; k <= TP_SYSTEM_UNDECIDED + 1; k++) {
    note_text(s, tp_system_verdict_name((tp_system_verdict)k));
  }
  for (int k = 0; k <= TP_SOLID_STANDS + 1; k++) {
    note_text(s, tp_solid_outlook_name((tp_solid_outlook)k));
  }
  for (int k = 0; k <= TP_JOINT_OPENS + 1; k++) {
    note_text(s, tp_joint_state_name((tp_joint_state)k));
  }
  for (int k = 0; k <= TP_SYSTEM_LOAD_FORCE + 1; k++) {
    note_text(s, tp_system_load_kind_name((tp_system_load_kind)k));
  }
  for (int k = 0; k <= TP_TOUCH_SLIPS_BACK + 1; k++) {
    note_text(s, tp_touch_state_name((tp_touch_state)k));
  }
  for (int k = 0; k <= TP_COLUMN_SLIDES + 1; k++) {
    note_text(s, tp_column_state_name((tp_column_state)k));
  }
  for (int k = 0; k <= TP_SETTLING_UNDECIDED + 1; k++) {
    note_text(s, tp_settling_end_name((tp_settling_end)k));
  }
  for (int k = 0; k <= TP_ACCURACY_METHODS; k++) {
    note_text(s, tp_accuracy_method_name((tp_accuracy_method)k));
  }
  for (int k = 0; k <= TP_FIND_ACCELERATION + 1; k++) {
    note_text(s, tp_find_target_name((tp_find_target)k));
  }
  for (int k = 0; k <= TP_STUDY_OUTCOMES; k++) {
    note_text(s, tp_study_outcome_name((tp_study_outcome)k));
  }
  for (int k = 0; k <= TP_STUDY_QUANTITIES; k++) {
    note_text(s, tp_study_quantity_name((tp_study_quantity)k));
  }
}

static void say_tilt_names(sayings *s) {
  for (int k = 0; k <= TP_TILT_STOPPED + 1; k++) note_text(s, tp_tilt_end_name((tp_tilt_end)k));
  for (int k = 0; k <= TP_TILT_SPRINGS + 1; k++) {
    note_text(s, tp_tilt_engine_name((tp_tilt_engine)k));
  }
  for (int k = 0; k <= TP_TILT_RELEASE + 1; k++) {
    note_text(s, tp_tilt_protocol_name((tp_tilt_protocol)k));
  }
  for (int k = 0; k <= TP_EVENT_ACCUMULATES + 1; k++) {
    note_text(s, tp_tilt_event_name((tp_tilt_event_kind)k));
  }
}

static void say_converge_names(sayings *s) {
  for (int k = 0; k <= TP_CONVERGE_SETTINGS; k++) {
    note_text(s, tp_converge_setting_name((tp_converge_setting)k));
  }
  for (int k = 0; k <= TP_CONVERGE_OVERTURNING + 1; k++) {
    note_text(s, tp_converge_quantity_name((tp_converge_quantity)k));
  }
  for (int k = 0; k <= TP_CONVERGE_OPEN + 1; k++) {
    note_text(s, tp_converge_verdict_name((tp_converge_verdict)k));
  }
}

static void say_defaults(sayings *s) {
  const tp_find_options find = tp_find_options_default();
  const tp_chart_map_options map = tp_chart_map_options_default();
  note_number(s, (long)find.target);
  note_text(s, map.y.key);
  note_number(s, map.y.range.to == 90);
}

/* A word is told in UTF-8 whatever the host's locale, and so is what is nearest to another. */
static void say_words(sayings *s) {
  static const char *const words[] = {"FoS", "α_w", "tilt.angle_deg", "saftey factor", "\xff", ""};
  for (size_t k = 0; k < sizeof words / sizeof words[0]; k++) {
    tp_message message = {.text = ""};
    char **told = next_saying(s);
    const tp_status status = tp_report_explained(told, words[k], &message);
    if (status != TP_OK) s->count--;
    note_status(s, status, &message);
  }
  if (tp_report_terms(next_saying(s)) != TP_OK) s->count--;
}

void say_names(sayings *s) {
  static const char *const words[] = {"ball",      "EXACT", "limit_fos", "Limit_Fos",
                                      "chart.SVG", "x.pdf", "a.b/c",     ""};
  char plain[40];
  say_version(s);
  say_enumerations(s);
  say_words(s);
  say_tilt_names(s);
  say_converge_names(s);
  say_defaults(s);
  for (size_t k = 0; k < sizeof words / sizeof words[0]; k++) {
    tp_level level = TP_LEVEL_DOUBLE;
    tp_find_target target = TP_FIND_FOS;
    tp_chart_format format = TP_CHART_CSV;
    note_number(s, tp_level_read(&level, words[k]));
    note_number(s, (long)level);
    note_number(s, tp_find_target_read(&target, words[k]));
    note_number(s, (long)target);
    note_number(s, tp_chart_format_read(&format, words[k]));
    note_number(s, (long)format);
    note_number(s, tp_figure_is_file_name(words[k]));
  }
  tp_plain_text(plain, sizeof plain,
                "Stra\xc3\x9f"
                "e \xe4\t\x1b[1m\xe2\x80\xae 1,5 and much more");
  note_text(s, plain);
}
