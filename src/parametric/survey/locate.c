/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where what is wrong with the scene of a row stands: in a column of the table, in the file that
 * the row is over, or in another file that one of these names. */

#include "common/outside.h"
#include "survey/survey.h"

#include <stdio.h>
#include <string.h>

/* The complaint behind the place that it begins with. */
static const char *without_place(const tp_message *message) {
  char place[sizeof message->text], plain[sizeof message->text];
  tp_place_text(place, sizeof place / 2, (tp_place){message->file, message->line, message->column});
  tp_plain_text(plain, sizeof plain, place);
  const size_t length = strlen(plain);
  const bool begins = length > 0 && strncmp(message->text, plain, length) == 0 &&
                      strncmp(message->text + length, ": ", 2) == 0;
  return begins ? message->text + length + 2 : message->text;
}

/* "block 'B3': case 'wet': ", or what of that it has. */
static void add_name(char *head, size_t size, const tp_survey *survey, size_t row,
                     const char *load_case) {
  const char *name = tp_survey_cell(survey, row, TP_COLUMN_NAME);
  head[0] = '\0';
  if (name != NULL) snprintf(head, size, "block '%s': ", tp_quote_all(name).text);
  const size_t used = strlen(head);
  if (load_case != NULL) {
    snprintf(head + used, size - used, "case '%s': ", tp_quote_all(load_case).text);
  }
}

void tp_survey_locate(tp_message *message, const tp_survey *survey, size_t row,
                      const tp_scene_text *text, const char *load_case) {
  const tp_message own = *message;
  const char *rest = without_place(&own);
  const bool of_text = text->name != NULL && text->text != NULL &&
                       strcmp(own.file, text->name) == 0 && own.line > 0 &&
                       (size_t)own.line <= text->line_count;
  const tp_mark mark = of_text ? text->lines[own.line - 1].mark : (tp_mark){0, 0};
  const tp_place place = {survey->path, (int)survey->cells.rows[row].line, 0};
  char name[320], at[sizeof own.file + 40] = "";
  add_name(name, sizeof name, survey, row, load_case);
  if (mark.line < 0) {
    snprintf(at, sizeof at,
             "column '%s': ", tp_quote_all(survey->columns[-mark.line - 1].head).text);
  } else if (mark.line > 0) {
    snprintf(at, sizeof at, "%s:%d:%d: ", text->name, mark.line, mark.column);
  } else if (!of_text) {
    rest = strcmp(own.file, survey->path) == 0 ? rest : own.text;
  }
  tp_fail(message, TP_BAD_INPUT, place, "%s%s%s", name, at, rest);
  message->fault = own.fault;
  message->system_error = own.system_error;
}
