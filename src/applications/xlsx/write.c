/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The table of a batch as a worksheet, by libxlsxwriter: into a file beside, then whole to its
 * place. Texts are written as strings, never as formulas. */

#include "common/message.h"
#include "output/file.h"
#include "output/text.h"
#include "terms/names.h"
#include "xlsx/xlsx.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <xlsxwriter.h>

enum { COLUMNS = 14, EXCEL_TEXT = 32767, FACTOR_DECIMALS = 6 };

typedef struct sheet {
  lxw_worksheet *to;
  lxw_format *bold, *angle, *factor;
  lxw_error error; /* the first */
} sheet;

static void note(sheet *s, lxw_error error) {
  if (s->error == LXW_NO_ERROR) s->error = error;
}

/* Plain, and as long as a cell may be. */
static void put_text(sheet *s, lxw_row_t row, lxw_col_t column, const char *text,
                     lxw_format *format) {
  if (text == NULL || text[0] == '\0') return;
  char *plain = malloc(EXCEL_TEXT);
  if (plain == NULL) {
    note(s, LXW_ERROR_MEMORY_MALLOC_FAILED);
    return;
  }
  tp_plain_text(plain, EXCEL_TEXT, text);
  note(s, worksheet_write_string(s->to, row, column, plain, format));
  free(plain);
}

static void put_number(sheet *s, lxw_row_t row, lxw_col_t column, bool known, double value,
                       lxw_format *format) {
  if (known) note(s, worksheet_write_number(s->to, row, column, value, format));
}

static void put_heads(sheet *s) {
  static const struct {
    const char *head;
    double width;
  } columns[COLUMNS] = {{"Block", 20},
                        {"Stands?", 16},
                        {"FoS", 12},
                        {"against", 22},
                        {"required", 10},
                        {"requirement", 12},
                        {"margin (\xc2\xb0)", 12},
                        {"dip (\xc2\xb0)", 10},
                        {"line", 8},
                        {"case", 20},
                        {"required/FoS", 12},
                        {"FoS at least", 12},
                        {"FoS at most", 12},
                        {"remark", 60}};
  for (int column = 0; column < COLUMNS; column++) {
    const lxw_col_t k = (lxw_col_t)column;
    note(s, worksheet_set_column(s->to, k, k, columns[k].width, NULL));
    put_text(s, 0, k, columns[k].head, s->bold);
  }
  worksheet_freeze_panes(s->to, 1, 1);
}

/* A proven bound of a factor, outwards to the digits that the cell shows. */
static double rounded(double bound, bool up) {
  char n[TP_NUMBER_SIZE];
  const tp_bounded number = {.value = bound};
  if (!isfinite(bound)) return bound;
  return strtod((up ? tp_text_fixed_up : tp_text_fixed_down)(n, number, FACTOR_DECIMALS), NULL);
}

