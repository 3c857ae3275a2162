/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Faults of a row in words, with their place. Where it stands: in a column of the table, in the
 * file that the row is over, or in another file that one of these names. */

#include "survey/faults.h"

#include "common/grow.h"
#include "common/outside.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

tp_status tp_row_faults_add(tp_row_faults *faults, size_t column, const char *value,
                            const char *text, tp_message *message) {
  tp_row_fault *items = tp_grow(faults->items, faults->count, &faults->room, sizeof *items);
  if (items == NULL) return tp_fail_memory(message, "a table");
  faults->items = items;
  tp_row_fault *own = items + faults->count++;
  *own = (tp_row_fault){.column = column, .text = strdup(text)};
  if (value != NULL) own->value = strdup(value);
  if (own->text == NULL || (value != NULL && own->value == NULL)) {
    return tp_fail_memory(message, "a table");
  }
  return TP_OK;
}

void tp_row_faults_clear(tp_row_faults *faults) {
  for (long k = 0; k < faults->count; k++) {
    free(faults->items[k].value);
    free(faults->items[k].text);
  }
  free(faults->items);
  *faults = (tp_row_faults){0};
}

/* ---- where -------------------------------------------------------------------------------------
 */

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

tp_status tp_row_faults_locate(tp_row_faults *faults, const tp_survey *survey,
                               const tp_scene_text *text, const char *load_case,
                               tp_message *message) {
  const char *rest = without_place(message);
  const bool of_text = text->name != NULL && text->text != NULL &&
                       strcmp(message->file, text->name) == 0 && message->line > 0 &&
                       (size_t)message->line <= text->line_count;
  const tp_mark mark = of_text ? text->lines[message->line - 1].mark : (tp_mark){0, 0};
  const tp_place place = {text->name, mark.line, mark.column};
  tp_text own = {0};
  if (load_case != NULL) tp_text_add(&own, "case '%s': ", tp_quote_all(load_case).text);
  if (mark.line > 0) {
    char at[sizeof message->file + 40];
    tp_place_text(at, sizeof at, place);
    tp_text_add(&own, "%s: ", at);
  } else if (!of_text && strcmp(message->file, survey->path) != 0) {
    rest = message->text;
  }
  tp_text_add(&own, "%s", rest);
  if (strstr(rest, "give its 'unit_weight_kn_m3'") != NULL) {
    tp_text_add(&own, ", in a column 'unit weight (kN/m3)'");
  }
  const tp_status status = own.failed
                               ? tp_fail_memory(message, "a table")
                               : tp_row_faults_add(faults, mark.line < 0 ? (size_t)-mark.line : 0,
                                                   NULL, own.data, message);
  tp_text_drop(&own);
  return status;
}

/* ---- words -------------------------------------------------------------------------------------
 */

void tp_fault_add_place(tp_text *text, const tp_survey *survey, size_t row, size_t column) {
  const tp_place place = {survey->path, (int)survey->cells.rows[row].line, (int)column};
  const char *name = tp_survey_cell(survey, row, TP_COLUMN_NAME);
  char *at = tp_place_new(place);
  if (at == NULL) text->failed = true;
  if (at != NULL) tp_text_add(text, "%s: ", at);
  if (name != NULL) tp_text_add(text, "block '%s': ", tp_quote_all(name).text);
  free(at);
}

void tp_fault_add(tp_text *text, const tp_survey *survey, const tp_row_fault *fault) {
  if (fault->column > 0) {
    tp_text_add(text, "column '%s': ", tp_quote_all(survey->columns[fault->column - 1].head).text);
  }
  if (fault->value != NULL) tp_text_add(text, "'%s' ", tp_quote_all(fault->value).text);
  tp_text_add(text, "%s", fault->text);
}

char *tp_fault_finish(tp_text *text) {
  char *own = NULL;
  if (tp_text_finish(text, &own) != TP_OK) return NULL;
  char *plain = tp_plain_new(own);
  free(own);
  return plain;
}

char *tp_row_faults_remark(const tp_row_faults *faults, const tp_survey *survey, size_t row) {
  tp_text text = {0};
  tp_fault_add_place(&text, survey, row, faults->count > 0 ? faults->items[0].column : 0);
  for (long k = 0; k < faults->count; k++) {
    if (k > 0) tp_text_add(&text, "; ");
    tp_fault_add(&text, survey, faults->items + k);
  }
  return tp_fault_finish(&text);
}
