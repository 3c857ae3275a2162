/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Accelerograms from files: the first byte says whether it is one of PEER's or CSV, and which
 * column of that has the accelerations; the rest is the file. One that is read has numbers at
 * places of the file; one whose steps are even counts from zero, and on. */

#include "fuzz.h"
#include "scene/record.h"
#include "study_folder.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size == 0) return -1;
  const char *name = data[0] % 2 != 0 ? "record.at2" : "record.csv";
  char path[200];
  fuzz_study_write(name, (const char *)data + 1, size - 1);
  tp_polyline record;
  tp_message message = {.text = ""};
  const tp_status status =
      tp_record_read(&record, fuzz_study_path(path, name), data[0] / 2 % 4, &message);
  if (status == TP_OK) {
    FUZZ_EXPECT(record.count > 1 && fmpq_is_zero(record.x));
    for (long k = 0; k < record.count; k++) {
      FUZZ_EXPECT(fmpq_is_canonical(record.x + k) && fmpq_is_canonical(record.y + k));
      FUZZ_EXPECT(k == 0 || fmpq_cmp(record.x + k, record.x + k - 1) > 0);
      FUZZ_EXPECT(record.marks[k].line > 0 && record.marks[k].column > 0);
    }
  } else {
    FUZZ_EXPECT(status == TP_BAD_INPUT && message.text[0] != '\0' && record.count == 0);
  }
  tp_polyline_clear(&record);
  return 0;
}