static void put_row(sheet *s, lxw_row_t at, const tp_batch_row *row) {
  const bool number = row->has_case && row->fos.state == TP_FOS_NUMBER;
  put_text(s, at, 0, row->name, NULL);
  put_text(s, at, 1, tp_batch_standing_name(row->standing), NULL);
  char n[TP_NUMBER_SIZE];
  /* rounded down to the digits that the cell shows, and a utilisation up */
  const double factor = strtod(tp_text_fixed_down(n, row->fos.value, FACTOR_DECIMALS), NULL);
  const double utilisation =
      strtod(tp_text_fixed_up(n, row->design_utilisation, FACTOR_DECIMALS), NULL);
  put_number(s, at, 2, number, factor, s->factor);
  if (row->has_case && row->fos.state == TP_FOS_NO_OVERTURNING)
    put_text(s, at, 2, "unbounded", NULL);
  if (row->has_case && row->fos.state == TP_FOS_UNDEFINED) put_text(s, at, 2, "none", NULL);
  if (row->has_case && row->fos.state == TP_FOS_UNDECIDED) put_text(s, at, 2, "undecided", NULL);
  if (row->has_fos_mechanism) put_text(s, at, 3, tp_mechanism_name(row->fos_mechanism), NULL);
  put_number(s, at, 4, row->has_required_fos, row->required_fos.value, s->factor);
  if (row->has_required_fos) put_text(s, at, 5, tp_design_name(row->meets_required), NULL);
  put_number(s, at, 6, row->has_margin, row->margin_deg.value, s->angle);
  put_number(s, at, 7, row->has_case, row->dip_deg.value, s->angle);
  put_number(s, at, 8, true, (double)row->line, NULL);
  put_text(s, at, 9, row->load_case, NULL);
  put_number(s, at, 10, row->has_design_utilisation, utilisation, s->factor);
  const bool bounded = row->has_case && row->fos.state == TP_FOS_UNDECIDED;
  put_number(s, at, 11, bounded && row->at_least > 0, rounded(row->at_least, false), s->factor);
  put_number(s, at, 12, bounded && isfinite(row->at_most), rounded(row->at_most, true), s->factor);
  put_text(s, at, 13, row->remark, NULL);
}

static lxw_error write_book(const char *path, const tp_batch *batch) {
  lxw_workbook *book = workbook_new(path);
  if (book == NULL) return LXW_ERROR_MEMORY_MALLOC_FAILED;
  lxw_doc_properties properties = {.created = 946684800}; /* 2000, not the time of day */
  sheet s = {.to = workbook_add_worksheet(book, "Blocks"),
             .bold = workbook_add_format(book),
             .angle = workbook_add_format(book),
             .factor = workbook_add_format(book)};
  if (s.to == NULL || s.bold == NULL || s.angle == NULL || s.factor == NULL) {
    (void)workbook_close(book);
    return LXW_ERROR_MEMORY_MALLOC_FAILED;
  }
  note(&s, workbook_set_properties(book, &properties));
  format_set_bold(s.bold);
  format_set_num_format(s.angle, "0.000");
  format_set_num_format(s.factor, "0.000###");
  put_heads(&s);
  for (size_t k = 0; k < batch->row_count; k++) put_row(&s, (lxw_row_t)k + 1, batch->rows + k);
  note(&s, workbook_close(book));
  return s.error;
}

/* The whole of a file, to be freed. */
static char *read_whole(const char *path, size_t *length) {
  FILE *file = fopen(path, "rb");
  char *bytes = NULL;
  long size = 0;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) > 0 && fseek(file, 0, SEEK_SET) == 0) {
    bytes = malloc((size_t)size);
  }
  if (bytes != NULL && fread(bytes, 1, (size_t)size, file) != (size_t)size) {
    free(bytes);
    bytes = NULL;
  }
  fclose(file);
  *length = (size_t)size;
  return bytes;
}

tp_status tp_xlsx_write(const char *path, const tp_batch *batch, tp_message *message) {
  char *beside = NULL, *bytes = NULL;
  size_t length = 0;
  const int descriptor = tp_file_create_beside(&beside, path);
  if (descriptor < 0) return tp_fail_file(message, path, "written", errno);
  close(descriptor);
  const lxw_error error = write_book(beside, batch);
  if (error == LXW_NO_ERROR) bytes = read_whole(beside, &length);
  unlink(beside);
  free(beside);
  if (error == LXW_ERROR_MEMORY_MALLOC_FAILED) return tp_fail_memory(message, "a worksheet");
  if (bytes == NULL) {
    return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){path, 0, 0}, "cannot be written: %s",
                   error != LXW_NO_ERROR ? lxw_strerror(error) : "it cannot be read again");
  }
  const tp_file_sources sources = {batch->source_count, (const char *const *)batch->sources};
  const tp_status status = tp_file_write(path, bytes, length, sources, message);
  free(bytes);
  return status;
}
