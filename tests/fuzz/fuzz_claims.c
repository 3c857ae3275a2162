/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Claims files: read, judged, reported. The folder of the examples is where their scenes lie. */

#include "fuzz.h"

#include <stdlib.h>

typedef tp_status (*verification_report)(char **text, const tp_verification *verification);

static void report(const tp_verification *verification) {
  static const verification_report reports[] = {tp_report_verification, tp_report_verification_json,
                                                tp_report_verification_markdown};
  size_t tallied = 0;
  for (int k = 0; k < TP_VERDICTS; k++) tallied += verification->tally[k];
  FUZZ_EXPECT(tallied == verification->count);
  for (size_t k = 0; k < sizeof reports / sizeof reports[0]; k++) {
    char *text = NULL;
    FUZZ_EXPECT(reports[k](&text, verification) == TP_OK);
    free(text);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *text = fuzz_text(data, size);
  tp_verification *verification = NULL;
  tp_message message = {.text = ""};
  const tp_status status =
      tp_verify_text(&verification, text, FUZZ_EXAMPLES "/claims.yaml", &message);
  fuzz_judge(status, verification, &message);
  if (status == TP_OK) report(verification);
  tp_verification_free(verification);
  free(text);
  return 0;
}
