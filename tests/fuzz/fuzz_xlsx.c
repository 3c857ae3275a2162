/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Parts of a workbook, unpacked: texts that cells share, styles, a worksheet; and the table that it
 * makes. The first byte says which part it is. */

#include "common/message.h"
#include "format/cells.h"
#include "fuzz.h"
#include "xlsx/book.h"

#include <stdlib.h>
#include <string.h>

static void read_table(const char *csv) {
  tp_cells cells = {0};
  tp_message message = {.text = ""};
  const tp_status status = tp_cells_read(&cells, "table", csv, &message);
  FUZZ_EXPECT(status == TP_OK || (message.text[0] != '\0' && cells.rows == NULL));
  if (status == TP_OK) FUZZ_EXPECT(cells.row_count > 1 && cells.rows[0].count > 0);
  tp_cells_clear(&cells);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static char first[] = "a text";
  char *bytes = fuzz_text(data, size);
  tp_message message = {.text = ""};
  tp_text csv = {0};
  tp_book book = {.path = "book", .message = &message, .sheet = "sheet"};
  if (size > 0) {
    book.bytes = bytes + 1;
    book.length = size - 1;
    tp_status status = TP_OK;
    switch (data[0] % 3) {
    case 0:
      status = tp_book_read_strings(&book);
      break;
    case 1:
      status = tp_book_read_styles(&book);
      break;
    default:
      book.strings = malloc(sizeof *book.strings);
      FUZZ_EXPECT(book.strings != NULL);
      book.strings[book.string_count++] = strdup(first);
      status = tp_book_read_sheet(&book, &csv);
      if (status == TP_OK && csv.data != NULL) read_table(csv.data);
    }
    FUZZ_EXPECT(status == TP_OK || message.text[0] != '\0');
  }
  tp_text_drop(&csv);
  tp_book_clear(&book);
  free(bytes);
  return 0;
}
