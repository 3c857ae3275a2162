/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A workbook opened, its parts read in their order, its first worksheet handed over as CSV. */

#include "common/input_file.h"
#include "common/message.h"
#include "xlsx/book.h"
#include "xlsx/xlsx.h"

#include <stdlib.h>

void tp_book_clear(tp_book *book) {
  for (size_t k = 0; k < book->string_count; k++) free(book->strings[k]);
  free(book->strings);
  free(book->is_date);
  if (book->zip != NULL) zip_discard(book->zip);
}

tp_status tp_xlsx_read(char **csv, const char *path, tp_message *message) {
  int why = 0;
  tp_text text = {0};
  const tp_status readable = tp_input_check(path, message);
  if (readable != TP_OK) return readable;
  tp_book book = {.path = path, .message = message, .zip = zip_open(path, ZIP_RDONLY, &why)};
  if (book.zip == NULL) {
    zip_error_t error;
    zip_error_init_with_code(&error, why);
    const int system = zip_error_code_system(&error);
    zip_error_fini(&error);
    if (why == ZIP_ER_NOENT || why == ZIP_ER_OPEN || why == ZIP_ER_READ) {
      return tp_fail_file(message, path, "opened", system);
    }
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 0, 0},
                     "this is no .xlsx workbook; save the table as .xlsx, or as CSV");
  }
  tp_status status = tp_book_find_sheet(&book);
  if (status == TP_OK) status = tp_book_read_strings(&book);
  if (status == TP_OK) status = tp_book_read_styles(&book);
  if (status == TP_OK) status = tp_book_read_sheet(&book, &text);
  tp_book_clear(&book);
  if (status == TP_OK && text.data == NULL) tp_text_add(&text, "%s", "");
  if (status == TP_OK) {
    status = tp_text_finish(&text, csv) == TP_OK ? TP_OK : tp_fail_memory(message, "a worksheet");
  } else {
    tp_text_drop(&text);
  }
  return status;
}
