/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a call of the library may do while memory runs out: succeed, or say that it did. */

#ifndef TP_TEST_MEMORY_EXPECT_H
#define TP_TEST_MEMORY_EXPECT_H

#include "failing_memory.h"
#include "runner.h"
#include "topple.h"

#include <stdlib.h>

#define EXAMPLE(name) TP_EXAMPLES "/" name

/* Check takes memory for every assertion; these take some only where they fail. */
#define EXPECT(condition, ...)                                                                     \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      failing_memory_state.fail_at = 0;                                                            \
      ck_abort_msg(__VA_ARGS__);                                                                   \
    }                                                                                              \
  } while (false)

/* A call succeeds, or says that memory ran out; with no output. */
static inline bool done(tp_status status, const void *output, const tp_message *message) {
  EXPECT(status == TP_OK || status == TP_OUT_OF_MEMORY, "status %d: %s", (int)status,
         message->text);
  EXPECT(status == TP_OK || message->text[0] != '\0', "no message");
  EXPECT((status == TP_OK) == (output != NULL), "status %d, but an output", (int)status);
  return status == TP_OK;
}

/* The call comes first, then its output is looked at; of a function that has a `message`. */
extern tp_status last_status;
#define DONE(call, output) (last_status = (call), done(last_status, output, &message))

/* Reports have no message but their status. */
static inline void expect_report(tp_status status, char *text) {
  static const tp_message own = {.text = "a report"};
  (void)done(status, text, &own);
  free(text);
}

#endif
