/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads a column of a CSV file line by line as exact numbers rounded to doubles, with a hash of the
 * file. */

#include "study/column.h"

#include "common/grow.h"
#include "common/input_file.h"
#include "common/outside.h"
#include "format/csv_row.h"
#include "number/ratio.h"
#include "study/hash.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_LINE = 1 << 16 };

/* A file as its lines go by. */
typedef struct table {
  const tp_study_reader *reader;
  const char *path, *name;
  int line, field; /* field: of the column; -1 until the header */
  char separator;
  double *values;
  long count, room;
} table;

static tp_status fail_row(const table *t, int column, const char *what, const char *text) {
  return tp_refuse(t->reader->message, TP_FAULT_KEY, (tp_place){t->path, t->line, column}, "%s%s",
                   what, text);
}

static bool is_name(const tp_csv_row *row, int field, const char *name) {
  const tp_csv_field own = row->fields[field];
  return own.length == strlen(name) && strncmp(row->text + own.at, name, own.length) == 0;
}

/* Nothing of the file is quoted: without the column nothing says that it is a table
 * (docs/outside.md). */
static tp_status fail_name(const table *t, const tp_csv_row *row) {
  return tp_refuse(
      t->reader->message, TP_FAULT_KEY, (tp_place){t->path, t->line, 1},
      "no column of the first line, which has %d, is called '%s'; write its name letter "
      "by letter as that line does",
      row->count, tp_quote_all(t->name).text);
}

static tp_status take_header(table *t, const tp_csv_row *row) {
  t->separator = row->separator;
  for (int k = 0; k < row->count; k++) {
    if (!is_name(row, k, t->name)) continue;
    t->field = k;
    return TP_OK;
  }
  return fail_name(t, row);
}

static tp_status take_number(table *t, const tp_csv_row *row) {
  const char *problem = NULL;
  if (t->field >= row->count) return fail_row(t, 1, "the row ends before the column of ", t->name);
  const tp_csv_field field = row->fields[t->field];
  fmpq_t exact;
  fmpq_init(exact);
  const bool read = tp_ratio_read_field(exact, row->text + field.at, field.length, &problem);
  const double value = read ? tp_study_double(exact) : 0;
  fmpq_clear(exact);
  if (!read) return fail_row(t, (int)field.at + 1, "the number ", problem);
  if (t->count == TP_STUDY_LISTED) return fail_row(t, 1, "more than a million rows", "");
  double *grown = tp_grow(t->values, t->count, &t->room, sizeof *grown);
  if (grown == NULL) return tp_fail_memory(t->reader->message, "a column");
  t->values = grown;
  t->values[t->count++] = value;
  return TP_OK;
}

static tp_status take_lines(table *t, FILE *file) {
  char *text = malloc(LONGEST_LINE);
  tp_status status = text != NULL ? TP_OK : tp_fail_memory(t->reader->message, "a column");
  errno = 0;
  while (status == TP_OK && fgets(text, LONGEST_LINE, file) != NULL) {
    size_t length = strlen(text);
    t->line++;
    if ((length == 0 || text[length - 1] != '\n') && !feof(file)) {
      status = fail_row(t, 1,
                        "a line of more than 65535 bytes, or one with a byte of zero; is this "
                        "a table in CSV?",
                        "");
      break;
    }
    while (length > 0 && (text[length - 1] == '\n' || text[length - 1] == '\r')) length--;
    tp_csv_row row;
    tp_csv_split(&row, text, length, t->separator);
    if (row.count == 0) continue;
    status = t->field < 0 ? take_header(t, &row) : take_number(t, &row);
  }
  free(text);
  const bool failed = status == TP_OK && ferror(file) != 0;
  return failed ? tp_fail_file(t->reader->message, t->path, "read", errno) : status;
}

static tp_status read_table(table *t) {
  FILE *file = NULL;
  tp_status status = tp_input_open(&file, t->path, t->reader->message);
  if (status != TP_OK) return status;
  status = take_lines(t, file);
  fclose(file);
  if (status == TP_OK && t->count == 0) {
    status = fail_row(t, 0, "there is no row below the first line, which names the columns", "");
  }
  return status;
}

tp_status tp_study_read_column(const tp_study_reader *reader, tp_variable *variable,
                               const tp_node *node) {
  const char *colon = node->kind == TP_NODE_SCALAR ? strrchr(node->text, ':') : NULL;
  if (colon == NULL || colon == node->text || colon[1] == '\0') {
    return tp_study_fail(reader, node, "name a file and its column, as in 'tests.csv:phi_deg'");
  }
  char *name = strndup(node->text, (size_t)(colon - node->text));
  variable->file = name != NULL ? tp_study_beside(reader->study, name) : NULL;
  free(name);
  if (variable->file == NULL) return tp_fail_memory(reader->message, "a column");
  table t = {.reader = reader, .path = variable->file, .name = colon + 1, .field = -1};
  const tp_status status = read_table(&t);
  variable->values = t.values;
  variable->count = (size_t)t.count;
  return status == TP_OK ? tp_hash_file(&reader->study->hash, variable->file, reader->message)
                         : status;
}
