/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* CSV files of points; the first byte says whether they close. */

#include "fuzz.h"
#include "scene/csv.h"

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size == 0) return -1;
  char *text = fuzz_text(data + 1, size - 1);
  tp_polyline line;
  tp_notes notes = {0};
  tp_message message = {.text = ""};
  const char *unit = NULL;
  const tp_status status =
      tp_csv_read_text(&line, &unit, text, "text", data[0] % 2 != 0, &notes, &message);
  if (status == TP_OK) {
    FUZZ_EXPECT(line.count > 0);
    for (long k = 0; k < line.count; k++) {
      FUZZ_EXPECT(fmpq_is_canonical(line.x + k) && fmpq_is_canonical(line.y + k));
      FUZZ_EXPECT(line.marks[k].line > 0 && line.marks[k].column > 0);
    }
  } else {
    FUZZ_EXPECT(message.text[0] != '\0' && line.count == 0);
  }
  tp_polyline_clear(&line);
  tp_notes_clear(&notes);
  free(text);
  return 0;
}
